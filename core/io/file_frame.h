// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stratascope {

/// The unit a file's coordinates are written in.
enum class LengthUnit : std::uint8_t { Auto, Metre, Centimetre, Millimetre, Foot, SurveyFoot };

/// The axes a file's coordinates are written in. Ours are x forward, y left, z up.
enum class FileAxes : std::uint8_t {
  Auto,
  ZUp,         ///< as ours
  YUp,         ///< x right, y up, z backward: computer graphics
  YUpForward,  ///< x right, y up, z forward: left-handed, as UOS scans
  YDown,       ///< x right, y down, z forward: a camera's frame
  ZDown,       ///< x forward, y right, z down: vehicles
};

/// What the caller says about a file's coordinates; Auto = as the format or the file says, else guessed with
/// care.
struct FileFrame {
  LengthUnit unit = LengthUnit::Auto;
  FileAxes axes = FileAxes::Auto;
  bool operator==(const FileFrame&) const = default;
};

/// "auto", "m", "cm", "mm", "ft", "us-ft"; none for any other text.
std::optional<LengthUnit> lengthUnitFromText(std::string_view text);
const char* lengthUnitName(LengthUnit unit);
/// Of the unit; 1 for Auto.
double metresPerUnit(LengthUnit unit);
std::vector<std::string> lengthUnitNames();

/// "auto", "z-up", "y-up", "y-up-forward", "y-down", "z-down"; none for any other text.
std::optional<FileAxes> fileAxesFromText(std::string_view text);
const char* fileAxesName(FileAxes axes);
/// ours_R_file: a signed permutation, so that turning never rounds; the identity for Auto. Determinant −1 for
/// left-handed axes.
Eigen::Matrix3d oursFromFileAxes(FileAxes axes);
std::vector<std::string> fileAxesNames();

}  // namespace stratascope
