// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/e57_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <pugixml.hpp>

#include "base/units.h"
#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

const char* const kDamaged =
    "the file is damaged, or written in a way this program does not know: save it again, or convert it to "
    "PTX or PLY";

template <class T>
T at(std::string_view bytes, std::uint64_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

enum class Kind : std::uint8_t { Integer, Single, Double, Text };

/// How one field of the records is written.
struct Field {
  std::string name;
  Kind kind = Kind::Integer;
  std::int64_t minimum = 0;
  unsigned bits = 64;
  double scale = 1, offset = 0;  ///< of a scaled integer
};

/// The fields a scan is made of; none = the file has it not.
struct Wanted {
  std::array<std::optional<size_t>, 3> coordinates;
  bool spherical = false;
  std::optional<size_t> invalid, row, column, returned;
};

std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t usual) {
  if (text.empty()) return usual;
  std::int64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}
std::optional<double> realNumber(std::string_view text, double usual) {
  std::string_view rest = text;
  const std::string_view token = takeToken(rest);
  if (token.empty()) return usual;
  const auto value = numberFromText(token);
  return value && std::isfinite(*value) && takeToken(rest).empty() ? value : std::nullopt;
}

/// What is wrong comes back as text, empty if nothing is.
std::string parseField(const pugi::xml_node& node, Field& field) {
  field.name = node.name();
  const std::string_view type = node.attribute("type").value();
  if (type == "String") return field.kind = Kind::Text, std::string();
  if (type == "Float") {
    const std::string_view precision = node.attribute("precision").value();
    if (!precision.empty() && precision != "single" && precision != "double")
      return "precision " + quotedText(precision);
    field.kind = precision == "single" ? Kind::Single : Kind::Double;
    return {};
  }
  if (type != "Integer" && type != "ScaledInteger") return "type " + quotedText(type);
  const auto minimum =
      wholeNumber(node.attribute("minimum").value(), std::numeric_limits<std::int64_t>::min());
  const auto maximum =
      wholeNumber(node.attribute("maximum").value(), std::numeric_limits<std::int64_t>::max());
  if (!minimum || !maximum || *minimum > *maximum) return "minimum and maximum that are no range";
  field.minimum = *minimum;
  field.bits = static_cast<unsigned>(
      std::bit_width(static_cast<std::uint64_t>(*maximum) - static_cast<std::uint64_t>(*minimum)));
  if (type == "Integer") return {};
  const auto scale = realNumber(node.attribute("scale").value(), 1);
  const auto offset = realNumber(node.attribute("offset").value(), 0);
  if (!scale || !offset || *scale == 0) return "scale or offset that are no numbers";
  field.scale = *scale, field.offset = *offset;
  return {};
}

/// One stream of the records, bit after bit, lowest first.
class Stream {
public:
  Stream(const Field& field, std::string_view bytes) : field_(&field), bytes_(bytes) {}
  std::uint64_t bits() const {
    return field_->kind == Kind::Single ? 32 : field_->kind == Kind::Double ? 64 : field_->bits;
  }
  bool holds(std::uint64_t records) const { return bits() == 0 || records <= bytes_.size() * 8 / bits(); }

  double value(std::uint64_t record) const {
    const std::uint64_t raw = rawAt(record * bits());
    if (field_->kind == Kind::Single) return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
    if (field_->kind == Kind::Double) return std::bit_cast<double>(raw);
    return static_cast<double>(whole(record)) * field_->scale + field_->offset;
  }
  std::int64_t whole(std::uint64_t record) const {
    return static_cast<std::int64_t>(rawAt(record * bits()) + static_cast<std::uint64_t>(field_->minimum));
  }

private:
  std::uint64_t rawAt(std::uint64_t bit) const {
    const auto width = static_cast<unsigned>(bits());
    if (width == 0) return 0;
    const std::uint64_t byte = bit / 8;
    const auto shift = static_cast<unsigned>(bit % 8);
    std::uint64_t low = 0;
    std::memcpy(&low, bytes_.data() + byte, std::min<std::uint64_t>(sizeof low, bytes_.size() - byte));
    std::uint64_t value = low >> shift;
    if (shift > 0 && width + shift > 64)
      value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes_[byte + 8])) << (64 - shift);
    return width == 64 ? value : value & ((std::uint64_t{1} << width) - 1);
  }
  const Field* field_;
  std::string_view bytes_;
};

class ScanReader {
public:
  ScanReader(const std::string& path, const E57Pages& pages, const pugi::xml_node& scan, std::string place)
      : path_(path), pages_(pages), scan_(scan), place_(std::move(place)) {}

