// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/expected.h"

namespace stratascope {

/// A JSON text, keys in their order. Stricter than JSON: no key twice in an object, at most 64 levels, at
/// most 4096 keys an object; so that nothing is lost in silence and no text can exhaust stack or time. Errors
/// name `file` and the place.
Expected<nlohmann::ordered_json> parseStrictJson(std::string_view text, const std::string& file);

/// One line; bytes that are no UTF-8 are replaced.
std::string jsonLine(const nlohmann::ordered_json& json);

}  // namespace stratascope
