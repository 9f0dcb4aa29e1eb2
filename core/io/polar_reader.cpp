// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/polar_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"
#include "io/text_lines.h"
#include "scan/scanner_geometry.h"

namespace stratascope {

namespace {

constexpr std::string_view kMark = "# polar scan";
const char* const kRemedy = "see the help page on file formats for the polar format";

enum Column { Line, Beam, Range, HeadElevation, BeamAngle, ColumnCount };
constexpr std::array<std::string_view, ColumnCount> kColumns = {"line", "beam", "range", "head_elevation",
                                                                "beam_angle"};

enum Key { HeadFirst, HeadStep, BeamFirst, BeamStep, KeyCount };
constexpr std::array<std::string_view, KeyCount> kKeys = {"head_elevation_first", "head_elevation_step",
                                                          "beam_first", "beam_step"};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Cells of a row. With commas or semicolons a cell may be empty: a range left out.
std::vector<std::string_view> cellsOf(std::string_view row, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') {
    for (std::string_view token = takeToken(row); !token.empty(); token = takeToken(row))
      cells.push_back(token);
    return cells;
  }
  while (true) {
    const size_t end = std::min(row.find(separator), row.size());
    cells.push_back(trimmed(row.substr(0, end)));
    if (end == row.size()) return cells;
    row.remove_prefix(end + 1);
  }
}

char separatorOf(std::string_view row) {
  return row.find(';') != row.npos ? ';' : row.find(',') != row.npos ? ',' : ' ';
}

bool namesTheColumns(std::string_view row) {
  const auto cells = cellsOf(row, separatorOf(row));
  return std::all_of(kColumns.begin(), kColumns.begin() + HeadElevation, [&](std::string_view name) {
    return std::count(cells.begin(), cells.end(), name) == 1;
  });
}

struct Reading {
  std::uint32_t line = 0, beam = 0;
  double range = kNaN, headElevation = kNaN, beamAngle = kNaN;  // metres, degrees
};

class PolarParser {
public:
  PolarParser(const std::string& path, std::string_view bytes)
      : path_(path), lines_(bytes), fileBytes_(bytes.size()) {}

  Expected<RawCloud> parse() {
    while (lines_.next()) {
      const std::string_view row = trimmed(lines_.line());
      std::string problem;
      if (row.empty()) continue;
      if (row.starts_with('#'))
        problem = columns_.empty() ? takeKey(trimmed(row.substr(1))) : std::string();
      else if (columns_.empty())
        problem = takeNames(row);
      else
        problem = takeReading(row);
      if (!problem.empty()) return Error{path_, lines_.where(), problem, kRemedy};
    }
    if (readings_.empty()) return Error{path_, lines_.where(), "there is no reading in the file", kRemedy};
    if (announced_ && *announced_ != readings_.size())
      return Error{path_, lines_.where(),
                   std::to_string(readings_.size()) + " readings instead of " + std::to_string(*announced_),
                   "the file may be cut off: copy it again"};
    auto cloud = layOut();
    if (cloud && !lines_.hasLineEnd())
      cloud->notes.push_back("The last line has no line end; its last number may be cut off.");
    return cloud;
  }

private:
  std::string takeKey(std::string_view text) {
    const std::string_view name = takeToken(text);
    const std::string_view value = trimmed(text);
    if (name == "range_unit") {
      const auto unit = lengthUnitFromText(value);
      if (!unit || *unit == LengthUnit::Auto)
        return "range_unit " + quotedText(value) + " is not m, cm, mm, ft or us-ft";
      metres_ = metresPerUnit(*unit);
    }
    if (name == "readings") {
      if (announced_) return "readings is there twice";
      announced_ = countFromText(value);
      if (!announced_) return "readings " + quotedText(value) + " is not a count";
    }
    for (size_t k = 0; k < KeyCount; ++k) {
      if (name != kKeys[k]) continue;
      const auto number = numberFromText(value);
      if (!number || !(std::abs(*number) <= 360))
        return std::string(name) + " " + quotedText(value) + " is not an angle in degrees";
      if (!std::isnan(keys_[k])) return std::string(name) + " is there twice";
      keys_[k] = *number;
    }
    return {};
  }

  std::string takeNames(std::string_view row) {
    separator_ = separatorOf(row);
    columns_ = cellsOf(row, separator_);
    if (columns_.size() > 256) return "more than 256 columns";
    for (size_t c = 0; c < ColumnCount; ++c) {
      const auto count = std::count(columns_.begin(), columns_.end(), kColumns[c]);
      if (count > 1) return "column " + std::string(kColumns[c]) + " is there twice";
      if (count == 0 && c < HeadElevation) return "no column " + std::string(kColumns[c]);
      if (count == 1)
        at_[c] =
            static_cast<int>(std::find(columns_.begin(), columns_.end(), kColumns[c]) - columns_.begin());
    }
    const auto given = [&](Key first, Key step) {
      return !std::isnan(keys_[first]) && !std::isnan(keys_[step]);
    };
    if (at_[HeadElevation] < 0 && !given(HeadFirst, HeadStep))
      return "neither head_elevation_first and head_elevation_step nor a column head_elevation";
    if (at_[BeamAngle] < 0 && !given(BeamFirst, BeamStep))
      return "neither beam_first and beam_step nor a column beam_angle";
    return {};
  }

