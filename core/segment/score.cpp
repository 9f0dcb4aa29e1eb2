// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/score.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/expected.h"
#include "base/units.h"

namespace stratascope {
namespace {

using Label = std::uint32_t;

/// Sizes of regions and of what they share.
struct Overlaps {
  std::map<Label, size_t> truthSize, foundSize;
  std::map<Label, std::map<Label, size_t>> byTruth, byFound;  ///< shared pixels, counted truth only
};

struct Instance {
  RegionVerdict verdict;
  double score;
  std::vector<Label> truth, found;
};

Overlaps overlapsOf(const ScoreInput& input, size_t minTruthPixels) {
  Overlaps overlaps;
  for (const Label label : input.truthLabels)
    if (label >= kFirstTruthPlane) ++overlaps.truthSize[label];
  std::erase_if(overlaps.truthSize, [&](const auto& region) { return region.second < minTruthPixels; });
  for (size_t i = 0; i < input.foundLabels.size(); ++i) {
    const Label found = input.foundLabels[i], truth = input.truthLabels[i];
    if (found == 0) continue;
    ++overlaps.foundSize[found];
    if (!overlaps.truthSize.contains(truth)) continue;
    ++overlaps.byTruth[truth][found];
    ++overlaps.byFound[found][truth];
  }
  return overlaps;
}

/// Found regions that would be correct if true regions below the smallest size counted.
std::set<Label> matchesOfSmall(const ScoreInput& input, const Overlaps& counted,
                               const ScoreOptions& options) {
  const Overlaps all = overlapsOf(input, 1);
  std::set<Label> matches;
  for (const auto& [truth, shared] : all.byTruth) {
    if (counted.truthSize.contains(truth)) continue;
    for (const auto& [found, pixels] : shared)
      if (static_cast<double>(pixels) >= options.overlap * static_cast<double>(all.truthSize.at(truth)) &&
          static_cast<double>(pixels) >= options.overlap * static_cast<double>(all.foundSize.at(found)))
        matches.insert(found);
  }
  return matches;
}

/// One region on one side in two or more pieces on the other.
std::optional<Instance> inPieces(RegionVerdict verdict, Label whole, size_t wholeSize,
                                 const std::map<Label, size_t>& shared,
                                 const std::map<Label, size_t>& pieceSizes, double overlap) {
  std::vector<Label> pieces;
  size_t sum = 0;
  double shares = 0;
  for (const auto& [piece, pixels] : shared) {
    const double share = static_cast<double>(pixels) / static_cast<double>(pieceSizes.at(piece));
    if (share < overlap) continue;
    pieces.push_back(piece);
    sum += pixels;
    shares += share;
  }
  const double covered = static_cast<double>(sum) / static_cast<double>(wholeSize);
  if (pieces.size() < 2 || covered < overlap) return std::nullopt;
  Instance instance{
      verdict, (shares / static_cast<double>(pieces.size()) + covered) / 2, {whole}, std::move(pieces)};
  if (verdict == RegionVerdict::Under) std::swap(instance.truth, instance.found);
  return instance;
}

std::vector<Instance> instancesOf(const Overlaps& overlaps, double overlap) {
  std::vector<Instance> instances;
  for (const auto& [truth, shared] : overlaps.byTruth) {
    const size_t truthSize = overlaps.truthSize.at(truth);
    for (const auto& [found, pixels] : shared) {
      const double ofTruth = static_cast<double>(pixels) / static_cast<double>(truthSize);
      const double ofFound = static_cast<double>(pixels) / static_cast<double>(overlaps.foundSize.at(found));
      if (ofTruth >= overlap && ofFound >= overlap)
        instances.push_back({RegionVerdict::Correct, (ofTruth + ofFound) / 2, {truth}, {found}});
    }
    if (auto over = inPieces(RegionVerdict::Over, truth, truthSize, shared, overlaps.foundSize, overlap))
      instances.push_back(std::move(*over));
  }
  for (const auto& [found, shared] : overlaps.byFound)
    if (auto under = inPieces(RegionVerdict::Under, found, overlaps.foundSize.at(found), shared,
                              overlaps.truthSize, overlap))
      instances.push_back(std::move(*under));
  std::sort(instances.begin(), instances.end(), [](const Instance& a, const Instance& b) {
    return std::tie(b.score, a.verdict, a.truth, a.found) < std::tie(a.score, b.verdict, b.truth, b.found);
  });
  return instances;
}

/// Total least squares over the finite points; nothing below three of them.
std::map<Label, Eigen::Vector3d> fittedNormals(std::span<const Label> labels,
                                               std::span<const Eigen::Vector3f> points) {
  struct Sums {
    size_t count = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  };
  std::map<Label, Sums> sums;
  for (size_t i = 0; i < points.size(); ++i) {
    if (labels[i] == 0 || !points[i].allFinite()) continue;
    Sums& s = sums[labels[i]];
    const Eigen::Vector3d point = points[i].cast<double>(), delta = point - s.mean;
    s.mean += delta / static_cast<double>(++s.count);
    s.scatter += delta * (point - s.mean).transpose();
  }
  std::map<Label, Eigen::Vector3d> normals;
  for (const auto& [label, s] : sums) {
    if (s.count < 3) continue;
    const Eigen::Matrix3d symmetric = (s.scatter + s.scatter.transpose()) / 2;
    normals[label] = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric).eigenvectors().col(0);
  }
  return normals;
}

std::map<Label, Eigen::Vector3d> meanNormals(std::span<const Label> labels,
                                             std::span<const Eigen::Vector3f> normals) {
  std::map<Label, Eigen::Vector3d> sums;
  for (size_t i = 0; i < normals.size(); ++i) {
    if (labels[i] == 0 || !normals[i].allFinite()) continue;
    sums.try_emplace(labels[i], Eigen::Vector3d::Zero()).first->second += normals[i].cast<double>();
  }
  std::erase_if(sums, [](const auto& sum) { return !(sum.second.norm() > 0); });
  for (auto& [label, sum] : sums) sum.normalize();
  return sums;
}

double angleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// The value below which `share` of the sorted values lie (nearest rank).
double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<size_t>(rank, 1, sorted.size()) - 1];
}

