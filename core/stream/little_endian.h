// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace stratascope {

using Bytes = std::vector<std::uint8_t>;

/// Appends numbers to telegrams, low byte first.
class ByteWriter {
public:
  explicit ByteWriter(Bytes& bytes) : bytes_(bytes) {}

  template <class T>
  requires(std::integral<T> || std::floating_point<T>) void put(T value) {
    if constexpr (std::is_same_v<T, double>) {
      put(std::bit_cast<std::uint64_t>(value));
    } else if constexpr (std::is_same_v<T, float>) {
      put(std::bit_cast<std::uint32_t>(value));
    } else {
      auto bits = static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<T>>(value));
      for (size_t i = 0; i < sizeof(T); ++i, bits >>= 8) bytes_.push_back(static_cast<std::uint8_t>(bits));
    }
  }

private:
  Bytes& bytes_;
};

/// Reads numbers from a telegram. Past the end it yields zeros and says so by ok().
class ByteReader {
public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <class T>
  requires(std::integral<T> || std::floating_point<T>) T get() {
    if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(get<std::uint64_t>());
    } else if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<float>(get<std::uint32_t>());
    } else {
      if (bytes_.size() - at_ < sizeof(T)) {
        ok_ = false;
        return 0;
      }
      std::uint64_t bits = 0;
      for (size_t i = 0; i < sizeof(T); ++i) bits |= std::uint64_t{bytes_[at_ + i]} << (8 * i);
      at_ += sizeof(T);
      return static_cast<T>(bits);
    }
  }

  size_t left() const { return bytes_.size() - at_; }
  /// Nothing was asked for that is not there.
  bool ok() const { return ok_; }

private:
  std::span<const std::uint8_t> bytes_;
  size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace stratascope
