// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/units.h"
#include "segment/contacts.h"

namespace stratascope {

namespace {

constexpr size_t kLeastPoints = 8;     // a segment from fewer neurons is a guess
constexpr double kLeastLength = 0.05;  // metres
constexpr double kLargestGap = 0.30;   // along the line: farther apart, and it is two segments
constexpr double kNearLine =
    0.06;  // boundary neurons farther than this from the intersection belong to another edge
constexpr double kStraight = 0.04;  // how far a straight piece of a jump edge may bulge

bool isVertical(const Eigen::Vector3d& direction) {
  return std::abs(direction.normalized().z()) >= std::cos(degToRad(15));
}

// Where two planes touch: their labels, and the neurons on both sides.
using Contacts = std::map<std::pair<PlaneLabel, PlaneLabel>, std::vector<Eigen::Vector3d>>;

Contacts findContacts(const PointImage& points, const PlaneImage& planes) {
  Contacts contacts;
  forEachContact(planes.labels, kNoPlane, [&](GridIndex from, GridIndex to) {
    auto& list = contacts[std::minmax(planes.labels(from), planes.labels(to))];
    list.push_back(points.points(from).cast<double>());
    list.push_back(points.points(to).cast<double>());
  });
  return contacts;
}

void addCreases(const PointImage& points, const PlaneImage& planes, double angleToleranceDeg, EdgeSet& set) {
  std::unordered_map<PlaneLabel, const Plane*> byLabel;
  for (const Plane& p : planes.planes) byLabel[p.label] = &p;
  for (auto& [pair, contact] : findContacts(points, planes)) {
    const Plane &a = *byLabel.at(pair.first), &b = *byLabel.at(pair.second);
    const Eigen::Vector3d cross = a.normal.cross(b.normal);
    if (cross.norm() < std::sin(degToRad(angleToleranceDeg))) continue;
    const Eigen::Vector3d direction = cross.normalized();
    // A point of both planes, nearest the contact's middle.
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& p : contact) middle += p;
    middle /= static_cast<double>(contact.size());
    Eigen::Matrix3d system;
    system << a.normal.transpose(), b.normal.transpose(), direction.transpose();
    const Eigen::Vector3d anchor =
        system.inverse() * Eigen::Vector3d(a.offset, b.offset, direction.dot(middle));

    struct OnLine {
      double t, distance;
    };
    std::vector<OnLine> members;
    for (const auto& p : contact) {
      const double t = direction.dot(p - anchor), distance = (p - anchor - t * direction).norm();
      if (distance <= kNearLine) members.push_back({t, distance});
    }
    std::sort(members.begin(), members.end(), [](const OnLine& x, const OnLine& y) {
      return x.t != y.t ? x.t < y.t : x.distance < y.distance;
    });
    // Normals open away from each other on a convex edge: a's centroid lies behind b's plane.
    const bool convex = b.normal.dot(a.centroid) - b.offset < 0 && a.normal.dot(b.centroid) - a.offset < 0;
    const bool concave = b.normal.dot(a.centroid) - b.offset > 0 && a.normal.dot(b.centroid) - a.offset > 0;
    const bool opens = convex || (!concave && (b.normal - a.normal).dot(b.centroid - a.centroid) > 0);
    for (size_t begin = 0; begin < members.size();) {
      size_t end = begin + 1;
      double sum = members[begin].distance;
      while (end < members.size() && members[end].t - members[end - 1].t <= kLargestGap)
        sum += members[end++].distance;
      const double length = members[end - 1].t - members[begin].t;
      if (end - begin >= kLeastPoints && length >= kLeastLength)
        set.edges.push_back({opens ? EdgeKind::Convex : EdgeKind::Concave, isVertical(direction),
                             anchor + members[begin].t * direction, anchor + members[end - 1].t * direction,
                             end - begin, sum / static_cast<double>(end - begin)});
      begin = end;
    }
  }
}

// ---- jump edges
// -------------------------------------------------------------------------------------------------

using Polyline = std::vector<Eigen::Vector3d>;

void splitStraight(const Polyline& line, size_t begin, size_t end, EdgeSet& set) {
  if (end - begin < kLeastPoints) return;
  const Eigen::Vector3d chord = line[end - 1] - line[begin];
  const double length = chord.norm();
  if (length < kLeastLength) return;
  const Eigen::Vector3d direction = chord / length;
  double worst = 0, sum = 0;
  size_t at = begin;
  for (size_t i = begin; i < end; ++i) {
    const Eigen::Vector3d d = line[i] - line[begin];
    const double distance = (d - direction * direction.dot(d)).norm();
    sum += distance;
    if (distance > worst) worst = distance, at = i;
  }
  if (worst > kStraight && at > begin && at + 1 < end) {
    splitStraight(line, begin, at + 1, set);
    splitStraight(line, at, end, set);
    return;
  }
  set.edges.push_back({EdgeKind::Jump, isVertical(direction), line[begin], line[end - 1], end - begin,
                       sum / static_cast<double>(end - begin)});
}

// Follows jumps between neighbours along `across` from one lattice line (or beam) to the next, on the nearer
// side.
void addJumps(const PointImage& points, const ClassImage& classes, bool acrossBeams, EdgeSet& set) {
  const int steps = acrossBeams ? points.range.rows() : points.range.cols();
  const int width = acrossBeams ? points.range.cols() : points.range.rows();
  auto neuron = [&](int step, int place) {
    return acrossBeams ? GridIndex{step, place} : GridIndex{place, step};
  };
  auto isJump = [&](GridIndex i) { return classes.classes(i) == SurfaceClass::JumpEdge; };

  struct Open {
    int place;
    bool nearIsFirst;
    Polyline line;
    int lastStep;
  };
  std::vector<Open> open, next;
  std::vector<Polyline> done;
  for (int s = 0; s < steps; ++s) {
    next.clear();
    std::vector<char> taken(open.size(), 0);
    for (int w = 0; w + 1 < width; ++w) {
      const GridIndex a = neuron(s, w), b = neuron(s, w + 1);
      if (!isJump(a) || !isJump(b)) continue;
      const double ra = points.range(a), rb = points.range(b);
      // Both sides of a jump are classed as such; it is between them if the depth breaks here.
      if (!(std::abs(ra - rb) > 0.05 * std::min(ra, rb))) continue;
      const bool nearIsFirst = ra < rb;
      const Eigen::Vector3d p = points.points(nearIsFirst ? a : b).cast<double>();
      size_t best = open.size();
      double nearest = 0.15;
      for (size_t o = 0; o < open.size(); ++o) {
        if (taken[o] || open[o].nearIsFirst != nearIsFirst || std::abs(open[o].place - w) > 2) continue;
        const double distance = (open[o].line.back() - p).norm();
        if (distance < nearest) nearest = distance, best = o;
      }
      if (best < open.size()) {
        taken[best] = 1;
        Open line = std::move(open[best]);
        line.place = w, line.lastStep = s;
        line.line.push_back(p);
        next.push_back(std::move(line));
      } else {
        next.push_back({w, nearIsFirst, {p}, s});
      }
    }
    for (size_t o = 0; o < open.size(); ++o)
      if (!taken[o]) done.push_back(std::move(open[o].line));
    std::swap(open, next);
  }
  for (Open& o : open) done.push_back(std::move(o.line));
  for (const Polyline& line : done) splitStraight(line, 0, line.size(), set);
}

}  // namespace

const char* edgeKindName(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Convex:
      return "convex";
    case EdgeKind::Concave:
      return "concave";
    case EdgeKind::Jump:
      return "jump";
  }
  return "";
}

EdgeSet computeEdges(const PointImage& points, const ClassImage& classes, const PlaneImage& planes,
                     double angleToleranceDeg, const Execution& execution) {
  EdgeSet set;
  addCreases(points, planes, angleToleranceDeg, set);
  throwIfStopped(execution);
  addJumps(points, classes, true, set);
  addJumps(points, classes, false, set);
  return set;
}

}  // namespace stratascope
