// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace stratascope {

/// True labels from here on are planes (SynPEB's convention).
inline constexpr std::uint32_t kFirstTruthPlane = 10;

/// A segmentation beside the truth, pixel by pixel in the same order (lattice order, but neighbourhood plays
/// no part). Labels are needed; every other span may be empty, and what depends on it is then absent from the
/// score. All spans that are not empty have the same length; else std::logic_error.
struct ScoreInput {
  std::span<const std::uint32_t> foundLabels;                   ///< 0 = no plane
  std::span<const std::uint32_t> truthLabels;                   ///< >= 10 a plane, below none
  std::span<const Eigen::Vector3f> foundNormals, truthNormals;  ///< unit, toward the sensor; NaN = none
  std::span<const Eigen::Vector3f> foundPoints, truthPoints;    ///< NaN = none
  /// Normals of found planes, if known. Otherwise, in this order: fitted to foundPoints, mean of
  /// foundNormals. True planes: mean of truthNormals, or else fitted to truthPoints, or to foundPoints where
  /// truth has labels only.
  std::map<std::uint32_t, Eigen::Vector3d> foundPlaneNormals;
};

struct ScoreOptions {
  double overlap = 0.8;              ///< Hoover's tolerance T, in (0.5, 1]; else std::logic_error
  std::size_t minTruthPixels = 100;  ///< smaller true regions are not counted, neither as found nor as missed
};

/// How a true and a found region came to be counted.
enum class RegionVerdict : std::uint8_t { Correct, Over, Under, Missed, Noise };

struct CorrectPair {
  std::uint32_t truth = 0, found = 0;
  std::size_t overlap = 0;              ///< pixels in both
  std::optional<double> angleErrorDeg;  ///< between the planes, 0…90; absent without normals or points
};

/// Counts of Hoover et al., "An experimental comparison of range image segmentation algorithms" (PAMI 1996).
/// With O pixels shared, |M| in a found region, |G| in a true one:
///   correct  O >= T|M| and O >= T|G|
///   over     one G, two or more M: every O >= T|M|, and their sum >= T|G|
///   under    one M, two or more G: every O >= T|G|, and their sum >= T|M|
///   missed   G in none of these; noise: M in none of these
/// A region that could stand in several stands in the one with the highest score, the mean of the two overlap
/// fractions (over and under: of the mean share of the pieces and the share of the sum); on equal scores
/// correct before over before under.
struct SegmentationScore {
  std::size_t truthRegions = 0, foundRegions = 0;
  std::size_t correct = 0;
  std::size_t over = 0;          ///< true regions found in pieces
  std::size_t under = 0;         ///< found regions that join true ones
  std::size_t missed = 0;        ///< true regions
  std::size_t noise = 0;         ///< found regions
  std::size_t noiseSmall = 0;    ///< of these, regions that match a true one too small to count
  std::size_t noiseOutside = 0;  ///< of these, regions with more than half their pixels on truth that is not
                                 ///< counted (small, curved, nothing)
  /// Pixels of correctly found true regions / pixels of all true regions; 0 without regions.
  double share = 0;
  std::vector<CorrectPair> pairs;                  ///< by truth label
  std::map<std::uint32_t, RegionVerdict> ofTruth;  ///< counted true regions
  std::map<std::uint32_t, RegionVerdict> ofFound;

  /// Over correct pairs whose angle is known.
  std::optional<double> planeAngleMeanDeg, planeAngleMedianDeg, planeAngleMaxDeg;

  /// Over pixels with a truth label >= 10 and a truth normal; angles 0…180, since both sides turn normals to
  /// the sensor.
  std::size_t normalPixels = 0;                        ///< such pixels
  std::size_t normalPixelsFound = 0;                   ///< of these, with a found normal
  std::optional<double> normalMedianDeg, normal90Deg;  ///< over normalPixelsFound
  /// Share of normalPixels within 10°; without a found normal = not within.
  std::optional<double> normalWithin10;
};

SegmentationScore scoreSegmentation(const ScoreInput& input, const ScoreOptions& options = {});

/// Angles between found and true normals, over pixels with a truth label >= 10 and a truth normal; those of
/// several scans can be joined. Degrees, 0…180.
struct NormalErrors {
  std::size_t pixels = 0;         ///< such pixels
  std::vector<double> anglesDeg;  ///< ascending; of those with a found normal

  void add(const NormalErrors& other);
  /// The angle below which `share` of anglesDeg lie (nearest rank); nothing without angles.
  std::optional<double> quantileDeg(double share) const;
  /// Share of `pixels` with an angle up to `deg`; without a found normal = not within. Nothing without
  /// pixels.
  std::optional<double> shareWithin(double deg) const;
};
/// Empty if one of the normals is.
NormalErrors normalErrors(const ScoreInput& input);

}  // namespace stratascope
