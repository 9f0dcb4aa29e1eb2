// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/expected.h"

namespace stratascope {

/// Reads the members of one JSON object strictly. Keeps the first error with its place ("items[3].size");
/// after an error the values returned are stand-ins, so a reader runs to its end and looks at the error once.
class JsonFields {
public:
  using Json = nlohmann::json;

  /// `keys`: all that may stand here.
  JsonFields(const Json& json, std::string place, std::initializer_list<const char*> keys,
             std::optional<Error>& error)
      : json_(json), place_(std::move(place)), error_(error) {
    if (!json.is_object()) {
      fail("", "must be an object { … }");
      return;
    }
    for (const auto& [key, value] : json.items()) {
      if (std::any_of(keys.begin(), keys.end(), [&](const char* known) { return key == known; })) continue;
      std::string known;
      for (const char* name : keys) known += (known.empty() ? "" : ", ") + std::string(name);
      fail("", "unknown key \"" + key.substr(0, 40) + "\"", "known here: " + known);
    }
  }

  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  const Json& at(const char* key) const {
    static const Json nothing;
    return has(key) ? json_.at(key) : nothing;
  }
  std::string placeOf(const std::string& key) const {
    return key.empty() ? place_ : place_.empty() ? key : place_ + "." + key;
  }

  double number(const char* key, double low, double high, std::optional<double> fallback = {}) {
    if (!present(key, fallback.has_value())) return fallback.value_or(low);
    return inRange(at(key), key, low, high);
  }
  /// Greater than zero.
  double length(const char* key) {
    if (!present(key, false)) return 1;
    return positive(at(key), key);
  }
  int integer(const char* key, int low, int high, std::optional<int> fallback = {}) {
    if (!present(key, fallback.has_value())) return fallback.value_or(low);
    const Json& value = at(key);
    if (!value.is_number_integer()) return fail(key, "must be a whole number"), low;
    return static_cast<int>(inRange(value, key, low, high));
  }
  bool flag(const char* key, bool fallback) {
    if (!has(key)) return fallback;
    if (!at(key).is_boolean()) return fail(key, "must be true or false"), fallback;
    return at(key).get<bool>();
  }
  std::string text(const char* key, std::optional<std::string> fallback = {}) {
    if (!present(key, fallback.has_value())) return fallback.value_or("");
    if (!at(key).is_string()) return fail(key, "must be a text in quotes"), std::string();
    return at(key).get<std::string>();
  }
  Eigen::Vector3d vector(const char* key, double bound, std::optional<Eigen::Vector3d> fallback = {}) {
    Eigen::Vector3d result = fallback.value_or(Eigen::Vector3d::Zero());
    if (!present(key, fallback.has_value()) || !isTriple(key)) return result;
    for (int i = 0; i < 3; ++i)
      result[i] = inRange(at(key)[static_cast<size_t>(i)], element(key, i), -bound, bound);
    return result;
  }
  /// Three lengths greater than zero.
  Eigen::Vector3d size(const char* key) {
    Eigen::Vector3d result = Eigen::Vector3d::Ones();
    if (!present(key, false) || !isTriple(key)) return result;
    for (int i = 0; i < 3; ++i) result[i] = positive(at(key)[static_cast<size_t>(i)], element(key, i));
    return result;
  }
  /// The elements of a list, or none (after an error).
  const Json::array_t& list(const char* key, bool optional = false) {
    static const Json::array_t none;
    if (!present(key, optional)) return none;
    if (!at(key).is_array()) return fail(key, "must be a list [ … ]"), none;
    return at(key).get_ref<const Json::array_t&>();
  }

  void fail(const std::string& key, std::string what, std::string remedy = {}) {
    if (!error_) error_ = Error{{}, placeOf(key), std::move(what), std::move(remedy)};
  }
  static std::string element(const std::string& key, int index) {
    return key + "[" + std::to_string(index) + "]";
  }

private:
  static constexpr double kLargestLength = 1e5;

  bool present(const char* key, bool optional) {
    if (!has(key) && !optional && json_.is_object()) fail("", "\"" + std::string(key) + "\" is missing");
    return has(key);
  }
  bool isTriple(const char* key) {
    if (at(key).is_array() && at(key).size() == 3) return true;
    fail(key, "must be three numbers [x, y, z]");
    return false;
  }
  double inRange(const Json& value, const std::string& key, double low, double high) {
    if (!value.is_number()) return fail(key, "must be a number"), low;
    const double number = value.get<double>();
    if (number >= low && number <= high) return number;
    fail(key, "must be from " + Json(low).dump() + " to " + Json(high).dump());
    return low;
  }
  double positive(const Json& value, const std::string& key) {
    if (!value.is_number()) return fail(key, "must be a number"), 1;
    const double number = value.get<double>();
    if (number > 0 && number <= kLargestLength) return number;
    fail(key, "must be greater than 0 and at most 100000 metres");
    return 1;
  }

  const Json& json_;
  std::string place_;
  std::optional<Error>& error_;
};

}  // namespace stratascope
