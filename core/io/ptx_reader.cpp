// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ptx_reader.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

const char* const kCutOff = "the file is cut off or its counts are wrong: copy or save it again";
const char* const kRows =
    "each line holds x y z, perhaps an intensity and three colours, with decimal points";

/// Walks lines that are not blank, taking fixed numbers of numbers from them.
class Rows {
public:
  Rows(const std::string& path, std::string_view bytes) : path_(path), lines_(bytes) {}

  bool next() {
    while (lines_.next()) {
      rest_ = lines_.line();
      std::string_view probe = rest_;
      if (!takeToken(probe).empty()) return true;
    }
    rest_ = {};
    return false;
  }

  /// As many numbers as the row has, at most `most`; count tells how many.
  template <size_t most>
  Expected<std::array<double, most>> numbers(size_t& count) {
    std::array<double, most> values{};
    count = 0;
    for (std::string_view token = takeToken(rest_); !token.empty(); token = takeToken(rest_)) {
      if (count == most) return errorHere("more than " + std::to_string(most) + " numbers", kRows);
      const auto number = numberFromText(token);
      if (!number) return errorHere(quotedText(token) + " is not a number", kRows);
      values[count++] = *number;
    }
    return values;
  }

  /// The row's only number, a count.
  std::optional<std::uint64_t> count() {
    const auto value = countFromText(takeToken(rest_));
    return takeToken(rest_).empty() ? value : std::nullopt;
  }

  Error errorHere(std::string what, const char* remedy = kCutOff) const {
    return {path_, lines_.where(), std::move(what), remedy};
  }
  bool hasLineEnd() const { return lines_.hasLineEnd(); }
  /// Rows of three numbers that can still follow: memory stays bounded by the file, whatever its counts say.
  std::uint64_t rowsLeft() const { return (lines_.rest().size() + 1) / 6; }

private:
  const std::string& path_;
  TextLines lines_;
  std::string_view rest_;
};

/// A point's row: x y z, with intensity, with intensity and colours. The number of columns must stay the
/// same.
Expected<Eigen::Vector3d> pointRow(Rows& rows, size_t& columns) {
  size_t count = 0;
  const auto values = rows.numbers<7>(count);
  if (!values) return values.error();
  if (count != 3 && count != 4 && count != 6 && count != 7)
    return rows.errorHere(std::to_string(count) + " numbers", kRows);
  if (columns == 0) columns = count;
  if (count != columns)
    return rows.errorHere(
        std::to_string(count) + " numbers, but " + std::to_string(columns) + " in the rows before", kRows);
  const Eigen::Vector3d p((*values)[0], (*values)[1], (*values)[2]);
  for (const double v : p)
    if (isAbsurdCoordinate(v))
      return rows.errorHere("a coordinate of " + shortestText(v) + " m",
                            "is the file damaged? Coordinates are metres, at most 1e9");
  return p;
}

std::vector<std::string> fieldsOf(size_t columns) {
  std::vector<std::string> fields = {"x", "y", "z"};
  if (columns == 4 || columns == 7) fields.push_back("intensity");
  if (columns >= 6) fields.insert(fields.end(), {"red", "green", "blue"});
  return fields;
}

/// The next row as `wanted` numbers.
template <size_t wanted>
Expected<std::array<double, wanted>> headRow(Rows& rows, const char* what) {
  if (!rows.next()) return rows.errorHere(std::string("the file ends before ") + what);
  size_t count = 0;
  const auto values = rows.numbers<wanted>(count);
  if (!values) return values.error();
  if (count != wanted)
    return rows.errorHere(std::to_string(count) + " numbers instead of " + std::to_string(wanted) + " in " +
                          what);
  for (const double v : *values)
    if (!std::isfinite(v) || std::abs(v) > kMaxCoordinate)
      return rows.errorHere(shortestText(v) + " in " + what);
  return *values;
}