  Expected<RawCloud> read() {
    if (std::string problem = readPrototype(); !problem.empty()) return error(problem);
    if (std::string problem = gatherStreams(); !problem.empty()) return error(problem);
    RawCloud cloud;
    cloud.format = "E57";
    cloud.said = {LengthUnit::Metre, FileAxes::ZUp};
    cloud.wideCoordinates = true;
    for (const Field& field : fields_) cloud.fields.push_back(field.name);
    if (std::string problem = readPose(cloud); !problem.empty()) return error(problem);
    if (std::string problem = readPoints(cloud); !problem.empty()) return error(problem);
    if (std::string problem = layOut(cloud); !problem.empty()) return error(problem);
    return cloud;
  }

private:
  Error error(std::string what) const { return {path_, place_, std::move(what), kDamaged}; }

  std::string readPrototype() {
    const pugi::xml_node points = scan_.child("points");
    const auto at = wholeNumber(points.attribute("fileOffset").value(), -1);
    const auto count = wholeNumber(points.attribute("recordCount").value(), -1);
    if (std::string_view(points.attribute("type").value()) != "CompressedVector" || !at || *at < 0 ||
        !count || *count < 1)
      return "no points";
    if (*count > std::numeric_limits<std::int32_t>::max())
      return std::to_string(*count) + " points, more than 2147483647";
    if (points.child("codecs").first_child()) return "a codec other than the standard's own";
    sectionAt_ = static_cast<std::uint64_t>(*at);
    records_ = static_cast<std::uint64_t>(*count);
    for (const pugi::xml_node& node : points.child("prototype").children()) {
      if (node.type() != pugi::node_element) continue;
      Field field;
      if (std::string problem = parseField(node, field); !problem.empty())
        return "field " + quotedText(node.name()) + " has " + problem;
      for (const Field& other : fields_)
        if (other.name == field.name) return "field " + quotedText(field.name) + " is there twice";
      fields_.push_back(std::move(field));
      if (fields_.size() > 256) return "more than 256 fields";
    }
    const auto find = [&](std::string_view name) -> std::optional<size_t> {
      for (size_t f = 0; f < fields_.size(); ++f)
        if (fields_[f].name == name && fields_[f].kind != Kind::Text) return f;
      return std::nullopt;
    };
    wanted_.coordinates = {find("cartesianX"), find("cartesianY"), find("cartesianZ")};
    wanted_.invalid = find("cartesianInvalidState");
    const auto complete = [&] {
      return std::all_of(wanted_.coordinates.begin(), wanted_.coordinates.end(),
                         [](const auto& c) { return c.has_value(); });
    };
    if (!complete()) {
      wanted_.coordinates = {find("sphericalRange"), find("sphericalAzimuth"), find("sphericalElevation")};
      wanted_.invalid = find("sphericalInvalidState");
      wanted_.spherical = true;
    }
    if (!complete())
      return "neither cartesianX, Y, Z nor sphericalRange, Azimuth, Elevation among its fields";
    wanted_.row = find("rowIndex");
    wanted_.column = find("columnIndex");
    wanted_.returned = find("returnIndex");
    // Indices count whole things.
    for (const auto& index : {wanted_.invalid, wanted_.row, wanted_.column, wanted_.returned})
      if (index && (fields_[*index].kind != Kind::Integer || fields_[*index].scale != 1 ||
                    fields_[*index].offset != 0))
        return "field " + quotedText(fields_[*index].name) + " is not of type Integer";
    return {};
  }

  /// Puts each field's pieces, spread over the packets, together.
  std::string gatherStreams() {
    const std::string_view bytes = pages_.bytes;
    constexpr std::uint64_t kSectionHeader = 32, kPacketHeader = 4;
    const auto section = pages_.logical(sectionAt_);
    if (!section || bytes.size() - *section < kSectionHeader || bytes[*section] != 1)
      return "its points are not where the file says";
    const auto length = at<std::uint64_t>(bytes, *section + 8);
    if (length < kSectionHeader || length > bytes.size() - *section)
      return "its section of " + std::to_string(length) + " bytes goes beyond the file";
    const std::uint64_t end = *section + length;
    const auto data = pages_.logical(at<std::uint64_t>(bytes, *section + 16));
    if (!data || *data < *section + kSectionHeader || *data > end)
      return "its data are not inside its section";
    pieces_.resize(fields_.size());
    for (std::uint64_t packet = *data; packet < end;) {
      if (end - packet < kPacketHeader) return "a packet is cut off";
      constexpr std::uint8_t kIndex = 0, kData = 1, kIgnored = 2;
      const auto type = static_cast<std::uint8_t>(bytes[packet]);
      const std::uint64_t packetBytes = at<std::uint16_t>(bytes, packet + 2) + 1ULL;
      if (packetBytes % 4 != 0 || packetBytes > end - packet)
        return "a packet of " + std::to_string(packetBytes) + " bytes";
      if (type == kData) {
        if (std::string problem = takePacket(bytes.substr(packet, packetBytes)); !problem.empty())
          return problem;
      } else if (type != kIndex && type != kIgnored) {
        return "a packet of unknown type " + std::to_string(type);
      }
      packet += packetBytes;
    }
    std::uint64_t recordBits = 0;
    for (size_t f = 0; f < fields_.size(); ++f) {
      if (fields_[f].kind == Kind::Text) continue;
      const Stream stream(fields_[f], pieces_[f]);
      if (!stream.holds(records_))
        return "field " + quotedText(fields_[f].name) + " ends before its " + std::to_string(records_) +
               " records";
    }
    for (const auto& c : wanted_.coordinates) recordBits += Stream(fields_[*c], pieces_[*c]).bits();
    constexpr std::uint64_t kFewestBits = 24;  // so that memory stays bounded by the file
    return recordBits < kFewestBits ? "coordinates of " + std::to_string(recordBits) + " bits"
                                    : std::string();
  }

