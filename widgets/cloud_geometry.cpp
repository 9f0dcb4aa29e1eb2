// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cloud_geometry.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <span>
#include <utility>

#include "base/parallel_rows.h"
#include "base/units.h"

namespace stratascope {
namespace {

constexpr size_t kParts = 16;
constexpr int kChunk = 8192;  // points a thread takes at a time

/// Successive points go to parts as evenly as the golden ratio divides a circle.
size_t partOf(std::uint32_t offset) {
  return (offset * 2654435769u) >> 28;
}

std::span<const Eigen::Vector3f> pointsOf(const ScanProducts& scan) {
  if (scan.cloud) return *scan.cloud;
  if (scan.points) return scan.points->points.values();
  return {};
}

/// What is known of the points of one scan, without going by row and beam for each of them.
class PointProducts {
public:
  PointProducts(const ScanProducts& scan, int finalLines) {
    if (scan.cloud) neurons_ = scan.scan->neuronOfPoint;
    ownNeurons_ = !scan.cloud;
    if (scan.classes) classes_ = scan.classes->classes.values();
    if (scan.normals) normals_ = scan.normals->normals.values();
    if (scan.cloudLabels)
      cloudLabels_ = *scan.cloudLabels;
    else if (scan.planes)
      labels_ = scan.planes->labels.values();
    if (const ScanLattice* lattice = scan.scan ? scan.scan->lattice.get() : nullptr;
        lattice && finalLines < lattice->lines())
      provisionalFrom_ = static_cast<size_t>(std::max(0, finalLines)) * static_cast<size_t>(lattice->beams());
  }

  SurfaceClass classOf(std::uint32_t offset) const {
    return at(classes_, neuron(offset), SurfaceClass::Unknown);
  }
  Eigen::Vector3f normal(std::uint32_t offset) const {
    return at(normals_, neuron(offset), Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf)));
  }
  PlaneLabel label(std::uint32_t offset) const {
    return cloudLabels_.empty() ? at(labels_, neuron(offset), kNoPlane) : at(cloudLabels_, offset, kNoPlane);
  }
  bool provisional(std::uint32_t offset) const { return offset >= provisionalFrom_; }

private:
  template <class T>
  static T at(std::span<const T> values, size_t i, T otherwise) {
    return i < values.size() ? values[i] : otherwise;
  }
  /// Past the end of everything where there is none.
  size_t neuron(std::uint32_t offset) const {
    if (ownNeurons_) return offset;
    return static_cast<size_t>(at<std::int32_t>(neurons_, offset, -1));
  }

  bool ownNeurons_;
  std::span<const std::int32_t> neurons_;
  std::span<const SurfaceClass> classes_;
  std::span<const Eigen::Vector3f> normals_;
  std::span<const PlaneLabel> cloudLabels_, labels_;
  size_t provisionalFrom_ = std::numeric_limits<size_t>::max();
};

/// Colours of planes by label; neighbours mostly have the same.
class PlaneColours {
public:
  explicit PlaneColours(const ViewGeometry& g) : g_(g) {}
  Rgb of(PlaneLabel label) {
    if (!known_ || label != label_) colour_ = colourOfPlane(g_.options, g_.numbers.of(label));
    known_ = true;
    label_ = label;
    return colour_;
  }

private:
  const ViewGeometry& g_;
  bool known_ = false;
  PlaneLabel label_ = kNoPlane;
  Rgb colour_;
};

/// begin, end: points
void eachChunk(size_t points, const std::function<void(size_t begin, size_t end)>& body) {
  parallelRows(
      static_cast<int>(points), {},
      [&](int begin, int end) { body(static_cast<size_t>(begin), static_cast<size_t>(end)); }, kChunk);
}

}  // namespace

