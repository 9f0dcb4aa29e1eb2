// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/las_reader.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

static_assert(std::endian::native == std::endian::little, "LAS is little-endian");

namespace {

const char* const kCutOff = "the file is cut off or damaged: copy or save it again";
constexpr std::array<unsigned, 11> kPointBytes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

template <class T>
T at(std::string_view bytes, std::uint64_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct LasHeader {
  int minor = 0;
  std::uint64_t headerBytes = 0;
  std::uint64_t pointsAt = 0;
  std::uint64_t records = 0;  ///< variable length records
  int format = 0;
  std::uint64_t pointBytes = 0;
  std::uint64_t points = 0;
  std::uint64_t extendedAt = 0;  ///< 0 = none
  std::uint64_t extended = 0;
  Eigen::Vector3d scale, offset;
};

Expected<LasHeader> parseHeader(const std::string& path, std::string_view bytes) {
  const auto error = [&](std::uint64_t where, std::string what, const char* remedy = kCutOff) {
    return Error{path, "byte " + std::to_string(where), std::move(what), remedy};
  };
  if (!looksLikeLas(bytes))
    return error(0, "it does not begin with LASF", "is this a LAS file? Save it again if it is");
  constexpr std::array<std::uint64_t, 5> kHeaderBytes = {227, 227, 227, 235, 375};
  if (bytes.size() < kHeaderBytes[0]) return error(bytes.size(), "the file ends inside its header");
  LasHeader h;
  const int major = at<std::uint8_t>(bytes, 24);
  h.minor = at<std::uint8_t>(bytes, 25);
  if (major != 1 || h.minor > 4)
    return error(24, "LAS version " + std::to_string(major) + "." + std::to_string(h.minor) + " is not known",
                 "save it as LAS 1.2 or 1.4");
  h.headerBytes = at<std::uint16_t>(bytes, 94);
  h.pointsAt = at<std::uint32_t>(bytes, 96);
  h.records = at<std::uint32_t>(bytes, 100);
  const unsigned format = at<std::uint8_t>(bytes, 104);
  h.pointBytes = at<std::uint16_t>(bytes, 105);
  h.points = at<std::uint32_t>(bytes, 107);
  if (h.headerBytes < kHeaderBytes[static_cast<size_t>(h.minor)] || h.headerBytes > bytes.size())
    return error(94, "a header of " + std::to_string(h.headerBytes) + " bytes");
  if (format & 0xC0)
    return error(104, "the points are compressed (LAZ)",
                 "convert it with 'laszip -i FILE.laz -o FILE.las' or 'pdal translate FILE.laz FILE.las'");
  if (format >= kPointBytes.size())
    return error(104, "point format " + std::to_string(format) + " is not known",
                 "save it as LAS 1.2 or 1.4 with a point format from 0 to 10");
  h.format = static_cast<int>(format);
  if (h.pointBytes < kPointBytes[format])
    return error(105, std::to_string(h.pointBytes) + " bytes a point, but point format " +
                          std::to_string(format) + " has " + std::to_string(kPointBytes[format]));
  if (h.minor == 4) {
    const auto points = at<std::uint64_t>(bytes, 247);
    if (h.points != 0 && h.points != points)
      return error(247, "two counts of points that differ: " + std::to_string(h.points) + " and " +
                            std::to_string(points));
    h.points = points;
    h.extendedAt = at<std::uint64_t>(bytes, 235);
    h.extended = at<std::uint32_t>(bytes, 243);
  }
  if (h.points == 0) return error(107, "no points in the file", "choose another scan");
  if (h.points > std::numeric_limits<std::int32_t>::max())
    return error(107, std::to_string(h.points) + " points, more than 2147483647", "split or thin the cloud");
  if (h.pointsAt < h.headerBytes || h.pointsAt > bytes.size())
    return error(96, "points from byte " + std::to_string(h.pointsAt) + ", outside the file");
  if (h.points > (bytes.size() - h.pointsAt) / h.pointBytes)
    return error(h.pointsAt, std::to_string(h.points) + " points of " + std::to_string(h.pointBytes) +
                                 " bytes are announced, but " + std::to_string(bytes.size() - h.pointsAt) +
                                 " bytes follow");
  for (int axis = 0; axis < 3; ++axis) {
    h.scale[axis] = at<double>(bytes, 131 + 8 * static_cast<std::uint64_t>(axis));
    h.offset[axis] = at<double>(bytes, 155 + 8 * static_cast<std::uint64_t>(axis));
    if (!std::isfinite(h.scale[axis]) || !(h.scale[axis] > 0) || h.scale[axis] > 1e3)
      return error(131, "a scale of " + shortestText(h.scale[axis]));
    if (!std::isfinite(h.offset[axis]) || isAbsurdCoordinate(h.offset[axis]))
      return error(155, "an offset of " + shortestText(h.offset[axis]));
  }
  return h;
}

/// What the coordinate system in the records says.
struct Projection {
  LengthUnit unit = LengthUnit::Auto;
  std::string note;
};

void unitFromGeoKeys(std::string_view keys, Projection& projection) {
  constexpr std::uint64_t kEntry = 8;
  constexpr std::uint16_t kProjectedSystem = 3072, kLinearUnit = 3076;
  if (keys.size() < kEntry) return;
  const std::uint64_t count = std::min<std::uint64_t>(at<std::uint16_t>(keys, 6), keys.size() / kEntry - 1);
  for (std::uint64_t i = 1; i <= count; ++i) {
    const auto key = at<std::uint16_t>(keys, i * kEntry);
    const auto value = at<std::uint16_t>(keys, i * kEntry + 6);
    if (at<std::uint16_t>(keys, i * kEntry + 2) != 0) continue;  // the value is kept elsewhere
    if (key == kLinearUnit)
      projection.unit = value == 9001   ? LengthUnit::Metre
                        : value == 9002 ? LengthUnit::Foot
                        : value == 9003 ? LengthUnit::SurveyFoot
                                        : projection.unit;
    const bool utm = (value > 32600 && value <= 32660) || (value > 32700 && value <= 32760) ||
                     (value >= 25828 && value <= 25838);
    if (key == kProjectedSystem && utm && projection.unit == LengthUnit::Auto)
      projection.unit = LengthUnit::Metre;
  }
}

/// The unit of the horizontal axes comes after their projection: the last unit of length before a vertical
/// system.
void unitFromWkt(std::string_view text, Projection& projection) {
  text = text.substr(0, text.find("VERT"));
  for (size_t found = text.find("UNIT[\""); found != text.npos; found = text.find("UNIT[\"", found + 1)) {
    const size_t comma = text.find(',', found);
    if (comma == text.npos) return;
    const std::string_view name = text.substr(found, comma - found);
    const std::string_view rest = text.substr(comma + 1, 40);
    const auto factor = numberFromText(rest.substr(0, std::min(rest.find_first_of("],"), rest.size())));
    if (!factor || name.find("egree") != name.npos || name.find("adian") != name.npos) continue;
    for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::SurveyFoot, LengthUnit::Foot})
      if (std::abs(*factor - metresPerUnit(unit)) < 1e-7) projection.unit = unit;
  }
}

