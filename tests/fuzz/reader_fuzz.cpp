// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads any bytes as a file of one format, through to the finished scan. An error is as good as a scan; a
// crash, a hang or a scan that is not whole is a finding.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/scan_io.h"
#include "support/small_files.h"

namespace {

constexpr std::string_view kFormat = STRATASCOPE_FUZZ_FORMAT;

/// Changed bytes would never pass the pages' checksums, so these are made right, and the header's offsets
/// with them.
std::string fileOf(std::string bytes) {
  if (kFormat != "e57" || bytes.size() < 48) return bytes;
  const size_t xml = std::min(bytes.find("<?xml"), bytes.size());
  const size_t length = bytes.find_last_of('>') == std::string::npos || bytes.find_last_of('>') < xml
                            ? bytes.size() - xml
                            : bytes.find_last_of('>') + 1 - xml;
  return stratascope::test::e57FromLogical(std::move(bytes), xml, length);
}

void check(bool whole) {
  if (!whole) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  const std::string path = std::string("fuzz.") + (kFormat == "graph" ? "txt" : std::string(kFormat));
  const auto scans =
      stratascope::readAllScanBytes(path, fileOf(std::string(reinterpret_cast<const char*>(data), size)));
  if (!scans) {
    check(scans.error().file == path && !scans.error().what.empty());
    return 0;
  }
  check(!scans->empty());
  for (const stratascope::Scan& scan : *scans) {
    check(scan.lattice && scan.lattice->missingCount() < scan.lattice->points().size());
    check(scan.unordered() == !scan.cloud.empty());
    size_t missing = 0;
    for (const Eigen::Vector3f& p : scan.lattice->points().values()) {
      check(p.allFinite() || p.array().isNaN().all());
      missing += !p.allFinite();
    }
    check(missing == scan.lattice->missingCount());
  }
  return 0;
}