void scorePlaneAngles(const ScoreInput& input, SegmentationScore& score) {
  std::map<Label, Eigen::Vector3d> found = input.foundPlaneNormals;
  // merge keeps what is there already: what is known best comes first
  found.merge(fittedNormals(input.foundLabels, input.foundPoints));
  found.merge(meanNormals(input.foundLabels, input.foundNormals));
  std::map<Label, Eigen::Vector3d> truth = meanNormals(input.truthLabels, input.truthNormals);
  truth.merge(
      fittedNormals(input.truthLabels, input.truthPoints.empty() ? input.foundPoints : input.truthPoints));
  std::vector<double> angles;
  double sum = 0;
  for (CorrectPair& pair : score.pairs) {
    const auto a = truth.find(pair.truth), b = found.find(pair.found);
    if (a == truth.end() || b == found.end() || !b->second.allFinite()) continue;
    const double angle = angleDeg(a->second, b->second);
    pair.angleErrorDeg = std::min(angle, 180 - angle);
    angles.push_back(*pair.angleErrorDeg);
    sum += angles.back();
  }
  if (angles.empty()) return;
  std::sort(angles.begin(), angles.end());
  score.planeAngleMeanDeg = sum / static_cast<double>(angles.size());
  score.planeAngleMedianDeg = quantile(angles, 0.5);
  score.planeAngleMaxDeg = angles.back();
}

void scoreNormals(const ScoreInput& input, SegmentationScore& score) {
  const NormalErrors errors = normalErrors(input);
  score.normalPixels = errors.pixels;
  score.normalPixelsFound = errors.anglesDeg.size();
  score.normalWithin10 = errors.shareWithin(10);
  score.normalMedianDeg = errors.quantileDeg(0.5);
  score.normal90Deg = errors.quantileDeg(0.9);
}

}  // namespace

