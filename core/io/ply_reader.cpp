// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "base/units.h"
#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

static_assert(std::endian::native == std::endian::little, "byte orders are told from ours");

namespace {

const char* const kCutOff = "the file is cut off or its header is wrong: copy or save it again";

/// Walks the numbers of the body, whatever the encoding. The first problem ends the walk: failed() tells.
class NumberSource {
public:
  NumberSource(const std::string& path, std::string_view bytes, const PlyHeader& header)
      : path_(path),
        bytes_(bytes),
        encoding_(header.encoding),
        at_(header.bodyOffset),
        lines_(bytes.substr(header.bodyOffset), header.bodyLine) {}

  bool ascii() const { return encoding_ == PlyEncoding::Ascii; }

  /// The next row of an element; ascii rows are lines.
  void beginRow() {
    if (!ascii()) return;
    while (lines_.next()) {
      row_ = lines_.line();
      std::string_view probe = row_;
      if (!takeToken(probe).empty()) return;
    }
    fail("the file ends before its last row");
  }
  void endRow() {
    if (ascii() && !failed() && !takeToken(row_).empty()) fail("more numbers than the header announces");
  }

  double next(PlyType type) {
    if (failed()) return 0;
    if (ascii()) return nextText(type);
    const unsigned size = plyTypeBytes(type);
    if (bytes_.size() - at_ < size) return fail("the file ends before its last row"), 0;
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, size);
    at_ += size;
    if (encoding_ == PlyEncoding::BinaryBigEndian) std::reverse(raw.begin(), raw.begin() + size);
    switch (type) {
      case PlyType::Int8:
        return as<std::int8_t>(raw);
      case PlyType::Uint8:
        return as<std::uint8_t>(raw);
      case PlyType::Int16:
        return as<std::int16_t>(raw);
      case PlyType::Uint16:
        return as<std::uint16_t>(raw);
      case PlyType::Int32:
        return as<std::int32_t>(raw);
      case PlyType::Uint32:
        return as<std::uint32_t>(raw);
      case PlyType::Float:
        return as<float>(raw);
      default:
        return as<double>(raw);
    }
  }

  /// Steps over rows of known size at once.
  void skip(std::uint64_t rows, std::uint64_t rowBytes) {
    if (rows > (bytes_.size() - at_) / rowBytes) return fail("the file ends before its last row");
    at_ += rows * rowBytes;
  }

  /// Least bytes a row of so many numbers takes: memory stays bounded by the file, whatever the header says.
  bool fits(std::uint64_t rows, const PlyElement& element) const {
    std::uint64_t least = 0;
    for (const PlyProperty& p : element.properties)
      least += ascii() ? 2 : plyTypeBytes(p.countType.value_or(p.type));
    return rows == 0 || rows <= (bytes_.size() - bodyAt() + 1) / least;
  }

  void finish() {
    if (failed()) return;
    if (ascii()) {
      missingLineEnd_ = !lines_.hasLineEnd();
      while (lines_.next()) {
        row_ = lines_.line();
        if (!takeToken(row_).empty()) return fail("more rows than the header announces");
      }
    } else if (at_ != bytes_.size()) {
      fail(std::to_string(bytes_.size() - at_) + " bytes follow the last row");
    }
  }

  void fail(std::string what) {
    if (!error_) error_ = Error{path_, where(), std::move(what), kCutOff};
  }
  bool failed() const { return error_.has_value(); }
  const Error& error() const { return *error_; }
  bool missingLineEnd() const { return missingLineEnd_; }
  std::string where() const { return ascii() ? lines_.where() : "byte " + std::to_string(at_); }

private:
  template <class T>
  static double as(const std::array<char, 8>& raw) {
    T value;
    std::memcpy(&value, raw.data(), sizeof value);
    return static_cast<double>(value);
  }
  double nextText(PlyType type) {
    const std::string_view token = takeToken(row_);
    if (token.empty()) return fail("fewer numbers than the header announces"), 0;
    const auto number = numberFromText(token);
    if (!number) return fail(quotedText(token) + " is not a number"), 0;
    if (!isPlyReal(type) && *number != std::floor(*number))
      return fail(quotedText(token) + " is not a whole number"), 0;
    return *number;
  }
  size_t bodyAt() const { return ascii() ? bytes_.size() - lines_.rest().size() : at_; }

  const std::string& path_;
  std::string_view bytes_;
  PlyEncoding encoding_;
  size_t at_;
  TextLines lines_;
  std::string_view row_;
  std::optional<Error> error_;
  bool missingLineEnd_ = false;
};

