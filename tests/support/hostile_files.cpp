// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/hostile_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <random>

#include "io/scan_io.h"

namespace stratascope::test {

namespace {
long peakKiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}
}  // namespace

void expectAllRefused(const std::string& extension, const std::vector<HostileFile>& files) {
  const std::string path = "/nowhere/hostile" + extension;
  const long before = peakKiB();
  for (const HostileFile& file : files) {
    const auto scan = readScanBytes(path, file.bytes);
    EXPECT_FALSE(scan) << "accepted: " << file.name;
    if (scan) continue;
    const std::string message = scan.error().message();
    EXPECT_EQ(message.find('\n'), std::string::npos) << file.name;
    EXPECT_EQ(message.rfind(path, 0), 0u) << file.name << ": " << message;
    EXPECT_LT(message.size(), 400u) << file.name << ": " << message;
    EXPECT_FALSE(scan.error().remedy.empty()) << file.name << ": " << message;
  }
  EXPECT_LT(peakKiB() - before, 256L << 10) << "memory not bounded by the files' size";
}

int readDamagedCopies(const std::string& extension, const std::string& valid, int copies,
                      std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  int refused = 0;
  for (int copy = 0; copy < copies; ++copy) {
    std::string bytes = valid;
    for (size_t change = 1 + below(4); change > 0 && !bytes.empty(); --change) {
      const size_t at = below(bytes.size());
      switch (below(5)) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = "0123456789 .-\n"[below(14)];
          break;
        case 2:
          bytes.erase(at, 1 + below(8));
          break;
        case 3:
          bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(16)));
          break;
        default:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      }
    }
    const auto scan = readScanBytes("/nowhere/damaged" + extension, bytes);
    refused += !scan;
    if (!scan) continue;
    EXPECT_NE(scan->lattice, nullptr);
    EXPECT_LT(scan->lattice->missingCount(), scan->lattice->points().size()) << "a scan without a point";
    EXPECT_EQ(scan->unordered(), !scan->cloud.empty());
  }
  return refused;
}

}  // namespace stratascope::test