SegmentationScore scoreSegmentation(const ScoreInput& input, const ScoreOptions& options) {
  require(options.overlap > 0.5 && options.overlap <= 1, "scoreSegmentation: overlap must be in (0.5, 1]");
  require(input.foundLabels.size() == input.truthLabels.size(),
          "scoreSegmentation: different numbers of pixels");
  for (const auto& vectors : {input.foundNormals, input.truthNormals, input.foundPoints, input.truthPoints})
    require(vectors.empty() || vectors.size() == input.truthLabels.size(),
            "scoreSegmentation: different numbers of pixels");

  const Overlaps overlaps = overlapsOf(input, options.minTruthPixels);
  SegmentationScore score;
  score.truthRegions = overlaps.truthSize.size();
  score.foundRegions = overlaps.foundSize.size();
  for (const Instance& instance : instancesOf(overlaps, options.overlap)) {
    // best first: an instance whose region stands in a better one is void
    const bool taken = std::any_of(instance.truth.begin(), instance.truth.end(),
                                   [&](Label l) { return score.ofTruth.contains(l); }) ||
                       std::any_of(instance.found.begin(), instance.found.end(),
                                   [&](Label l) { return score.ofFound.contains(l); });
    if (taken) continue;
    for (const Label label : instance.truth) score.ofTruth[label] = instance.verdict;
    for (const Label label : instance.found) score.ofFound[label] = instance.verdict;
    if (instance.verdict == RegionVerdict::Over) ++score.over;
    if (instance.verdict == RegionVerdict::Under) ++score.under;
    if (instance.verdict != RegionVerdict::Correct) continue;
    ++score.correct;
    const Label truth = instance.truth.front(), found = instance.found.front();
    score.pairs.push_back({truth, found, overlaps.byTruth.at(truth).at(found), {}});
  }
  std::sort(score.pairs.begin(), score.pairs.end(),
            [](const auto& a, const auto& b) { return a.truth < b.truth; });

  size_t truthPixels = 0, correctPixels = 0;
  for (const auto& [truth, size] : overlaps.truthSize) {
    truthPixels += size;
    const RegionVerdict verdict = score.ofTruth.try_emplace(truth, RegionVerdict::Missed).first->second;
    if (verdict == RegionVerdict::Correct) correctPixels += size;
    if (verdict == RegionVerdict::Missed) ++score.missed;
  }
  if (truthPixels > 0) score.share = static_cast<double>(correctPixels) / static_cast<double>(truthPixels);
  const std::set<Label> small = matchesOfSmall(input, overlaps, options);
  for (const auto& [found, size] : overlaps.foundSize) {
    if (!score.ofFound.try_emplace(found, RegionVerdict::Noise).second) continue;
    ++score.noise;
    if (small.contains(found)) ++score.noiseSmall;
    size_t onCounted = 0;
    if (const auto shared = overlaps.byFound.find(found); shared != overlaps.byFound.end())
      for (const auto& [truth, pixels] : shared->second) onCounted += pixels;
    if (2 * onCounted < size) ++score.noiseOutside;
  }
  scorePlaneAngles(input, score);
  scoreNormals(input, score);
  return score;
}

NormalErrors normalErrors(const ScoreInput& input) {
  NormalErrors errors;
  if (input.truthNormals.empty() || input.foundNormals.empty()) return errors;
  for (size_t i = 0; i < input.truthNormals.size(); ++i) {
    if (input.truthLabels[i] < kFirstTruthPlane || !input.truthNormals[i].allFinite()) continue;
    ++errors.pixels;
    if (input.foundNormals[i].allFinite())
      errors.anglesDeg.push_back(
          angleDeg(input.truthNormals[i].cast<double>(), input.foundNormals[i].cast<double>()));
  }
  std::sort(errors.anglesDeg.begin(), errors.anglesDeg.end());
  return errors;
}

void NormalErrors::add(const NormalErrors& other) {
  pixels += other.pixels;
  const auto own = static_cast<std::ptrdiff_t>(anglesDeg.size());
  anglesDeg.insert(anglesDeg.end(), other.anglesDeg.begin(), other.anglesDeg.end());
  std::inplace_merge(anglesDeg.begin(), anglesDeg.begin() + own, anglesDeg.end());
}

std::optional<double> NormalErrors::quantileDeg(double share) const {
  return anglesDeg.empty() ? std::nullopt : std::optional(quantile(anglesDeg, share));
}

std::optional<double> NormalErrors::shareWithin(double deg) const {
  if (pixels == 0) return std::nullopt;
  const auto within = std::upper_bound(anglesDeg.begin(), anglesDeg.end(), deg) - anglesDeg.begin();
  return static_cast<double>(within) / static_cast<double>(pixels);
}

}  // namespace stratascope