constexpr std::int64_t kNoVertex = -1;

/// Which vertex stands at each place of a range grid.
void readGrid(NumberSource& source, const PlyElement& element, std::uint64_t vertices,
              std::vector<std::int64_t>& grid) {
  grid.reserve(element.count);
  std::vector<char> taken(vertices, 0);
  for (std::uint64_t row = 0; row < element.count && !source.failed(); ++row) {
    source.beginRow();
    const double length = source.next(*element.properties[0].countType);
    if (source.failed()) return;
    if (length != 0 && length != 1)
      return source.fail("a place of the range grid holds " + shortestText(length) + " vertices, not 0 or 1");
    std::int64_t vertex = kNoVertex;
    if (length == 1) {
      const double index = source.next(element.properties[0].type);
      if (source.failed()) return;
      if (!(index >= 0 && index < static_cast<double>(vertices)))
        return source.fail("the range grid names vertex " + shortestText(index) + ", which is not there");
      vertex = static_cast<std::int64_t>(index);
      if (taken[static_cast<size_t>(vertex)]++)
        return source.fail("the range grid names vertex " + shortestText(index) + " twice");
    }
    grid.push_back(vertex);
    source.endRow();
  }
}

void skipElement(NumberSource& source, const PlyElement& element) {
  if (element.count == 0) return;
  if (!source.ascii() && !element.hasLists()) return source.skip(element.count, element.rowBytes());
  for (std::uint64_t row = 0; row < element.count && !source.failed(); ++row) {
    source.beginRow();
    for (const PlyProperty& property : element.properties) {
      const double length = property.countType ? source.next(*property.countType) : 1;
      if (!(length >= 0)) return source.fail("a list of " + shortestText(length) + " items");
      for (double n = 0; n < length && !source.failed(); ++n) source.next(property.type);
    }
    source.endRow();
  }
}

struct VertexReader {
  std::array<size_t, 3> coordinates{};
  LocalOrigin origin;

  void read(NumberSource& source, const PlyElement& element, bool wide,
            std::vector<Eigen::Vector3f>& points) {
    points.reserve(element.count);
    std::vector<double> row(element.properties.size());
    for (std::uint64_t i = 0; i < element.count; ++i) {
      source.beginRow();
      for (size_t p = 0; p < row.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        const double length = property.countType ? source.next(*property.countType) : 1;
        if (!(length >= 0)) return source.fail("a list of " + shortestText(length) + " items");
        for (double n = 0; n < length && !source.failed(); ++n) row[p] = source.next(property.type);
      }
      source.endRow();
      if (source.failed()) return;
      const Eigen::Vector3d point(row[coordinates[0]], row[coordinates[1]], row[coordinates[2]]);
      for (const double v : point)
        if (isAbsurdCoordinate(v)) return source.fail("a coordinate of " + shortestText(v) + " m");
      points.push_back(wide                ? origin.shifted(point)
                       : point.allFinite() ? Eigen::Vector3f(point.cast<float>())
                                           : Eigen::Vector3f::Constant(kNaNf));
    }
  }
};

/// The one row of the element camera, by the properties' names.
using Camera = std::map<std::string, double>;

Camera readCamera(NumberSource& source, const PlyElement& element) {
  Camera camera;
  source.beginRow();
  for (const PlyProperty& property : element.properties) camera[property.name] = source.next(property.type);
  source.endRow();
  return camera;
}

/// PCL keeps a cloud's width, height and sensor pose in a camera.
void useCamera(RawCloud& cloud, Camera& camera) {
  Eigen::Matrix3d rotation;
  for (const int row : {0, 1, 2})
    for (const int col : {0, 1, 2})
      rotation(row, col) = camera[std::string(1, "xyz"[row]) + "_axis" + "xyz"[col]];
  const Eigen::Vector3d place(camera["view_px"], camera["view_py"], camera["view_pz"]);
  constexpr double kTolerance = 1e-3;
  const bool sound = place.allFinite() && place.cwiseAbs().maxCoeff() < kMaxCoordinate &&
                     rotation.allFinite() &&
                     (rotation * rotation.transpose()).isApprox(Eigen::Matrix3d::Identity(), kTolerance) &&
                     rotation.determinant() > 0;
  if (sound) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (!rotation.isIdentity(0)) pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    pose.translation() = place;
    cloud.scan_T_sensor = pose;
  }
  const double width = camera["viewportx"], height = camera["viewporty"];
  if (cloud.lines == 0 && width >= 1 && height > 1 &&
      width * height == static_cast<double>(cloud.points.size())) {
    cloud.lines = static_cast<int>(height);
    cloud.beams = static_cast<int>(width);
  }
}

