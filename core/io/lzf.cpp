// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/lzf.h"

namespace stratascope {

namespace {
/// The best a stream can do: three bytes stand for a repetition of 2 + 7 + 255.
constexpr std::uint64_t kMaxExpansion = 264 / 3;
constexpr const char* kRemedy = "save the file again, or as plain binary";
}  // namespace

Expected<std::string> lzfUnpack(std::string_view packed, std::uint64_t size, std::uint64_t firstByte) {
  size_t in = 0;
  const auto fail = [&](const char* what) {
    return Error{"", "byte " + std::to_string(firstByte + in), what, kRemedy};
  };
  if (size / kMaxExpansion > packed.size())
    return fail("the compressed data are too short for what they should unpack to");

  std::string out;
  out.reserve(size);
  while (in < packed.size()) {
    const auto control = static_cast<unsigned char>(packed[in]);
    if (control < 32) {  // a run of literal bytes
      const size_t length = control + size_t{1};
      if (packed.size() - in - 1 < length) return fail("the compressed data end inside a run");
      if (size - out.size() < length) return fail("the compressed data unpack to more than they should");
      out.append(packed.substr(in + 1, length));
      in += 1 + length;
      continue;
    }
    size_t length = control >> 5;  // a repetition of what came before
    const size_t bytes = length == 7 ? 3 : 2;
    if (packed.size() - in < bytes) return fail("the compressed data end inside a repetition");
    if (length == 7) length += static_cast<unsigned char>(packed[in + 1]);
    length += 2;
    const size_t distance =
        ((control & size_t{31}) << 8) + static_cast<unsigned char>(packed[in + bytes - 1]) + 1;
    if (distance > out.size()) return fail("the compressed data repeat something before their start");
    if (size - out.size() < length) return fail("the compressed data unpack to more than they should");
    // byte by byte: source and target may overlap, that is how runs are written
    for (size_t from = out.size() - distance; length > 0; --length, ++from) out.push_back(out[from]);
    in += bytes;
  }
  if (out.size() != size) return fail("the compressed data unpack to less than they should");
  return out;
}

}  // namespace stratascope
