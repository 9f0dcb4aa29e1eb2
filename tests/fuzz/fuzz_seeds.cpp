// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// fuzz_seeds DIR: writes the small valid files each fuzzing program starts from, DIR/FORMAT/N.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "io/e57_pages.h"
#include "stream/head_telegram.h"
#include "support/hostile_lists.h"

namespace {

/// Payloads of a scan of two lines of four beams, each behind its length and whose it is (see telegram_fuzz).
std::string telegrams(stratascope::RayKind rays) {
  using namespace stratascope;
  std::string bytes(1, '\1');
  const auto add = [&](bool scanner, const Bytes& payload) {
    const size_t length = payload.size() - 1;
    bytes += static_cast<char>(length & 0xFF);
    bytes += static_cast<char>(length >> 8 | (scanner ? 4 : 0));
    bytes.append(payload.begin(), payload.end());
  };
  HeadScanStart start;
  start.header.number = 7;
  start.header.lines = 2;
  start.header.beams = 4;
  start.header.name = "seed";
  start.rays = rays;
  add(false, headPayload(start));
  for (std::uint32_t line = 0; line < 2; ++line) {
    add(false, headPayload(HeadLine{7, line, 5.0 * line, 0}));
    RangeTelegram ranges;
    ranges.values = {1000, 2000, 8183, 3000};
    ranges.indices = {static_cast<std::uint8_t>(line), static_cast<std::uint8_t>(line)};
    add(true, rangePayload(ranges));
    if (rays == RayKind::Rays)
      add(false, headPayload(HeadRays{7, line, 0, std::vector<Eigen::Vector3f>(4, {1, 0.5f, 0.25f})}));
  }
  add(false, headPayload(HeadScanEnd{7}));
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds DIR\n";
    return 2;
  }
  namespace fs = std::filesystem;
  for (const auto& format : stratascope::test::formatsUnderAttack()) {
    const fs::path folder =
        fs::path(argv[1]) / (format.name == "scan graph" ? "graph" : format.extension.substr(1));
    fs::create_directories(folder);
    for (size_t i = 0; i < format.valid.size(); ++i) {
      std::string bytes = format.valid[i];
      if (format.extension == ".e57") {  // the fuzzing program adds the pages' checksums itself
        bytes = stratascope::openE57Pages("seed", bytes)->bytes;
        bytes.resize(bytes.find_last_of('>') + 1);
      }
      std::ofstream(folder / std::to_string(i), std::ios::binary) << bytes;
    }
  }
  const fs::path folder = fs::path(argv[1]) / "telegram";
  fs::create_directories(folder);
  for (const auto rays : {stratascope::RayKind::Head, stratascope::RayKind::Rays})
    std::ofstream(folder / std::to_string(static_cast<int>(rays)), std::ios::binary) << telegrams(rays);
  return 0;
}