  std::string takeReading(std::string_view row) {
    const auto cells = cellsOf(row, separator_);
    if (cells.size() != columns_.size())
      return std::to_string(cells.size()) + " columns instead of " + std::to_string(columns_.size());
    Reading reading;
    for (const Column c : {Line, Beam}) {
      const auto count = countFromText(cells[static_cast<size_t>(at_[c])]);
      if (!count || *count >= std::numeric_limits<std::int32_t>::max())
        return std::string(kColumns[c]) + " " + quotedText(cells[static_cast<size_t>(at_[c])]) +
               " is not a number from 0";
      (c == Line ? reading.line : reading.beam) = static_cast<std::uint32_t>(*count);
    }
    for (size_t c = 0; c < cells.size(); ++c) {
      if (static_cast<int>(c) == at_[Line] || static_cast<int>(c) == at_[Beam]) continue;
      const auto number =
          cells[c].empty() && static_cast<int>(c) == at_[Range] ? kNaN : numberFromText(cells[c]);
      if (!number) return quotedText(cells[c]) + " is not a number";
      if (static_cast<int>(c) == at_[Range]) reading.range = *number * metres_;
      if (static_cast<int>(c) == at_[HeadElevation]) reading.headElevation = *number;
      if (static_cast<int>(c) == at_[BeamAngle]) reading.beamAngle = *number;
    }
    if (isAbsurdCoordinate(reading.range)) return "a range of " + shortestText(reading.range) + " m";
    if (at_[HeadElevation] < 0) reading.headElevation = keys_[HeadFirst] + reading.line * keys_[HeadStep];
    if (at_[BeamAngle] < 0) reading.beamAngle = keys_[BeamFirst] + reading.beam * keys_[BeamStep];
    if (!(std::abs(reading.headElevation) <= 360))
      return "a head elevation of " + shortestText(reading.headElevation) + " degrees";
    if (!(reading.beamAngle >= 0 && reading.beamAngle <= 180))
      return "a beam angle of " + shortestText(reading.beamAngle) + " degrees, not 0 to 180";
    readings_.push_back(reading);
    return {};
  }

  Expected<RawCloud> layOut() const {
    std::uint64_t lines = 0, beams = 0;
    for (const Reading& r : readings_) {
      lines = std::max<std::uint64_t>(lines, r.line + 1ULL);
      beams = std::max<std::uint64_t>(beams, r.beam + 1ULL);
    }
    if (!latticeIsWarranted(lines, beams, readings_.size(), fileBytes_))
      return Error{
          path_, "",
          std::to_string(readings_.size()) + " readings for " + std::to_string(lines) + " lines of " +
              std::to_string(beams) + " beams",
          "are line and beam mixed up with something else? Most places of the lattice need a reading"};
    RawCloud cloud;
    cloud.format = "polar text";
    cloud.said = {LengthUnit::Metre, FileAxes::ZUp};
    for (const std::string_view name : columns_) cloud.fields.emplace_back(name);
    cloud.lines = static_cast<int>(lines);
    cloud.beams = static_cast<int>(beams);
    cloud.points.assign(lines * beams, Eigen::Vector3f::Constant(kNaNf));
    std::vector<char> taken(cloud.points.size(), 0);
    for (const Reading& r : readings_) {
      const size_t place = r.line * beams + r.beam;
      if (taken[place]++)
        return Error{path_, "line " + std::to_string(r.line) + ", beam " + std::to_string(r.beam),
                     "two readings", "keep one of them"};
      if (!(r.range > 0) || !std::isfinite(r.range)) continue;
      cloud.points[place] =
          pointFromPolar({r.range, headAngleFromElevation(degToRad(r.headElevation)), degToRad(r.beamAngle)})
              .cast<float>();
    }
    return cloud;
  }

  const std::string& path_;
  TextLines lines_;
  std::uint64_t fileBytes_;
  std::vector<std::string_view> columns_;
  char separator_ = ',';
  std::array<int, ColumnCount> at_ = {-1, -1, -1, -1, -1};
  std::array<double, KeyCount> keys_ = {kNaN, kNaN, kNaN, kNaN};
  double metres_ = 1;
  std::optional<std::uint64_t> announced_;
  std::vector<Reading> readings_;
};

}  // namespace

bool looksLikePolar(std::string_view bytes) {
  constexpr size_t kLooked = 4096;
  TextLines lines(bytes.substr(0, kLooked));
  while (lines.next()) {
    const std::string_view row = trimmed(lines.line());
    if (row.starts_with(kMark)) return true;
    if (!row.empty() && !row.starts_with('#')) return namesTheColumns(row);
  }
  return false;
}

Expected<RawCloud> readPolar(const std::string& path, std::string_view bytes) {
  return PolarParser(path, bytes).parse();
}

}  // namespace stratascope