  std::string takePacket(std::string_view packet) {
    constexpr std::uint64_t kHeader = 6;
    if (packet.size() < kHeader || at<std::uint16_t>(packet, 4) != fields_.size() ||
        packet.size() < kHeader + 2 * fields_.size())
      return "a packet without one stream for each field";
    std::uint64_t where = kHeader + 2 * fields_.size();
    for (size_t f = 0; f < fields_.size(); ++f) {
      const std::uint64_t length = at<std::uint16_t>(packet, kHeader + 2 * f);
      if (length > packet.size() - where) return "a packet's streams are longer than the packet";
      pieces_[f].append(packet.substr(where, length));
      where += length;
    }
    return {};
  }

  std::string readPose(RawCloud& cloud) const {
    const pugi::xml_node pose = scan_.child("pose");
    if (!pose) return {};
    const auto number = [](const pugi::xml_node& node, const char* name) {
      return realNumber(node.child(name).child_value(), 0);
    };
    const pugi::xml_node r = pose.child("rotation"), t = pose.child("translation");
    const std::array values = {number(r, "w"), number(r, "x"), number(r, "y"), number(r, "z"),
                               number(t, "x"), number(t, "y"), number(t, "z")};
    for (const auto& v : values)
      if (!v || isAbsurdCoordinate(*v)) return "a pose that is not of usable numbers";
    Eigen::Isometry3d map_T_scan = Eigen::Isometry3d::Identity();
    if (r) {
      const Eigen::Quaterniond q(*values[0], *values[1], *values[2], *values[3]);
      if (!(q.norm() > 0.5 && q.norm() < 2)) return "a pose whose rotation is no unit quaternion";
      map_T_scan.linear() = q.normalized().toRotationMatrix();
    }
    map_T_scan.translation() = Eigen::Vector3d(*values[4], *values[5], *values[6]);
    cloud.map_T_scan = map_T_scan;
    return {};
  }

