// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace stratascope {

/// What is wrong with an input, said so that a person can mend it. Bad input is reported by value; bad calls
/// throw.
struct Error {
  std::string file;    ///< file name as the caller gave it; empty if no file is involved
  std::string where;   ///< "line 12", "byte 4096", "field x"; empty if the whole file is meant
  std::string what;    ///< what is wrong, without a full stop
  std::string remedy;  ///< what to do about it; may be empty

  /// One line: "FILE: WHERE: WHAT; REMEDY". Control characters from the input are replaced by '?'.
  std::string message() const;
};

/// A value or the Error that stands in its place.
template <class T>
class [[nodiscard]] Expected {
public:
  Expected(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit by design
  Expected(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  bool hasValue() const { return state_.index() == 0; }
  explicit operator bool() const { return hasValue(); }

  /// Throws std::logic_error if there is no value: asking is a bad call, not bad input.
  T& value() & { return need(), std::get<0>(state_); }
  const T& value() const& { return need(), std::get<0>(state_); }
  T&& value() && { return need(), std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    if (hasValue()) throw std::logic_error("Expected::error() of a value");
    return std::get<1>(state_);
  }

private:
  void need() const {
    if (!hasValue())
      throw std::logic_error("Expected::value() of an error: " + std::get<1>(state_).message());
  }
  std::variant<T, Error> state_;
};

using Status = Expected<std::monostate>;
inline Status success() {
  return std::monostate{};
}

/// A bad call: throws std::logic_error in every build.
inline void require(bool condition, const char* message) {
  if (!condition) throw std::logic_error(message);
}

}  // namespace stratascope
