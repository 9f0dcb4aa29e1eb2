// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "params/param_table.h"

#include <algorithm>

namespace stratascope {
namespace {

using P = PipelineParams;

// The four that decide what a map looks like come first; the rest stays below the fold.
const std::vector<ParamInfo>& table() {
  static const std::vector<ParamInfo> rows = {
      {"epsilon",
       "Height gap",
       "ε",
       "m",
       ParamKind::Real,
       0.001,
       10,
       0.01,
       {},
       "Heights of a cell that lie closer than this are one interval: raising it joins more, up to the "
       "robot's height nothing is "
       "lost for driving; below the vertical spacing of the scan lines walls shatter.",
       "intervals",
       true,
       [](const P& p) { return p.intervals.epsilon; },
       [](P& p, double v) { p.intervals.epsilon = v; }},
      {"epsilon1",
       "Outer radius",
       "ε1",
       "m",
       ParamKind::Real,
       0.001,
       10,
       0.01,
       {},
       "Neighbours farther than this have no say in a normal: raising it steadies normals against range "
       "noise and rounds off "
       "edges and small parts.",
       "normals",
       true,
       [](const P& p) { return p.normals.epsilon1; },
       [](P& p, double v) { p.normals.epsilon1 = v; }},
      {"epsilon2",
       "Inner radius",
       "ε2",
       "m",
       ParamKind::Real,
       0,
       10,
       0.01,
       {},
       "Neighbours nearer than this have no say in a normal: raising it keeps noisy short differences out; "
       "it must stay below "
       "the outer radius.",
       "normals",
       true,
       [](const P& p) { return p.normals.epsilon2; },
       [](P& p, double v) { p.normals.epsilon2 = v; }},
      {"cell",
       "Cell size",
       "dx, dy",
       "m",
       ParamKind::Real,
       0.001,
       10,
       0.01,
       {},
       "Edge of a map cell: raising it gives a coarser, smaller map with fewer empty cells.",
       "height_map",
       true,
       [](const P& p) { return p.grid.cell; },
       [](P& p, double v) { p.grid.cell = v; }},
      {"estimator",
       "Normal estimator",
       "",
       "",
       ParamKind::Choice,
       0,
       2,
       1,
       {"closest", "adaptive", "regression"},
       "How a normal is found: from adjacent beams (fast, very noisy), from the first neighbours inside the "
       "shell, or by least "
       "squares over all points of the shell.",
       "normals",
       false,
       [](const P& p) { return static_cast<double>(p.normals.estimator); },
       [](P& p, double v) { p.normals.estimator = static_cast<NormalEstimator>(static_cast<int>(v)); }},
      {"plane_fit",
       "Plane fit",
       "",
       "",
       ParamKind::Choice,
       0,
       1,
       1,
       {"tls", "paper"},
       "How a plane is fitted: total least squares, or the paper's regression, which cannot hold a plane "
       "through the sensor "
       "and says so.",
       "planes",
       false,
       [](const P& p) { return static_cast<double>(p.planes.fit); },
       [](P& p, double v) { p.planes.fit = static_cast<PlaneFit>(static_cast<int>(v)); }},
      {"intervals",
       "Interval rule",
       "",
       "",
       ParamKind::Choice,
       0,
       1,
       1,
       {"linked", "paper"},
       "How heights become intervals: linked by gaps below the height gap, whatever their order, or the "
       "paper's rule, point by "
       "point in the order of the scan.",
       "intervals",
       false,
       [](const P& p) { return static_cast<double>(p.intervals.rule); },
       [](P& p, double v) { p.intervals.rule = static_cast<IntervalRule>(static_cast<int>(v)); }},
      {"angle_tolerance",
       "Angle tolerance",
       "",
       "°",
       ParamKind::Real,
       0.1,
       60,
       1,
       {},
       "Normals closer than this count as parallel: raising it makes surfaces larger and edges thinner.",
       "classes",
       false,
       [](const P& p) { return p.classes.angleToleranceDeg; },
       [](P& p, double v) { p.classes.angleToleranceDeg = p.planes.angleToleranceDeg = v; }},
      {"class_tolerance",
       "Class tolerance",
       "",
       "°",
       ParamKind::Real,
       0.1,
       45,
       1,
       {},
       "A normal this close to an axis is facing, side or horizontal: raising it leaves fewer surfaces "
       "oblique.",
       "classes",
       false,
       [](const P& p) { return p.classes.classToleranceDeg; },
       [](P& p, double v) { p.classes.classToleranceDeg = v; }},
      {"plane_distance",
       "Plane distance",
       "",
       "m",
       ParamKind::Real,
       0.0005,
       1,
       0.005,
       {},
       "Points farther than this from a plane never belong to it: raising it makes planes swallow noise and "
       "shallow steps.",
       "planes",
       false,
       [](const P& p) { return p.planes.planeDistance; },
       [](P& p, double v) { p.planes.planeDistance = v; }},
      {"min_plane_points",
       "Smallest plane",
       "",
       "",
       ParamKind::Integer,
       3,
       1000000,
       10,
       {},
       "Regions with fewer points than this are no planes: raising it leaves only the large ones.",
       "planes",
       false,
       [](const P& p) { return static_cast<double>(p.planes.minPlanePoints); },
       [](P& p, double v) { p.planes.minPlanePoints = static_cast<int>(v); }},
      {"align_walls",
       "Align to walls",
       "",
       "",
       ParamKind::Flag,
       0,
       1,
       1,
       {},
       "Measures classes against the building's dominant wall direction and not the sensor's: for scans "
       "taken askew.",
       "classes",
       false,
       [](const P& p) { return p.classes.alignWalls ? 1.0 : 0.0; },
       [](P& p, double v) { p.classes.alignWalls = v != 0; }},
      {"join_planes",
       "Join pieces",
       "",
       "",
       ParamKind::Flag,
       0,
       1,
       1,
       {},
       "Gives neighbouring pieces of one plane, split by something in front of it, one label.",
       "planes",
       false,
       [](const P& p) { return p.planes.joinCoplanar ? 1.0 : 0.0; },
       [](P& p, double v) { p.planes.joinCoplanar = v != 0; }},
      {"clean_classes",
       "Clean classes",
       "",
       "",
       ParamKind::Flag,
       0,
       1,
       1,
       {},
       "Lets the majority of the neighbours overrule single neurons of another class.",
       "classes",
       false,
       [](const P& p) { return p.classes.clean ? 1.0 : 0.0; },
       [](P& p, double v) { p.classes.clean = v != 0; }},
      {"min_range",
       "Nearest range",
       "",
       "m",
       ParamKind::Real,
       0,
       10000,
       0.1,
       {},
       "Returns nearer than this are left out: raising it removes the robot itself; 0 is no limit.",
       "range",
       false,
       [](const P& p) { return p.range.minRange; },
       [](P& p, double v) { p.range.minRange = v; }},
      {"max_range",
       "Farthest range",
       "",
       "m",
       ParamKind::Real,
       0,
       10000,
       0.5,
       {},
       "Returns farther than this are left out: raising it lets in more of the distance; 0 is no limit.",
       "range",
       false,
       [](const P& p) { return p.range.maxRange; },
       [](P& p, double v) { p.range.maxRange = v; }},
  };
  return rows;
}

char canonical(char c) {
  return c == '-' ? '_' : c;
}

/// Edits (insert, delete, replace) from one key to another.
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (canonical(a[i - 1]) == canonical(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::span<const ParamInfo> paramTable() {
  return table();
}

const ParamInfo* findParam(std::string_view key) {
  const auto same = [](char a, char b) { return canonical(a) == canonical(b); };
  for (const ParamInfo& info : table()) {
    const std::string_view known = info.key;
    if (std::equal(known.begin(), known.end(), key.begin(), key.end(), same)) return &info;
  }
  return nullptr;
}

const char* nearestParamKey(std::string_view key) {
  // A hostile key may be megabytes long; what follows the longest valid key cannot make another one nearer.
  constexpr size_t kLongEnough = 64;
  key = key.substr(0, kLongEnough);
  const ParamInfo* best = &table().front();
  size_t bestDistance = editDistance(key, best->key);
  for (const ParamInfo& info : table()) {
    const size_t distance = editDistance(key, info.key);
    if (distance < bestDistance) {
      best = &info;
      bestDistance = distance;
    }
  }
  return best->key;
}

}  // namespace stratascope