std::shared_ptr<const CloudGeometry> gatherCloud(const Snapshot& snapshot) {
  auto out = std::make_shared<CloudGeometry>();
  std::array<size_t, kParts> place{};
  for (const ScanProducts& scan : snapshot.scans) {
    const auto points = pointsOf(scan);
    for (size_t i = 0; i < points.size(); ++i)
      place[partOf(static_cast<std::uint32_t>(i))] += points[i].allFinite();
  }
  size_t all = 0;
  for (size_t& p : place) all += std::exchange(p, all);
  out->source.resize(all);
  out->positions.resize(all);
  for (size_t s = 0; s < snapshot.scans.size(); ++s) {
    const auto points = pointsOf(snapshot.scans[s]);
    for (size_t i = 0; i < points.size(); ++i) {
      if (!points[i].allFinite()) continue;
      const auto offset = static_cast<std::uint32_t>(i);
      const size_t at = place[partOf(offset)]++;
      out->source[at] = {static_cast<int>(s), offset};
      out->positions[at] = points[i];
    }
  }
  return out;
}

void colourCloud(ViewGeometry& g) {
  const ViewOptions& options = g.options;
  const std::vector<PointRef>& source = g.cloud->source;
  const std::vector<float> values = cloudValues(*g.snapshot, *g.cloud, options.colouring);
  if (!values.empty()) {
    if (options.cloudRange)
      g.cloudScale = {options.cloudRange->first, options.cloudRange->second, options.colourMap};
    else if (options.colouring == CloudColouring::Height)
      g.cloudScale = {g.heights.low, g.heights.high, options.colourMap};
    else
      g.cloudScale = robustScale(values, leastSpan(options.colouring), options.colourMap);
  }
  std::vector<PointProducts> scans;
  for (const ScanProducts& scan : g.snapshot->scans) scans.emplace_back(scan, g.finalLines);
  std::array<Rgb, kSurfaceClassCount> ofClass;
  for (size_t c = 0; c < ofClass.size(); ++c) ofClass[c] = classColour(static_cast<SurfaceClass>(c));

  auto rgb = std::make_shared<std::vector<std::uint8_t>>(3 * source.size());
  std::array<std::atomic<size_t>, kSurfaceClassCount> counts{};
  eachChunk(source.size(), [&](size_t begin, size_t end) {
    std::array<size_t, kSurfaceClassCount> counted{};
    PlaneColours planes(g);
    for (size_t i = begin; i < end; ++i) {
      const PointRef ref = source[i];
      const PointProducts& scan = scans[static_cast<size_t>(ref.scan)];
      const auto surface = static_cast<size_t>(scan.classOf(ref.offset));
      ++counted[surface];
      Rgb c;
      switch (options.colouring) {
        case CloudColouring::SurfaceClass:
          c = ofClass[surface];
          break;
        case CloudColouring::Plane:
          c = planes.of(scan.label(ref.offset));
          break;
        case CloudColouring::Direction:
          c = directionColour(scan.normal(ref.offset));
          break;
        default:
          c = g.cloudScale.colour(values[i]);
      }
      if (scan.provisional(ref.offset)) c = dimmed(c);
      (*rgb)[3 * i] = c.r;
      (*rgb)[3 * i + 1] = c.g;
      (*rgb)[3 * i + 2] = c.b;
    }
    for (size_t c = 0; c < counted.size(); ++c) counts[c] += counted[c];
  });
  std::ranges::copy(counts, g.classCounts.begin());
  g.cloudRgb = std::move(rgb);
}

std::shared_ptr<const std::vector<std::int32_t>> shownPoints(const ViewGeometry& g) {
  auto shown = std::make_shared<std::vector<std::int32_t>>();
  const auto& positions = g.cloud->positions;
  shown->reserve(positions.size());
  const auto& clip = g.options.clip;
  std::vector<PlaneLabel> hidden;
  for (const std::uint32_t number : g.options.hiddenPlanes)
    if (const PlaneLabel label = g.numbers.labelOf(number); label != kNoPlane) hidden.push_back(label);
  for (size_t i = 0; i < positions.size(); ++i) {
    const Eigen::Vector3f& p = positions[i];
    if (p.z() > g.cut || (clip && !clip->contains(p.cast<double>()))) continue;
    if (!hidden.empty() &&
        std::ranges::find(hidden, labelOf(*g.snapshot, g.cloud->source[i])) != hidden.end())
      continue;
    shown->push_back(static_cast<std::int32_t>(i));
  }
  return shown;
}

}  // namespace stratascope
