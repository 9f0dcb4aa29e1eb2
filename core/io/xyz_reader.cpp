// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/xyz_reader.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

constexpr size_t kMaxColumns = 256;

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

/// Splits a row into `columns`. What is wrong with it comes back as text; empty if nothing is.
/// One kind of separator a row: with two kinds a decimal comma would silently become two columns.
std::string splitRow(std::string_view row, std::vector<std::string_view>& columns) {
  columns.clear();
  const auto skipBlanks = [&] {
    while (!row.empty() && isBlank(row.front())) row.remove_prefix(1);
  };
  skipBlanks();
  char separator = 0;
  while (true) {
    size_t end = 0;
    while (end < row.size() && !isBlank(row[end]) && row[end] != ',' && row[end] != ';') ++end;
    if (end == 0) return "an empty column";
    if (columns.size() == kMaxColumns) return "more than 256 columns";
    columns.push_back(row.substr(0, end));
    row.remove_prefix(end);
    skipBlanks();
    if (row.empty()) return {};
    char found = ' ';
    if (row.front() == ',' || row.front() == ';') {
      found = row.front();
      row.remove_prefix(1);
      skipBlanks();
    }
    if (separator != 0 && found != separator) return "mixed separators";
    separator = found;
  }
}

bool isName(std::string_view column) {
  const auto first = static_cast<unsigned char>(column.front());
  return (std::isalpha(first) || first == '_' || first == '"') && !numberFromText(column);
}

std::string plainName(std::string_view column) {
  std::string name;
  for (const char c : column)
    if (c > ' ' && c < 0x7f && c != '"') name += c;
  return name;
}

/// Where x, y and z stand among the names; the first three columns if not all are named just once.
std::array<size_t, 3> coordinateColumns(const std::vector<std::string>& names) {
  std::array<size_t, 3> found{};
  for (size_t axis = 0; axis < 3; ++axis) {
    size_t count = 0;
    for (size_t c = 0; c < names.size(); ++c) {
      if (names[c].size() != 1 || (names[c][0] | 0x20) != "xyz"[axis]) continue;
      found[axis] = c;
      ++count;
    }
    if (count != 1) return {0, 1, 2};
  }
  return found;
}

}  // namespace

Expected<RawCloud> readXyz(const std::string& path, std::string_view bytes) {
  const char* const remedy =
      "each line holds x y z in metres with decimal points, separated by blanks, commas or semicolons";
  RawCloud cloud;
  cloud.format = "XYZ text";
  cloud.wideCoordinates = true;
  std::array<size_t, 3> coordinates = {0, 1, 2};
  std::vector<std::string_view> columns;
  std::uint64_t firstRow = 0;  // its line; 0 = none yet
  LocalOrigin origin;

  TextLines lines(bytes);
  while (lines.next()) {
    std::string_view row = lines.line();
    while (!row.empty() && isBlank(row.back())) row.remove_suffix(1);
    while (!row.empty() && isBlank(row.front())) row.remove_prefix(1);
    if (row.empty() || row.starts_with('#') || row.starts_with("//")) continue;
    if (std::string problem = splitRow(row, columns); !problem.empty())
      return Error{path, lines.where(), problem, remedy};
    if (columns.size() < 3)
      return Error{path, lines.where(), std::to_string(columns.size()) + " of at least 3 columns", remedy};
    if (firstRow == 0) {
      firstRow = lines.number();
      const bool named = std::all_of(columns.begin(), columns.end(), isName);
      for (size_t c = 0; c < columns.size(); ++c)
        cloud.fields.push_back(named   ? plainName(columns[c])
                               : c < 3 ? std::string(1, "xyz"[c])
                                       : "column_" + std::to_string(c + 1));
      if (named) {
        coordinates = coordinateColumns(cloud.fields);
        continue;
      }
    }
    if (columns.size() != cloud.fields.size())
      return Error{path, lines.where(),
                   std::to_string(columns.size()) + " columns, but " + std::to_string(cloud.fields.size()) +
                       " in line " + std::to_string(firstRow),
                   "all lines must have the same columns"};
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (size_t c = 0; c < columns.size(); ++c) {
      const auto number = numberFromText(columns[c]);
      if (!number) return Error{path, lines.where(), quotedText(columns[c]) + " is not a number", remedy};
      for (size_t axis = 0; axis < 3; ++axis)
        if (coordinates[axis] == c) p[static_cast<Eigen::Index>(axis)] = *number;
    }
    for (const double v : p)
      if (isAbsurdCoordinate(v))
        return Error{path, lines.where(), "a coordinate of " + shortestText(v) + " m",
                     "is the file damaged, or in another unit? Coordinates are metres, at most 1e9"};
    if (!lines.hasLineEnd())
      cloud.notes.push_back("The last line has no line end; its last number may be cut off.");
    cloud.points.push_back(origin.shifted(p));
  }
  cloud.localOrigin = origin.origin();
  return cloud;
}

}  // namespace stratascope