const char* formatName(PlyEncoding encoding) {
  switch (encoding) {
    case PlyEncoding::Ascii:
      return "PLY ascii";
    case PlyEncoding::BinaryLittleEndian:
      return "PLY binary_little_endian";
    default:
      return "PLY binary_big_endian";
  }
}

/// num_cols and num_rows may also describe the vertices themselves.
void layOutGrid(RawCloud& cloud, const PlyHeader& header, const std::vector<std::int64_t>& grid) {
  if (header.columns == 0) return;
  const std::uint64_t places = header.columns * header.rows;
  if (!grid.empty()) {
    std::vector<Eigen::Vector3f> placed(grid.size(), Eigen::Vector3f::Constant(kNaNf));
    for (size_t i = 0; i < grid.size(); ++i)
      if (grid[i] != kNoVertex) placed[i] = cloud.points[static_cast<size_t>(grid[i])];
    cloud.points = std::move(placed);
  } else if (places != cloud.points.size()) {
    cloud.notes.push_back(
        "num_cols · num_rows is not the number of vertices and there is no range grid: they are not used.");
    return;
  }
  cloud.lines = static_cast<int>(header.rows);
  cloud.beams = static_cast<int>(header.columns);
}

}  // namespace

Expected<RawCloud> readPly(const std::string& path, std::string bytes) {
  const auto header = parsePlyHeader(path, bytes);
  if (!header) return header.error();
  RawCloud cloud;
  cloud.format = formatName(header->encoding);
  NumberSource source(path, bytes, *header);
  VertexReader vertices;
  std::vector<std::int64_t> grid;
  std::optional<Camera> camera;
  bool found = false;
  for (const PlyElement& element : header->elements) {
    if (!source.fits(element.count, element)) {
      source.fail(std::to_string(element.count) + " rows of element " + quotedText(element.name) +
                  " do not fit into the rest of the file");
    } else if (element.name == "vertex") {
      found = true;
      cloud.wideCoordinates = header->encoding == PlyEncoding::Ascii;
      for (const PlyProperty& property : element.properties) cloud.fields.push_back(property.name);
      for (size_t axis = 0; axis < 3; ++axis) {
        const std::string name(1, "xyz"[axis]);
        const auto index = element.find(name);
        if (!index)
          return Error{path, "field " + name, "element vertex has no property " + name,
                       "a scan needs x, y and z"};
        const PlyProperty& property = element.properties[*index];
        if (property.countType || !isPlyReal(property.type))
          return Error{path, "field " + name, "not of type float or double",
                       "save the file again with coordinates of type float or double"};
        cloud.wideCoordinates |= property.type == PlyType::Double;
        vertices.coordinates[axis] = *index;
      }
      vertices.read(source, element, cloud.wideCoordinates, cloud.points);
    } else if (element.name == "range_grid" && header->columns > 0 && element.properties.size() == 1 &&
               element.properties[0].countType) {
      if (!found)
        return Error{path, "header", "the range grid comes before its vertices", "save the file again"};
      if (element.count != header->columns * header->rows)
        return Error{path, "header",
                     std::to_string(element.count) +
                         " places in the range grid, but num_cols · num_rows is " +
                         std::to_string(header->columns * header->rows),
                     "correct the header, or save the file again"};
      readGrid(source, element, cloud.points.size(), grid);
    } else if (element.name == "camera" && element.count == 1 && !element.hasLists()) {
      camera = readCamera(source, element);
    } else {
      skipElement(source, element);
      if (element.name == "face" && element.count > 0)
        cloud.notes.push_back(
            "A mesh's vertices: the file tells neither where the scanner stood nor which way is up; the "
            "origin and z are taken.");
    }
    if (source.failed()) return source.error();
  }
  if (!found)
    return Error{path, "header", "there is no element vertex", "a scan needs vertices with x, y and z"};
  source.finish();
  if (source.failed()) return source.error();
  if (source.missingLineEnd())
    cloud.notes.push_back("The last row has no line end; its last number may be cut off.");
  bytes = {};
  cloud.localOrigin = vertices.origin.origin();
  layOutGrid(cloud, *header, grid);
  if (camera) useCamera(cloud, *camera);
  return cloud;
}

}  // namespace stratascope
