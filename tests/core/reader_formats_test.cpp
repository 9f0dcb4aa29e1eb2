// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <clocale>

#include "io/scan_io.h"
#include "support/hostile_lists.h"

namespace stratascope {
namespace {

using test::FormatUnderAttack;

Expected<std::vector<Scan>> readAll(const FormatUnderAttack& format, const std::string& bytes) {
  return readAllScanBytes("/nowhere/small" + format.extension, bytes);
}

bool warnsOfCut(const std::vector<Scan>& scans) {
  return std::any_of(scans.begin(), scans.end(), [](const Scan& scan) {
    return std::any_of(scan.notes.begin(), scan.notes.end(),
                       [](const std::string& note) { return note.find("cut off") != std::string::npos; });
  });
}

TEST(ReaderFormats, SmallFilesAreRead) {
  for (const FormatUnderAttack& format : test::formatsUnderAttack())
    for (const std::string& bytes : format.valid) {
      const auto scans = readAll(format, bytes);
      ASSERT_TRUE(scans) << format.name << ": " << scans.error().message();
      for (const Scan& scan : *scans) {
        EXPECT_LT(scan.lattice->missingCount(), scan.lattice->points().size());
        EXPECT_FALSE(scan.fields.empty());
        EXPECT_FALSE(warnsOfCut(*scans)) << format.name;
      }
    }
}

TEST(ReaderFormats, ContentWinsOverTheExtension) {
  for (const FormatUnderAttack& format : test::formatsUnderAttack()) {
    constexpr std::array kMarked = {"PCD", "PLY", "polar text", "scan graph", "LAS", "E57"};
    if (std::find(kMarked.begin(), kMarked.end(), format.name) == kMarked.end()) continue;
    const auto expected = readAll(format, format.valid[0]);
    for (const char* name : {"a.xyz", "b.3d", "c", "d.ptx"}) {
      const auto scans = readAllScanBytes(name, format.valid[0]);
      ASSERT_TRUE(scans) << format.name << " as " << name << ": " << scans.error().message();
      EXPECT_EQ(scans->front().format, expected->front().format);
    }
  }
}

// A last number may be cut short without a trace; then a note warns. Formats without a count hold just their
// whole rows.
TEST(ReaderFormats, EveryPrefixIsAnError) {
  for (const FormatUnderAttack& format : test::formatsUnderAttack()) {
    if (!format.counted) continue;
    for (const std::string& file : format.valid)
      test::forEveryPrefix(file, [&](size_t n, const std::string& prefix) {
        const auto scans = readAll(format, prefix);
        if (!scans) return;
        // PTX and PTS may end after each of their blocks
        const auto whole = readAll(format, file);
        if ((format.extension == ".ptx" || format.extension == ".pts") && n < file.size() - 8) {
          EXPECT_TRUE(scans->size() < whole->size() ||
                      scans->front().cloud.size() < whole->front().cloud.size())
              << format.name << " cut after " << n;
          return;
        }
        EXPECT_TRUE(warnsOfCut(*scans)) << format.name << " cut after " << n << " of " << file.size();
      });
  }
}

TEST(ReaderFormats, HostileFilesAreRefused) {
  for (const FormatUnderAttack& format : test::formatsUnderAttack()) {
    SCOPED_TRACE(format.name);
    EXPECT_GE(format.hostile.size(), 40u);
    test::expectAllRefused(format.extension, format.hostile);
  }
}

TEST(ReaderFormats, DamagedCopiesNeverBreakThem) {
  for (const FormatUnderAttack& format : test::formatsUnderAttack())
    for (const std::string& file : format.valid)
      EXPECT_GT(test::readDamagedCopies(format.extension, file, 3000, 11), 300) << format.name;
}

TEST(ReaderFormats, ForeignLocaleDoesNotMatter) {
  const std::string old = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
    GTEST_SKIP() << "skipped: no German locale";
  std::vector<std::vector<Eigen::Vector3f>> german;
  const auto readThem = [](std::vector<std::vector<Eigen::Vector3f>>& into) {
    for (const FormatUnderAttack& format : test::formatsUnderAttack())
      for (const std::string& file : format.valid) {
        const auto scans = readAll(format, file);
        into.emplace_back();
        if (!scans) continue;
        for (const Scan& scan : *scans)
          for (const Eigen::Vector3f& p : scan.lattice->points().values())
            if (p.allFinite()) into.back().push_back(p);
      }
  };
  readThem(german);
  std::setlocale(LC_ALL, old.c_str());
  std::vector<std::vector<Eigen::Vector3f>> plain;
  readThem(plain);
  EXPECT_EQ(german, plain);
  EXPECT_FALSE(plain.front().empty());
}

}  // namespace
}  // namespace stratascope
