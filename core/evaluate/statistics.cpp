// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

#include "base/expected.h"
#include "base/stopwatch.h"
#include "base/units.h"

namespace stratascope {
namespace {

/// Some ten milliseconds of work that no memory and no other thread can hold up.
std::uint64_t arithmetic() {
  std::uint64_t x = 88172645463325252U;
  for (int i = 0; i < 8'000'000; ++i) {
    x ^= x << 13;
    x ^= x >> 7;
    x ^= x << 17;
  }
  return x;
}

double secondsOf(int threads) {
  std::atomic<std::uint64_t> keep{0};  // so that no compiler leaves the work out
  std::vector<std::jthread> others;
  const Stopwatch watch;
  for (int i = 1; i < threads; ++i) others.emplace_back([&keep] { keep += arithmetic(); });
  keep += arithmetic();
  others.clear();  // joins
  return watch.seconds();
}

/// "VmHWM:   1234 kB" → bytes
std::size_t bytesOf(const std::string& line) {
  const auto digits = line.find_first_of("0123456789");
  std::size_t kib = 0;
  if (digits != std::string::npos) std::from_chars(line.data() + digits, line.data() + line.size(), kib);
  return kib * 1024;
}

}  // namespace

double medianOf(std::vector<double> values) {
  if (values.empty()) return kNaN;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double busyThreadGain(int threads) {
  require(threads > 0, "busyThreadGain: no threads");
  std::vector<double> gains;
  for (int round = 0; round < 5; ++round) {
    const double alone = secondsOf(1);
    gains.push_back(threads * alone / secondsOf(threads));
  }
  return medianOf(gains);
}

ResidentMemory residentMemory() {
  ResidentMemory memory;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) memory.peak = bytesOf(line);
    if (line.starts_with("VmRSS:")) memory.now = bytesOf(line);
  }
  return memory;
}

}  // namespace stratascope
