// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/edge_planes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "cnn/neighbourhood.h"

namespace stratascope {
namespace {

// Segments between two planes lie on both but for rounding; planes of other pairs pass by farther off.
constexpr double kOnBoth = 1e-4;  // metres
constexpr int kWindow = 3;        // neurons about the end of a jump edge that may be of the plane it ends
constexpr double kSameDepth = 0.05;

/// Both planes through the segment: the two its ends lie on best.
EdgePlanes meeting(const std::vector<Plane>& planes, const Edge& edge) {
  std::array<std::pair<double, PlaneLabel>, 2> best;
  best.fill({std::numeric_limits<double>::infinity(), kNoPlane});
  for (const Plane& plane : planes) {
    const auto off = [&](const Eigen::Vector3d& p) { return std::abs(plane.normal.dot(p) - plane.offset); };
    if (off(edge.from) > kOnBoth || off(edge.to) > kOnBoth) continue;
    const std::pair<double, PlaneLabel> candidate{off(edge.from) + off(edge.to), plane.label};
    if (candidate < best[0]) {
      best[1] = best[0];
      best[0] = candidate;
    } else if (candidate < best[1]) {
      best[1] = candidate;
    }
  }
  if (best[1].second == kNoPlane) return {best[0].second, kNoPlane};
  const auto [low, high] = std::minmax(best[0].second, best[1].second);
  return {low, high};
}

struct LessPoint {
  bool operator()(const Eigen::Vector3f& p, const Eigen::Vector3f& q) const {
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  }
};

/// The plane most neurons beside both ends are of, on the near side.
PlaneLabel ending(const ScanProducts& scan, std::span<const GridIndex> ends) {
  std::map<PlaneLabel, int> votes;
  for (const GridIndex end : ends) {
    const Grid<PlaneLabel>& labels = scan.planes->labels;
    const float here = scan.points->range(end);
    RegularNeighbourhood{kWindow}.forEach(end, labels.rows(), labels.cols(), [&](GridIndex i) {
      if (labels(i) != kNoPlane && std::abs(scan.points->range(i) - here) <= kSameDepth * here)
        ++votes[labels(i)];
    });
  }
  PlaneLabel best = kNoPlane;
  int most = 0;
  for (const auto& [label, count] : votes)
    if (count > most) most = count, best = label;
  return best;
}

}  // namespace

std::vector<EdgePlanes> planesOfEdges(const ScanProducts& scan) {
  if (!scan.edges || !scan.planes || !scan.points) return {};
  const std::vector<Edge>& edges = scan.edges->edges;
  std::vector<EdgePlanes> out(edges.size());
  // A jump edge ends at measured points: they tell its neurons.
  std::map<Eigen::Vector3f, std::vector<size_t>, LessPoint> jumpEnds;
  for (size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].kind != EdgeKind::Jump) {
      out[e] = meeting(scan.planes->planes, edges[e]);
      continue;
    }
    for (const Eigen::Vector3d& end : {edges[e].from, edges[e].to}) jumpEnds[end.cast<float>()].push_back(e);
  }
  if (jumpEnds.empty()) return out;
  // Nearly all points are told apart by one coordinate, which is quicker than looking each up.
  std::array<bool, 4096> maybe{};
  const auto slot = [](const Eigen::Vector3f& p) {
    return (std::bit_cast<std::uint32_t>(p.y()) * 2654435761u) >> 20;
  };
  for (const auto& [end, list] : jumpEnds) maybe[slot(end)] = true;
  std::vector<std::vector<GridIndex>> neurons(edges.size());
  const Grid<Eigen::Vector3f>& points = scan.points->points;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!maybe[slot(points[i])] || !points[i].allFinite()) continue;
    if (const auto at = jumpEnds.find(points[i]); at != jumpEnds.end())
      for (const size_t e : at->second) neurons[e].push_back(points.index(i));
  }
  for (size_t e = 0; e < edges.size(); ++e)
    if (edges[e].kind == EdgeKind::Jump) out[e].a = ending(scan, neurons[e]);
  return out;
}

}  // namespace stratascope
