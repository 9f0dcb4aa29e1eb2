// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "io/text_lines.h"

namespace stratascope {

namespace {

constexpr size_t kMaxHeaderBytes = size_t{64} << 10;
constexpr std::array kKeywords = {"VERSION", "FIELDS", "SIZE",   "TYPE",      "COUNT",
                                  "WIDTH",   "HEIGHT", "POINTS", "VIEWPOINT", "DATA"};

struct Entry {
  std::uint64_t line = 0;
  std::vector<std::string_view> values;
};

/// The header's lines by keyword, before anything is made of their values.
class Entries {
public:
  Entries(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  std::optional<Error> collect();
  const Entry* find(const std::string& keyword) const {
    const auto found = entries_.find(keyword);
    return found == entries_.end() ? nullptr : &found->second;
  }
  Error errorAt(const Entry& entry, std::string what, std::string remedy) const {
    return {path_, "line " + std::to_string(entry.line), std::move(what), std::move(remedy)};
  }
  Error missing(const std::string& keyword) const {
    return {path_, "header", "there is no " + keyword + " line",
            "add it, or save the file again from the program it comes from"};
  }
  std::uint64_t bodyOffset() const { return bodyOffset_; }
  std::uint64_t bodyLine() const { return bodyLine_; }

private:
  const std::string& path_;
  std::string_view bytes_;
  std::map<std::string, Entry> entries_;
  std::uint64_t bodyOffset_ = 0;
  std::uint64_t bodyLine_ = 0;
};

std::optional<Error> Entries::collect() {
  TextLines lines(bytes_.substr(0, kMaxHeaderBytes));
  while (lines.next()) {
    if (!lines.hasLineEnd() && bytes_.size() > kMaxHeaderBytes) break;
    std::string_view rest = lines.line();
    const std::string_view first = takeToken(rest);
    if (first.empty() || first.starts_with('#')) continue;
    std::string keyword(first);
    if (keyword == "COLUMNS") keyword = "FIELDS";  // its name before version 0.6
    if (std::find(kKeywords.begin(), kKeywords.end(), keyword) == kKeywords.end())
      return Error{path_, lines.where(), "unknown header keyword " + quotedText(first),
                   "is this a PCD file? Remove the line if it is"};
    if (!lines.hasLineEnd())
      return Error{path_, lines.where(), "the file ends inside its header",
                   "it is cut off: copy or save it again"};
    Entry entry{lines.number(), {}};
    for (std::string_view token = takeToken(rest); !token.empty(); token = takeToken(rest))
      entry.values.push_back(token);
    if (entry.values.empty())
      return Error{path_, lines.where(), keyword + " has no value", "save the file again"};
    if (!entries_.emplace(keyword, std::move(entry)).second)
      return Error{path_, lines.where(), keyword + " is there twice", "keep one of the two lines"};
    if (keyword == "DATA") {
      bodyOffset_ = static_cast<std::uint64_t>(lines.rest().data() - bytes_.data());
      bodyLine_ = lines.number() + 1;
      return std::nullopt;
    }
  }
  if (bytes_.size() > kMaxHeaderBytes)
    return Error{path_, "header", "no DATA line within the first 64 KiB",
                 "is this a PCD file? Save it again if it is"};
  return missing("DATA");
}

Expected<std::uint64_t> oneCount(const Entries& entries, const Entry& entry, const char* keyword) {
  const auto value = entry.values.size() == 1 ? countFromText(entry.values[0]) : std::nullopt;
  if (!value || *value < 1 || *value > std::numeric_limits<std::int32_t>::max())
    return entries.errorAt(entry,
                           std::string(keyword) + " must be one whole number from 1 to 2147483647, here " +
                               quotedText(entry.values[0]),
                           "correct it, or save the file again");
  return *value;
}

Expected<std::vector<PcdField>> fieldsOf(const Entries& entries) {
  const Entry* names = entries.find("FIELDS");
  const Entry* sizes = entries.find("SIZE");
  const Entry* types = entries.find("TYPE");
  const Entry* counts = entries.find("COUNT");  // may be left out: 1 each
  if (!names) return entries.missing("FIELDS");
  if (!sizes) return entries.missing("SIZE");
  if (!types) return entries.missing("TYPE");
  for (const Entry* entry : {sizes, types, counts})
    if (entry && entry->values.size() != names->values.size())
      return entries.errorAt(*entry,
                             std::to_string(entry->values.size()) + " values for " +
                                 std::to_string(names->values.size()) + " fields",
                             "give one value for each name in FIELDS");
  std::vector<PcdField> fields;
  for (size_t f = 0; f < names->values.size(); ++f) {
    PcdField field;
    field.name = names->values[f];
    const auto size = countFromText(sizes->values[f]);
    const std::string_view type = types->values[f];
    if (type != "F" && type != "I" && type != "U")
      return entries.errorAt(
          *types, "TYPE of field " + quotedText(field.name) + " is " + quotedText(type) + ", not F, I or U",
          "correct it, or save the file again");
    field.type = type[0];
    if (!size || !(*size == 4 || *size == 8 || (field.type != 'F' && (*size == 1 || *size == 2))))
      return entries.errorAt(*sizes,
                             "SIZE of field " + quotedText(field.name) + " is " +
                                 quotedText(sizes->values[f]) + ", not one its type has",
                             "F has 4 or 8 bytes, I and U have 1, 2, 4 or 8");
    field.size = static_cast<unsigned>(*size);
    if (counts) {
      const auto count = countFromText(counts->values[f]);
      // the upper bound keeps every product of this header within 64 bits
      if (!count || *count < 1 || *count > std::numeric_limits<std::int32_t>::max())
        return entries.errorAt(*counts,
                               "COUNT of field " + quotedText(field.name) + " is " +
                                   quotedText(counts->values[f]) + ", not 1 or more",
                               "correct it, or save the file again");
      field.count = *count;
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

/// "tx ty tz qw qx qy qz"
Expected<Eigen::Isometry3d> viewpointOf(const Entries& entries, const Entry& entry) {
  const char* const remedy = "write VIEWPOINT tx ty tz qw qx qy qz, or 0 0 0 1 0 0 0";
  std::array<double, 7> v{};
  if (entry.values.size() != v.size())
    return entries.errorAt(entry, "VIEWPOINT does not have 7 numbers", remedy);
  for (size_t i = 0; i < v.size(); ++i) {
    const auto number = numberFromText(entry.values[i]);
    if (!number || !std::isfinite(*number) || std::abs(*number) > 1e9)
      return entries.errorAt(entry, "VIEWPOINT holds " + quotedText(entry.values[i]), remedy);
    v[i] = *number;
  }
  const Eigen::Quaterniond rotation(v[3], v[4], v[5], v[6]);
  if (!(rotation.norm() > 1e-6)) return entries.errorAt(entry, "the quaternion of VIEWPOINT is zero", remedy);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

}  // namespace

std::optional<size_t> PcdHeader::fieldNamed(std::string_view name) const {
  std::optional<size_t> found;
  for (size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].name != name) continue;
    if (found) return std::nullopt;
    found = f;
  }
  return found;
}

bool looksLikePcd(std::string_view bytes) {
  TextLines lines(bytes.substr(0, kMaxHeaderBytes));
  while (lines.next()) {
    std::string_view rest = lines.line();
    if (rest.starts_with("# .PCD") || rest.starts_with("#.PCD")) return true;
    const std::string_view keyword = takeToken(rest);
    if (keyword.empty() || keyword.starts_with('#')) continue;
    return keyword == "VERSION" && numberFromText(takeToken(rest)).has_value();
  }
  return false;
}

Expected<PcdHeader> parsePcdHeader(const std::string& path, std::string_view bytes) {
  Entries entries(path, bytes);
  if (auto error = entries.collect()) return *error;
  PcdHeader header;
  header.bodyOffset = entries.bodyOffset();
  header.bodyLine = entries.bodyLine();

  const Entry* version = entries.find("VERSION");
  if (!version) return entries.missing("VERSION");
  constexpr std::array kVersions = {"0.7", ".7", "0.6", ".6", "0.5", ".5"};
  if (version->values.size() != 1 ||
      std::find(kVersions.begin(), kVersions.end(), version->values[0]) == kVersions.end())
    return entries.errorAt(*version, "PCD version " + quotedText(version->values[0]) + " is not known",
                           "save the file as version 0.7");

  auto fields = fieldsOf(entries);
  if (!fields) return fields.error();
  header.fields = std::move(fields).value();
  for (const PcdField& field : header.fields) {
    header.pointBytes += field.size * field.count;
    header.pointNumbers += field.count;
  }

  if (const Entry* entry = entries.find("POINTS")) {
    const auto points = oneCount(entries, *entry, "POINTS");
    if (!points) return points.error();
    header.points = *points;
  }
  if (const Entry* entry = entries.find("HEIGHT")) {
    const auto height = oneCount(entries, *entry, "HEIGHT");
    if (!height) return height.error();
    header.height = *height;
  }
  if (const Entry* entry = entries.find("WIDTH")) {
    const auto width = oneCount(entries, *entry, "WIDTH");
    if (!width) return width.error();
    header.width = *width;
  } else if (header.points == 0 || entries.find("HEIGHT")) {
    return entries.missing("WIDTH");
  } else {
    header.width = header.points;  // as before version 0.7
  }
  const std::uint64_t product = header.width * header.height;
  if (const Entry* entry = entries.find("POINTS"); entry && product != header.points)
    return entries.errorAt(
        *entry,
        "POINTS " + std::to_string(header.points) + " is not WIDTH · HEIGHT = " + std::to_string(product),
        "correct the header, or save the file again");
  if (product > std::numeric_limits<std::int32_t>::max())
    return entries.errorAt(*entries.find("WIDTH"),
                           "WIDTH · HEIGHT = " + std::to_string(product) + " is more than 2147483647 points",
                           "split or thin the cloud");
  header.points = product;

  if (const Entry* entry = entries.find("VIEWPOINT")) {
    const auto pose = viewpointOf(entries, *entry);
    if (!pose) return pose.error();
    header.viewpoint = *pose;
  }

  const Entry& data = *entries.find("DATA");
  if (data.values.size() == 1 && data.values[0] == "ascii")
    header.encoding = PcdEncoding::Ascii;
  else if (data.values.size() == 1 && data.values[0] == "binary")
    header.encoding = PcdEncoding::Binary;
  else if (data.values.size() == 1 && data.values[0] == "binary_compressed")
    header.encoding = PcdEncoding::BinaryCompressed;
  else
    return entries.errorAt(
        data, "DATA " + quotedText(data.values[0]) + " is not ascii, binary or binary_compressed",
        "save the file again as binary");
  return header;
}

}  // namespace stratascope