/// The head after its two counts. The registered place and axes say again what the matrix says, so only the
/// matrix counts.
Expected<Eigen::Isometry3d> headPose(Rows& rows) {
  for (int i = 0; i < 4; ++i)
    if (const auto values = headRow<3>(rows, "the scanner's place and axes"); !values) return values.error();
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    const auto values = headRow<4>(rows, "the matrix of the scan");
    if (!values) return values.error();
    for (int col = 0; col < 4; ++col)
      matrix(col, row) = (*values)[static_cast<size_t>(col)];  // written for row vectors
  }
  constexpr double kTolerance = 1e-3;
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  if (!(rotation * rotation.transpose()).isApprox(Eigen::Matrix3d::Identity(), kTolerance) ||
      !(rotation.determinant() > 0) || !(matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).isZero(kTolerance))
    return rows.errorHere("the matrix of the scan is no rotation and shift",
                          "write the identity if the points are in the common frame already");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // A written rotation has few digits: the nearest true one keeps right angles right. The identity stays
  // itself.
  if (!rotation.isIdentity(0)) pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

}  // namespace

Expected<std::vector<RawCloud>> readPtx(const std::string& path, std::string_view bytes) {
  std::vector<RawCloud> scans;
  Rows rows(path, bytes);
  bool more = rows.next();
  if (!more) return rows.errorHere("there is no scan in the file");
  while (more) {
    std::array<std::uint64_t, 2> size{};  // columns, rows
    for (size_t i = 0; i < 2; ++i) {
      if (i > 0 && !rows.next()) return rows.errorHere("the file ends before the number of rows");
      const auto count = rows.count();
      if (!count || *count < 1 || *count > std::numeric_limits<std::int32_t>::max())
        return rows.errorHere(std::string("no number of ") + (i ? "rows" : "columns") +
                                  " from 1 to 2147483647 where a scan begins",
                              "a PTX scan begins with its numbers of columns and rows, a line each");
      size[i] = *count;
    }
    RawCloud cloud;
    cloud.format = "PTX";
    cloud.wideCoordinates = true;
    const auto pose = headPose(rows);
    if (!pose) return pose.error();
    cloud.map_T_scan = *pose;
    const std::uint64_t points = size[0] * size[1];
    if (points > rows.rowsLeft())
      return rows.errorHere(std::to_string(points) +
                            " rows are announced, more than the rest of the file can hold");
    cloud.points.reserve(points);
    LocalOrigin origin;
    size_t columns = 0;
    for (std::uint64_t i = 0; i < points; ++i) {
      if (!rows.next())
        return rows.errorHere("the file ends after " + std::to_string(i) + " of " + std::to_string(points) +
                              " rows");
      const auto p = pointRow(rows, columns);
      if (!p) return p.error();
      cloud.points.push_back(p->isZero(0) ? Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf))
                                          : origin.shifted(*p));
    }
    cloud.localOrigin = origin.origin();
    cloud.fields = fieldsOf(columns);
    cloud.lines = static_cast<int>(size[0]);
    cloud.beams = static_cast<int>(size[1]);
    if (!rows.hasLineEnd())
      cloud.notes.push_back("The last row has no line end; its last number may be cut off.");
    scans.push_back(std::move(cloud));
    more = rows.next();
  }
  return scans;
}

Expected<RawCloud> readPts(const std::string& path, std::string_view bytes) {
  RawCloud cloud;
  cloud.format = "PTS";
  cloud.wideCoordinates = true;
  Rows rows(path, bytes);
  LocalOrigin origin;
  size_t columns = 0;
  size_t blocks = 0;
  while (rows.next()) {
    const auto count = rows.count();
    if (!count)
      return rows.errorHere("no number of points where a block begins",
                            "a PTS file begins with its number of points; name a file without it .xyz");
    if (*count > rows.rowsLeft())
      return rows.errorHere(std::to_string(*count) +
                            " rows are announced, more than the rest of the file can hold");
    for (std::uint64_t i = 0; i < *count; ++i) {
      if (!rows.next())
        return rows.errorHere("the file ends after " + std::to_string(i) + " of " + std::to_string(*count) +
                              " rows");
      const auto p = pointRow(rows, columns);
      if (!p) return p.error();
      cloud.points.push_back(origin.shifted(*p));
    }
    ++blocks;
  }
  if (blocks == 0) return rows.errorHere("there is no point in the file");
  if (!rows.hasLineEnd())
    cloud.notes.push_back("The last row has no line end; its last number may be cut off.");
  if (blocks > 1) cloud.notes.push_back(std::to_string(blocks) + " blocks of points are taken as one cloud.");
  cloud.localOrigin = origin.origin();
  cloud.fields = fieldsOf(columns);
  return cloud;
}

}  // namespace stratascope