/// Walks the records: `count` of them from `where`, each with a header of `headerBytes` that ends before
/// `end`.
std::optional<Error> readRecords(const std::string& path, std::string_view bytes, std::uint64_t where,
                                 std::uint64_t end, std::uint64_t count, bool extended,
                                 Projection& projection) {
  const std::uint64_t headerBytes = extended ? 60 : 54;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto cut = [&] {
      return Error{
          path, "byte " + std::to_string(where),
          "record " + std::to_string(i + 1) + " of " + std::to_string(count) + " goes beyond its place",
          kCutOff};
    };
    if (where > end || end - where < headerBytes) return cut();
    const std::string_view user(bytes.data() + where + 2, 15);
    const auto id = at<std::uint16_t>(bytes, where + 18);
    const std::uint64_t length =
        extended ? at<std::uint64_t>(bytes, where + 20) : at<std::uint16_t>(bytes, where + 20);
    where += headerBytes;
    if (length > end - where) return cut();
    if (user == "LASF_Projection" && id == 34735) unitFromGeoKeys(bytes.substr(where, length), projection);
    if (user == "LASF_Projection" && id == 2112) unitFromWkt(bytes.substr(where, length), projection);
    where += length;
  }
  return std::nullopt;
}

bool isWithheld(const char* point, int format) {
  const auto flags = static_cast<std::uint8_t>(point[15]);
  return format < 6 ? (flags & 0x80) != 0 : (flags & 0x04) != 0;
}

