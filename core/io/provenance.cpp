// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/provenance.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

std::string asciiText(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Provenance linesOf(const Json& document, size_t first, size_t end) {
  Provenance lines{"stratascope " + document["version"].get<std::string>()};
  const Json& inputs = document["inputs"];
  for (size_t i = first; i < std::min(end, inputs.size()); ++i)
    lines.push_back("input " + asciiText(inputs[i]["name"]) + " sha256 " + asciiText(inputs[i]["sha256"]));
  // All inputs share one.
  if (!inputs.empty() && inputs[0].contains("local_origin")) {
    const Json& origin = inputs[0]["local_origin"];
    const auto isFar = [](const Json& v) { return v.is_number() && v != 0; };
    if (origin.is_array() && std::any_of(origin.begin(), origin.end(), isFar))
      lines.push_back("map coordinates are counted from " + asciiText(origin) + " m in the inputs' frame");
  }
  lines.push_back("parameters " + asciiText(document["parameters"]));
  return lines;
}

}  // namespace

Provenance provenanceOf(const std::string& document) {
  return linesOf(Json::parse(document), 0, static_cast<size_t>(-1));
}

Provenance provenanceOf(const std::string& document, size_t input) {
  return linesOf(Json::parse(document), input, input + 1);
}

std::string commentLines(const Provenance& provenance, const std::string& before) {
  std::string text;
  for (const std::string& line : provenance) {
    text += before;
    for (const char c : line) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    text += '\n';
  }
  return text;
}

}  // namespace stratascope
