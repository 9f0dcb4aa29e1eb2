// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "io/text_lines.h"

namespace stratascope {

namespace {

constexpr size_t kMaxHeaderBytes = size_t{64} << 10;
constexpr size_t kMaxProperties = 256;

std::optional<PlyType> typeFromText(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{{"char", PlyType::Int8},
                                                                            {"int8", PlyType::Int8},
                                                                            {"uchar", PlyType::Uint8},
                                                                            {"uint8", PlyType::Uint8},
                                                                            {"short", PlyType::Int16},
                                                                            {"int16", PlyType::Int16},
                                                                            {"ushort", PlyType::Uint16},
                                                                            {"uint16", PlyType::Uint16},
                                                                            {"int", PlyType::Int32},
                                                                            {"int32", PlyType::Int32},
                                                                            {"uint", PlyType::Uint32},
                                                                            {"uint32", PlyType::Uint32},
                                                                            {"float", PlyType::Float},
                                                                            {"float32", PlyType::Float},
                                                                            {"double", PlyType::Double},
                                                                            {"float64", PlyType::Double}}};
  for (const auto& [text, type] : kTypes)
    if (name == text) return type;
  return std::nullopt;
}

std::vector<std::string_view> tokensOf(std::string_view line) {
  std::vector<std::string_view> tokens;
  for (std::string_view token = takeToken(line); !token.empty(); token = takeToken(line))
    tokens.push_back(token);
  return tokens;
}

/// Reads the header's lines one by one; what is wrong with one comes back as text, empty if nothing is.
class HeaderParser {
public:
  std::string take(const std::vector<std::string_view>& tokens) {
    const std::string_view keyword = tokens[0];
    if (keyword == "comment") return {};
    if (keyword == "obj_info") return takeInfo(tokens);
    if (keyword == "format") return takeFormat(tokens);
    if (!hasFormat_) return "the line 'format …' must come first";
    if (keyword == "element") return takeElement(tokens);
    if (keyword == "property") return takeProperty(tokens);
    return "unknown header keyword " + quotedText(keyword);
  }
  bool hasFormat() const { return hasFormat_; }
  /// PCL announces no faces, without saying what they would be made of.
  std::string unfinishedElement() const {
    if (header.elements.empty() || !header.elements.back().properties.empty() ||
        header.elements.back().count == 0)
      return {};
    return "element " + quotedText(header.elements.back().name) + " has no property";
  }
  PlyHeader header;

private:
  std::string takeFormat(const std::vector<std::string_view>& tokens) {
    if (hasFormat_) return "format is there twice";
    if (tokens.size() != 3 || tokens[2] != "1.0") return "not 'format ENCODING 1.0'";
    if (tokens[1] == "ascii")
      header.encoding = PlyEncoding::Ascii;
    else if (tokens[1] == "binary_little_endian")
      header.encoding = PlyEncoding::BinaryLittleEndian;
    else if (tokens[1] == "binary_big_endian")
      header.encoding = PlyEncoding::BinaryBigEndian;
    else
      return "encoding " + quotedText(tokens[1]) + " is not ascii, binary_little_endian or binary_big_endian";
    hasFormat_ = true;
    return {};
  }

  /// num_cols and num_rows make a range grid; any other remark is free text.
  std::string takeInfo(const std::vector<std::string_view>& tokens) {
    if (tokens.size() < 2 || (tokens[1] != "num_cols" && tokens[1] != "num_rows")) return {};
    std::uint64_t& size = tokens[1] == "num_cols" ? header.columns : header.rows;
    if (size != 0) return std::string(tokens[1]) + " is there twice";
    const auto value = tokens.size() == 3 ? countFromText(tokens[2]) : std::nullopt;
    if (!value || *value < 1 || *value > std::numeric_limits<std::int32_t>::max())
      return std::string(tokens[1]) + " is not one whole number from 1 to 2147483647";
    size = *value;
    return {};
  }

