// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/strict_json.h"

#include <set>
#include <vector>

#include "io/text_lines.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 64;
constexpr size_t kMaxKeys = 4096;

/// Leaves the parser, which knows no other way.
struct Refused {
  std::string where, what;
};

}  // namespace

Expected<Json> parseStrictJson(std::string_view text, const std::string& file) {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto watch = [&](int depth, Json::parse_event_t event, Json& value) {
    switch (event) {
      case Json::parse_event_t::object_start:
        keys.emplace_back();
        [[fallthrough]];
      case Json::parse_event_t::array_start:
        if (depth >= kMaxDepth)
          throw Refused{"", "lists and objects are nested more than " + std::to_string(kMaxDepth) + " deep"};
        break;
      case Json::parse_event_t::object_end:
        keys.pop_back();
        break;
      case Json::parse_event_t::key: {
        const auto key = value.get<std::string>();
        if (!keys.back().insert(key).second) throw Refused{"key " + quotedText(key), "given twice"};
        if (keys.back().size() > kMaxKeys)
          throw Refused{"", "an object has more than " + std::to_string(kMaxKeys) + " keys"};
        break;
      }
      default:
        break;
    }
    return true;
  };
  constexpr const char* kRemedy = "restore the file, or make it again";
  // the parser takes a NUL for the end and skips a byte-order mark
  if (const size_t at = text.find('\0'); at != std::string_view::npos)
    return Error{file, "byte " + std::to_string(at), "a NUL byte", kRemedy};
  if (text.starts_with("\xEF\xBB\xBF"))
    return Error{file, "byte 0", "the file begins with a byte-order mark", "save it as plain text"};
  try {
    return Json::parse(text.begin(), text.end(), watch);
  } catch (const Refused& refused) {
    return Error{file, refused.where, refused.what, kRemedy};
  } catch (const Json::parse_error& error) {
    return Error{file, "byte " + std::to_string(error.byte), "not valid JSON", kRemedy};
  } catch (const Json::out_of_range&) {
    return Error{file, "", "a number is too large for JSON", kRemedy};
  }
}

std::string jsonLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace stratascope
