// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Parameters as text: options, JSON, files.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "params/param_table.h"

namespace stratascope {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 1u << 20;

std::string shortened(std::string_view text) {
  constexpr size_t kLongest = 60;
  return text.size() <= kLongest ? std::string(text) : std::string(text.substr(0, kLongest)) + "…";
}

std::string expectation(const ParamInfo& info) {
  std::string text;
  switch (info.kind) {
    case ParamKind::Flag:
      return "give true or false";
    case ParamKind::Choice:
      text = "give one of";
      for (size_t i = 0; i < info.choices.size(); ++i) text += std::string(i ? ", " : " ") + info.choices[i];
      return text;
    case ParamKind::Integer:
      text = "give a whole number from ";
      break;
    case ParamKind::Real:
      text = "give a number from ";
      break;
  }
  text += paramNumberText(info.minimum) + " to " + paramNumberText(info.maximum);
  return *info.unit ? text + " " + info.unit : text;
}

Error badValue(const ParamInfo& info, std::string_view text) {
  return Error{"", info.key, "'" + shortened(text) + "' cannot be used here", expectation(info)};
}

Error unknownKey(std::string_view key) {
  return Error{"", shortened(key), "there is no such parameter",
               std::string("did you mean ") + nearestParamKey(key) + "?"};
}

/// The whole of `text`, or nothing.
template <class Number>
bool readNumber(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// A JSON value as the text setParam reads; empty where the type is not the parameter's.
std::string jsonValueText(const ParamInfo& info, const nlohmann::json& value) {
  switch (info.kind) {
    case ParamKind::Flag:
      return value.is_boolean() ? (value.get<bool>() ? "true" : "false") : "";
    case ParamKind::Choice:
      return value.is_string() ? value.get<std::string>() : "";
    case ParamKind::Integer:
      return value.is_number_integer() ? value.dump() : "";
    case ParamKind::Real:
      return value.is_number() ? paramNumberText(value.get<double>()) : "";
  }
  return "";
}

}  // namespace

std::string paramNumberText(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : std::string();
}

std::string paramText(const ParamInfo& info, const PipelineParams& params) {
  const double value = info.get(params);
  switch (info.kind) {
    case ParamKind::Flag:
      return value != 0 ? "true" : "false";
    case ParamKind::Choice:
      require(value >= 0 && value < static_cast<double>(info.choices.size()),
              "paramText: choice out of range");
      return info.choices[static_cast<size_t>(value)];
    case ParamKind::Integer:
      return std::to_string(std::llround(value));
    case ParamKind::Real:
      return paramNumberText(value);
  }
  return "";
}

Status setParam(PipelineParams& params, std::string_view key, std::string_view text) {
  const ParamInfo* info = findParam(key);
  if (!info) return unknownKey(key);
  switch (info->kind) {
    case ParamKind::Flag:
      if (text != "true" && text != "false") return badValue(*info, text);
      info->set(params, text == "true" ? 1 : 0);
      return success();
    case ParamKind::Choice:
      for (size_t i = 0; i < info->choices.size(); ++i) {
        if (text != info->choices[i]) continue;
        info->set(params, static_cast<double>(i));
        return success();
      }
      return badValue(*info, text);
    case ParamKind::Integer: {
      int value = 0;
      if (!readNumber(text, value)) return badValue(*info, text);
      info->set(params, value);
      return success();
    }
    case ParamKind::Real: {
      double value = 0;
      if (!readNumber(text, value) || !std::isfinite(value)) return badValue(*info, text);
      info->set(params, value);
      return success();
    }
  }
  return success();
}

std::string paramsToJson(const PipelineParams& params) {
  std::string json = "{";
  for (const ParamInfo& info : paramTable()) {
    if (json.size() > 1) json += ", ";
    const std::string text = paramText(info, params);
    json +=
        std::string("\"") + info.key + "\": " + (info.kind == ParamKind::Choice ? "\"" + text + "\"" : text);
  }
  return json + "}";
}

Expected<PipelineParams> paramsFromJson(std::string_view json, const std::string& file,
                                        const PipelineParams& base) {
  // A key given twice would let the last one win in silence.
  std::set<std::string> seen;
  std::string repeated;
  const auto watchKeys = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& key) {
    if (event == nlohmann::json::parse_event_t::key && depth == 1) {
      auto name = key.get<std::string>();
      std::replace(name.begin(), name.end(), '-', '_');
      if (!seen.insert(name).second && repeated.empty()) repeated = name;
    }
    return true;
  };
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(json.begin(), json.end(), watchKeys);
  } catch (const nlohmann::json::parse_error& error) {
    return Error{file, "byte " + std::to_string(error.byte), "not valid JSON",
                 "the file must be one object such as {\"epsilon\": 0.1}"};
  } catch (const nlohmann::json::out_of_range&) {
    return Error{file, "", "a number is too large for JSON", "give numbers within their ranges"};
  }
  if (!document.is_object())
    return Error{file, "", "not a JSON object", "the file must be one object such as {\"epsilon\": 0.1}"};
  if (!repeated.empty()) return Error{file, "key " + shortened(repeated), "given twice", "keep one of them"};

  PipelineParams params = base;
  for (const auto& [key, value] : document.items()) {
    const ParamInfo* info = findParam(key);
    Error error;
    if (!info) {
      error = unknownKey(key);
    } else {
      const std::string text = jsonValueText(*info, value);
      const Status status =
          text.empty()
              ? Status(badValue(*info, value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)))
              : setParam(params, key, text);
      if (status) continue;
      error = status.error();
    }
    error.file = file;
    error.where = "key " + error.where;
    return error;
  }
  std::string problems;
  for (const std::string& problem : params.validate()) problems += (problems.empty() ? "" : "; ") + problem;
  if (!problems.empty()) return Error{file, "", problems, ""};
  return params;
}

Expected<PipelineParams> loadParams(const std::string& path, const PipelineParams& base) {
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) return Error{path, "", "there is no such file", ""};
  if (!fs::is_regular_file(status))
    return Error{path, "", "not a regular file", "give a JSON file of parameters"};
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) return Error{path, "", code.message(), ""};
  if (size > kMaxFileBytes)
    return Error{path, "", "too large for a file of parameters", "give a file below 1 MiB"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Error{path, "", "cannot be read", "check its permissions"};
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return paramsFromJson(bytes, path, base);
}

std::string paramsAsOptions(const PipelineParams& params) {
  const PipelineParams defaults;
  std::string options;
  for (const ParamInfo& info : paramTable()) {
    if (info.get(params) == info.get(defaults)) continue;
    if (!options.empty()) options += ' ';
    options += "--";
    for (const char* c = info.key; *c; ++c) options += *c == '_' ? '-' : *c;
    const std::string text = paramText(info, params);
    // Flags stand alone or carry their value behind '=', so that they never swallow a file name.
    if (info.kind == ParamKind::Flag)
      options += text == "true" ? "" : "=" + text;
    else
      options += " " + text;
  }
  return options;
}

}  // namespace stratascope