  std::string readPoints(RawCloud& cloud) {
    const auto stream = [&](size_t f) { return Stream(fields_[f], pieces_[f]); };
    const std::array coordinates = {stream(*wanted_.coordinates[0]), stream(*wanted_.coordinates[1]),
                                    stream(*wanted_.coordinates[2])};
    const auto isSet = [&](const std::optional<size_t>& f, std::uint64_t record) {
      return f && stream(*f).whole(record) != 0;
    };
    LocalOrigin origin;
    cloud.points.reserve(records_);
    for (std::uint64_t i = 0; i < records_; ++i) {
      Eigen::Vector3d p(coordinates[0].value(i), coordinates[1].value(i), coordinates[2].value(i));
      if (wanted_.spherical) {
        const double range = p.x(), azimuth = p.y(), elevation = p.z();
        p = range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                    std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      }
      // a point out of its range's reach is as missing as one marked so
      const bool missing = isSet(wanted_.invalid, i) || isSet(wanted_.returned, i) || !p.allFinite();
      if (!missing)
        for (const double v : p)
          if (isAbsurdCoordinate(v))
            return "a coordinate of " + shortestText(v) + " m in record " + std::to_string(i);
      cloud.points.push_back(missing ? Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf)) : origin.shifted(p));
    }
    cloud.localOrigin = origin.origin();
    return {};
  }

  /// Lowest and highest index of a field, from indexBounds if they are there, else from the records.
  std::string boundsOf(size_t field, const char* lowest, const char* highest, std::int64_t& low,
                       std::int64_t& high) const {
    const Stream stream(fields_[field], pieces_[field]);
    std::int64_t least = std::numeric_limits<std::int64_t>::max(),
                 most = std::numeric_limits<std::int64_t>::min();
    for (std::uint64_t i = 0; i < records_; ++i) {
      least = std::min(least, stream.whole(i));
      most = std::max(most, stream.whole(i));
    }
    const pugi::xml_node bounds = scan_.child("indexBounds");
    const auto said = [&](const char* name, std::int64_t usual) {
      return bounds.child(name) ? wholeNumber(bounds.child(name).child_value(), 0) : usual;
    };
    const auto saidLow = said(lowest, least), saidHigh = said(highest, most);
    if (!saidLow || !saidHigh || *saidLow > least || *saidHigh < most)
      return "indexBounds that do not hold its " + fields_[field].name;
    low = *saidLow, high = *saidHigh;
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    if (low < -kMost || high > kMost) return fields_[field].name + " beyond 2147483647";
    return {};
  }

  std::string layOut(RawCloud& cloud) const {
    if (!wanted_.row || !wanted_.column) return {};
    std::int64_t firstRow = 0, lastRow = 0, firstColumn = 0, lastColumn = 0;
    if (std::string problem = boundsOf(*wanted_.row, "rowMinimum", "rowMaximum", firstRow, lastRow);
        !problem.empty())
      return problem;
    if (std::string problem =
            boundsOf(*wanted_.column, "columnMinimum", "columnMaximum", firstColumn, lastColumn);
        !problem.empty())
      return problem;
    const auto beams = static_cast<std::uint64_t>(lastRow - firstRow + 1),
               lines = static_cast<std::uint64_t>(lastColumn - firstColumn + 1);
    if (!latticeIsWarranted(lines, beams, records_, pages_.bytes.size())) {
      cloud.notes.push_back("Its rows and columns are nearly empty, so the lattice is made from the points.");
      return {};
    }
    const Stream rows(fields_[*wanted_.row], pieces_[*wanted_.row]),
        columns(fields_[*wanted_.column], pieces_[*wanted_.column]);
    std::vector<Eigen::Vector3f> placed(lines * beams, Eigen::Vector3f::Constant(kNaNf));
    size_t twice = 0;
    for (std::uint64_t i = 0; i < records_; ++i) {
      if (!cloud.points[i].allFinite()) continue;
      Eigen::Vector3f& place = placed[static_cast<std::uint64_t>(columns.whole(i) - firstColumn) * beams +
                                      static_cast<std::uint64_t>(rows.whole(i) - firstRow)];
      twice += place.allFinite();
      if (!place.allFinite()) place = cloud.points[i];
    }
    if (twice > 0)
      cloud.notes.push_back(std::to_string(twice) +
                            " points share row and column with another and are left out.");
    cloud.points = std::move(placed);
    cloud.lines = static_cast<int>(lines);
    cloud.beams = static_cast<int>(beams);
    return {};
  }

  const std::string& path_;
  const E57Pages& pages_;
  const pugi::xml_node& scan_;
  std::string place_;
  std::uint64_t sectionAt_ = 0;
  std::uint64_t records_ = 0;
  std::vector<Field> fields_;
  std::vector<std::string> pieces_;
  Wanted wanted_;
};

}  // namespace

Expected<std::vector<RawCloud>> readE57(const std::string& path, std::string bytes) {
  const auto pages = openE57Pages(path, std::move(bytes));
  if (!pages) return pages.error();
  pugi::xml_document document;
  const auto parsed = document.load_buffer(pages->bytes.data() + pages->xmlAt, pages->xmlLength,
                                           pugi::parse_default, pugi::encoding_utf8);
  if (!parsed)
    return Error{path, "XML byte " + std::to_string(parsed.offset),
                 std::string("the XML section: ") + parsed.description(), kDamaged};
  const pugi::xml_node data = document.child("e57Root").child("data3D");
  std::vector<RawCloud> scans;
  std::uint64_t records = 0;
  for (const pugi::xml_node& child : data.children()) {
    if (child.type() != pugi::node_element) continue;
    constexpr size_t kMostScans = 4096;
    if (scans.size() == kMostScans) return Error{path, "data3D", "more than 4096 scans", "split the file"};
    auto scan = ScanReader(path, *pages, child, "scan " + std::to_string(scans.size() + 1)).read();
    if (!scan) return scan.error();
    // Many scans may name the same bytes: each record is counted, and takes three bytes at least.
    records += static_cast<std::uint64_t>(child.child("points").attribute("recordCount").as_ullong());
    if (records > pages->bytes.size() / 3)
      return Error{path, "data3D", "its scans announce more records than the file can hold", kDamaged};
    scans.push_back(std::move(scan).value());
  }
  if (scans.empty()) return Error{path, "data3D", "there is no scan in the file", "choose another file"};
  return scans;
}

}  // namespace stratascope