  std::string takeElement(const std::vector<std::string_view>& tokens) {
    if (std::string problem = unfinishedElement(); !problem.empty()) return problem;
    const auto count = tokens.size() == 3 ? countFromText(tokens[2]) : std::nullopt;
    if (!count || *count > std::numeric_limits<std::int32_t>::max())
      return "not 'element NAME COUNT' with a count up to 2147483647";
    for (const PlyElement& element : header.elements)
      if (element.name == tokens[1]) return "element " + quotedText(tokens[1]) + " is there twice";
    header.elements.push_back({std::string(tokens[1]), *count, {}});
    return {};
  }

  std::string takeProperty(const std::vector<std::string_view>& tokens) {
    if (header.elements.empty()) return "a property before any element";
    if (++properties_ > kMaxProperties) return "more than 256 properties";
    const bool list = tokens.size() == 5 && tokens[1] == "list";
    if (!list && tokens.size() != 3) return "not 'property TYPE NAME' or 'property list TYPE TYPE NAME'";
    PlyProperty property;
    property.name = tokens.back();
    const std::string_view typeName = tokens[tokens.size() - 2];
    const auto type = typeFromText(typeName);
    if (!type) return "type " + quotedText(typeName) + " is not one PLY has";
    property.type = *type;
    if (list) {
      property.countType = typeFromText(tokens[2]);
      if (!property.countType || isPlyReal(*property.countType))
        return "a list is counted by " + quotedText(tokens[2]) + ", not by a whole number";
    }
    PlyElement& element = header.elements.back();
    if (element.find(property.name)) return "property " + quotedText(property.name) + " is there twice";
    element.properties.push_back(std::move(property));
    return {};
  }

  bool hasFormat_ = false;
  size_t properties_ = 0;
};

}  // namespace

unsigned plyTypeBytes(PlyType type) {
  constexpr std::array<unsigned, 8> kBytes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<size_t>(type)];
}

bool PlyElement::hasLists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.countType.has_value(); });
}

std::uint64_t PlyElement::rowBytes() const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += plyTypeBytes(property.type);
  return bytes;
}

std::optional<size_t> PlyElement::find(std::string_view property) const {
  for (size_t p = 0; p < properties.size(); ++p)
    if (properties[p].name == property) return p;
  return std::nullopt;
}

bool looksLikePly(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n");
}

Expected<PlyHeader> parsePlyHeader(const std::string& path, std::string_view bytes) {
  const char* const remedy = "correct the header, or save the file again";
  HeaderParser parser;
  TextLines lines(bytes.substr(0, kMaxHeaderBytes));
  if (!lines.next() || lines.line() != "ply")
    return Error{path, "line 1", "the first line is not 'ply'", "is this a PLY file? Save it again if it is"};
  while (lines.next()) {
    if (!lines.hasLineEnd()) break;
    const auto tokens = tokensOf(lines.line());
    if (tokens.empty()) continue;
    if (tokens[0] != "end_header") {
      if (std::string problem = parser.take(tokens); !problem.empty())
        return Error{path, lines.where(), problem, remedy};
      continue;
    }
    if (!parser.hasFormat()) return Error{path, "header", "there is no line 'format …'", remedy};
    PlyHeader& header = parser.header;
    if (std::string problem = parser.unfinishedElement(); !problem.empty())
      return Error{path, lines.where(), problem, remedy};
    if ((header.columns == 0) != (header.rows == 0))
      return Error{path, "header", "only one of obj_info num_cols and num_rows", remedy};
    header.bodyOffset = static_cast<std::uint64_t>(lines.rest().data() - bytes.data());
    header.bodyLine = lines.number() + 1;
    return std::move(header);
  }
  if (bytes.size() > kMaxHeaderBytes)
    return Error{path, "header", "no end_header within the first 64 KiB",
                 "is this a PLY file? Save it again if it is"};
  return Error{path, lines.where(), "the file ends inside its header",
               "it is cut off: copy or save it again"};
}

}  // namespace stratascope
