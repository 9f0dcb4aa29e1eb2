// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_frame.h"

#include <array>

#include "base/expected.h"

namespace stratascope {

namespace {

struct UnitEntry {
  LengthUnit unit;
  const char* name;
  double metres;
};
constexpr std::array kUnits = {
    UnitEntry{LengthUnit::Auto, "auto", 1},
    UnitEntry{LengthUnit::Metre, "m", 1},
    UnitEntry{LengthUnit::Centimetre, "cm", 0.01},
    UnitEntry{LengthUnit::Millimetre, "mm", 0.001},
    UnitEntry{LengthUnit::Foot, "ft", 0.3048},
    UnitEntry{LengthUnit::SurveyFoot, "us-ft", 1200.0 / 3937.0},
};

struct AxesEntry {
  FileAxes axes;
  const char* name;
  std::array<double, 9> rows;  // forward, left and up in the file's x, y and z
};
constexpr std::array kAxes = {
    AxesEntry{FileAxes::Auto, "auto", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    AxesEntry{FileAxes::ZUp, "z-up", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    AxesEntry{FileAxes::YUp, "y-up", {0, 0, -1, -1, 0, 0, 0, 1, 0}},
    AxesEntry{FileAxes::YUpForward, "y-up-forward", {0, 0, 1, -1, 0, 0, 0, 1, 0}},
    AxesEntry{FileAxes::YDown, "y-down", {0, 0, 1, -1, 0, 0, 0, -1, 0}},
    AxesEntry{FileAxes::ZDown, "z-down", {1, 0, 0, 0, -1, 0, 0, 0, -1}},
};

const UnitEntry& entryOf(LengthUnit unit) {
  for (const UnitEntry& entry : kUnits)
    if (entry.unit == unit) return entry;
  require(false, "no such unit of length");
  return kUnits[0];
}

const AxesEntry& entryOf(FileAxes axes) {
  for (const AxesEntry& entry : kAxes)
    if (entry.axes == axes) return entry;
  require(false, "no such axes");
  return kAxes[0];
}

template <class Entries>
std::vector<std::string> namesOf(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::optional<LengthUnit> lengthUnitFromText(std::string_view text) {
  for (const UnitEntry& entry : kUnits)
    if (text == entry.name) return entry.unit;
  return std::nullopt;
}
const char* lengthUnitName(LengthUnit unit) {
  return entryOf(unit).name;
}
double metresPerUnit(LengthUnit unit) {
  return entryOf(unit).metres;
}
std::vector<std::string> lengthUnitNames() {
  return namesOf(kUnits);
}

std::optional<FileAxes> fileAxesFromText(std::string_view text) {
  for (const AxesEntry& entry : kAxes)
    if (text == entry.name) return entry.axes;
  return std::nullopt;
}
const char* fileAxesName(FileAxes axes) {
  return entryOf(axes).name;
}
Eigen::Matrix3d oursFromFileAxes(FileAxes axes) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entryOf(axes).rows.data());
}
std::vector<std::string> fileAxesNames() {
  return namesOf(kAxes);
}

}  // namespace stratascope
