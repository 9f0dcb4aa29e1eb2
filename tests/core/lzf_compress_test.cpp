// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/lzf_compress.h"

#include <gtest/gtest.h>

#include <random>

namespace stratascope {
namespace {

// The format's description, followed byte by byte; every broken rule is reported by throwing.
std::string unpack(const std::string& packed) {
  std::string out;
  size_t at = 0;
  auto next = [&] { return static_cast<size_t>(static_cast<unsigned char>(packed.at(at++))); };
  while (at < packed.size()) {
    const size_t control = next();
    if (control < 32) {
      for (size_t i = 0; i <= control; ++i) out.push_back(static_cast<char>(next()));
      continue;
    }
    size_t length = control >> 5;
    if (length == 7) length += next();
    const size_t back = ((control & 31) << 8 | next()) + 1;
    for (size_t i = 0; i < length + 2; ++i) out.push_back(out.at(out.size() - back));
  }
  return out;
}

TEST(LzfCompress, RoundTripOfManyKindsOfBytes) {
  std::mt19937 random(1);
  for (int alphabet : {1, 2, 3, 17, 256}) {
    for (size_t size :
         {0, 1, 2, 3, 4, 31, 32, 33, 64, 65, 263, 264, 265, 266, 1000, 8192, 8193, 8200, 70000}) {
      std::string bytes(size, '\0');
      for (char& c : bytes) c = static_cast<char>(random() % static_cast<unsigned>(alphabet));
      ASSERT_EQ(unpack(lzfCompress(bytes)), bytes) << "alphabet " << alphabet << ", size " << size;
    }
  }
}

TEST(LzfCompress, CopiesFromAsFarBackAsTheFormatReachesAndNoFarther) {
  for (size_t gap = 8185; gap < 8200; ++gap) {
    std::mt19937 random(2);
    std::string bytes = "a phrase that comes again";
    while (bytes.size() < gap) bytes.push_back(static_cast<char>(128 + random() % 128));
    bytes += "a phrase that comes again";
    ASSERT_EQ(unpack(lzfCompress(bytes)), bytes) << gap;
  }
}

TEST(LzfCompress, RepetitionShrinksAndNoiseGrowsByOneIn32AtMost) {
  EXPECT_LT(lzfCompress(std::string(26400, 'x')).size(), 400u);
  std::mt19937 random(3);
  std::string noise(32000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  EXPECT_LE(lzfCompress(noise).size(), 33000u);
}

}  // namespace
}  // namespace stratascope