std::vector<std::string> fieldsOf(int format) {
  std::vector<std::string> fields = {"x", "y", "z", "intensity", "classification"};
  if (format != 0 && format != 2) fields.emplace_back("gps_time");
  if (format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10)
    fields.insert(fields.end(), {"red", "green", "blue"});
  if (format == 8 || format == 10) fields.emplace_back("nir");
  return fields;
}

}  // namespace

Expected<RawCloud> readLas(const std::string& path, std::string_view bytes) {
  const auto header = parseHeader(path, bytes);
  if (!header) return header.error();
  Projection projection;
  if (const auto error =
          readRecords(path, bytes, header->headerBytes, header->pointsAt, header->records, false, projection))
    return *error;
  const std::uint64_t pointsEnd = header->pointsAt + header->points * header->pointBytes;
  if (header->extended > 0) {
    if (header->extendedAt < pointsEnd)
      return Error{path, "byte 235", "extended records begin inside the points", kCutOff};
    if (const auto error =
            readRecords(path, bytes, header->extendedAt, bytes.size(), header->extended, true, projection))
      return *error;
  }

  RawCloud cloud;
  cloud.format = "LAS 1." + std::to_string(header->minor) + " format " + std::to_string(header->format);
  cloud.fields = fieldsOf(header->format);
  cloud.wideCoordinates = true;
  cloud.said = {projection.unit, FileAxes::ZUp};
  LocalOrigin origin;
  size_t withheld = 0;
  cloud.points.reserve(header->points);
  for (std::uint64_t i = 0; i < header->points; ++i) {
    const char* point = bytes.data() + header->pointsAt + i * header->pointBytes;
    if (isWithheld(point, header->format)) {
      ++withheld;
      continue;
    }
    std::array<std::int32_t, 3> xyz{};
    std::memcpy(xyz.data(), point, sizeof xyz);
    const Eigen::Vector3d p =
        Eigen::Vector3d(xyz[0], xyz[1], xyz[2]).cwiseProduct(header->scale) + header->offset;
    for (const double v : p)
      if (isAbsurdCoordinate(v))
        return Error{path, "point " + std::to_string(i), "a coordinate of " + shortestText(v),
                     "is the file damaged?"};
    cloud.points.push_back(origin.shifted(p));
  }
  cloud.localOrigin = origin.origin();
  if (withheld > 0) cloud.notes.push_back(std::to_string(withheld) + " withheld points are left out.");
  if (header->extended == 0 && bytes.size() > pointsEnd)
    cloud.notes.push_back(std::to_string(bytes.size() - pointsEnd) +
                          " bytes after the last point are not read.");
  if (projection.unit == LengthUnit::Auto) {
    cloud.said.unit = LengthUnit::Metre;
    cloud.notes.push_back(
        "The file does not say its unit, so metres are taken; state-plane coordinates are often in feet: "
        "then choose ft or us-ft.");
  }
  if (!cloud.localOrigin.isZero(0))
    cloud.notes.push_back(
        "The file does not say where the scanner stood; it is taken to be at the local origin.");
  return cloud;
}

}  // namespace stratascope
