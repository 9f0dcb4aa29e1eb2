// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pipeline.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "base/block_pool.h"
#include "base/units.h"
#include "layers/normals.h"
#include "layers/point_layer.h"
#include "layers/surface_class.h"
#include "map/maps.h"
#include "segment/edges.h"
#include "segment/objects.h"

namespace stratascope {

namespace {

/// Products of one scan and the parameters each was made with: a product stands as long as these and what it
/// was made from do.
struct ScanCache {
  /// What was computed of the scan that stood here before: while lines come in, most of it still holds.
  struct Earlier {
    std::shared_ptr<const PointImage> points;
    std::shared_ptr<const NormalImage> normals;
    std::shared_ptr<const ClassImage> classes;  // may be null
    NormalParams normalParams;
    ClassParams classParams;
  };
  std::optional<Earlier> earlier;
  ScanProducts products;
  std::optional<RangeParams> range;
  std::optional<NormalParams> normals;
  std::optional<ClassParams> classes;
  std::optional<std::pair<PlaneParams, double>> planes;
  std::optional<double> edges;

  std::optional<Earlier> asEarlier() const {
    if (!normals) return earlier;
    return Earlier{products.points, products.normals, classes ? products.classes : nullptr, *normals,
                   classes.value_or(ClassParams{})};
  }
  NormalHistory historyOfNormals(const NormalParams& params) const {
    NormalHistory history;
    history.remember = earlier.has_value();
    if (earlier && earlier->normalParams == params)
      history.points = earlier->points.get(), history.normals = earlier->normals.get();
    return history;
  }
  ClassHistory historyOfClasses(const ClassParams& params) const {
    if (!earlier || !earlier->classes || !(earlier->classParams == params)) return {};
    return {earlier->points.get(), earlier->normals.get(), earlier->classes.get()};
  }
};

// The plane of a point of an unordered cloud: that of the neuron that stands for it, if the point lies in it.
std::vector<PlaneLabel> labelsOfCloud(const ScanProducts& scan, double planeDistance) {
  std::unordered_map<PlaneLabel, const Plane*> planes;
  for (const Plane& plane : scan.planes->planes) planes[plane.label] = &plane;
  std::vector<PlaneLabel> labels(scan.cloud->size(), kNoPlane);
  for (size_t i = 0; i < labels.size(); ++i) {
    const std::int32_t neuron = scan.scan->neuronOfPoint[i];
    if (neuron < 0) continue;
    const PlaneLabel label = scan.planes->labels[static_cast<size_t>(neuron)];
    const auto plane = planes.find(label);
    if (plane == planes.end()) continue;
    const Eigen::Vector3f& p = (*scan.cloud)[i];
    const bool isNeuron = p == scan.points->points[static_cast<size_t>(neuron)];
    const double distance = plane->second->normal.dot(p.cast<double>()) - plane->second->offset;
    if (isNeuron || std::abs(distance) <= planeDistance) labels[i] = label;
  }
  return labels;
}

std::vector<Eigen::Vector3f> cloudInMap(const Scan& scan, const RangeParams& params) {
  const RangeLimits limits(scan, params);
  std::vector<Eigen::Vector3f> cloud(scan.cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = scan.cloud[i];
    if (limits.contains(p))
      cloud[i] = (scan.pose.map_T_scan * p.cast<double>()).cast<float>();
    else
      cloud[i] = Eigen::Vector3f::Constant(kNaNf);
  }
  return cloud;
}

}  // namespace

struct Pipeline::State {
  std::vector<ScanCache> scans;
  std::shared_ptr<const CellAssignment> cells;
  std::shared_ptr<const HeightMap> heightMap;
  std::shared_ptr<const IntervalMap> intervalMap;
  std::shared_ptr<const ObjectMap> objectMap;
  std::optional<GridParams> grid;
  std::optional<IntervalParams> intervals;
  std::array<StageReport, kStageCount> reports{};
  std::array<int, kStageCount> executions{};
  std::uint64_t generation = 0;

  std::vector<MapInput> mapInputs() const {
    std::vector<MapInput> inputs;
    for (const ScanCache& c : scans) {
      const ScanProducts& p = c.products;
      if (p.cloud)
        inputs.push_back({*p.cloud, p.cloudLabels ? std::span<const PlaneLabel>(*p.cloudLabels)
                                                  : std::span<const PlaneLabel>{}});
      else
        inputs.push_back({p.points->points.values(),
                          p.planes ? p.planes->labels.values() : std::span<const PlaneLabel>{}});
    }
    return inputs;
  }
};

Pipeline::Pipeline() : state_(std::make_unique<State>()) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

void Pipeline::setScans(std::vector<ScanPtr> scans) {
  State& s = *state_;
  const auto executions = s.executions;
  const auto generation = s.generation;
  std::vector<std::optional<ScanCache::Earlier>> earlier;
  for (const ScanCache& c : s.scans) earlier.push_back(c.asEarlier());
  s = State{};
  s.executions = executions;
  s.generation = generation;
  std::uint64_t base = 0;
  for (ScanPtr& scan : scans) {
    ScanCache cache;
    if (s.scans.size() < earlier.size()) cache.earlier = std::move(earlier[s.scans.size()]);
    cache.products.labelBase = static_cast<PlaneLabel>(base);
    base += scan->lattice->points().size();
    cache.products.scan = std::move(scan);
    s.scans.push_back(std::move(cache));
  }
  require(base < std::numeric_limits<PlaneLabel>::max(), "Pipeline: more neurons than labels");
}

const std::array<int, kStageCount>& Pipeline::executions() const {
  return state_->executions;
}

Expected<SnapshotPtr> Pipeline::run(const PipelineParams& params, const Execution& execution,
                                    const Progress& progress) {
  State& s = *state_;
  if (s.scans.empty()) return Error{"", "", "there is no scan to process", "open one first"};
  const std::vector<std::string> problems = params.validate();
  if (!problems.empty()) {
    std::string all;
    for (const std::string& p : problems) all += (all.empty() ? "" : "; ") + p;
    return Error{"", "parameters", all, ""};
  }

  // Runs a stage over everything that needs it; `work` says whether anything had to be computed.
  auto stage = [&](Stage which, auto&& work) {
    throwIfStopped(execution);
    StageReport& report = s.reports[static_cast<size_t>(which)];
    if (progress) progress(which);
    const auto begin = std::chrono::steady_clock::now();
    const bool ran = work();
    if (ran) {
      report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      ++s.executions[static_cast<size_t>(which)];
    }
    report.reused = !ran;
  };

  bool pointsChanged = false, labelsChanged = false;
  stage(Stage::Points, [&] {
    for (ScanCache& c : s.scans) {
      if (c.range == params.range) continue;
      auto image =
          std::make_shared<const PointImage>(computePoints(*c.products.scan, params.range, execution));
      if (c.products.scan->unordered())
        c.products.cloud =
            std::make_shared<const std::vector<Eigen::Vector3f>>(cloudInMap(*c.products.scan, params.range));
      c.products.points = std::move(image);
      c.range = params.range;
      c.normals.reset();
      pointsChanged = true;
    }
    if (pointsChanged) s.grid.reset();
    return pointsChanged;
  });
  stage(Stage::Normals, [&] {
    bool ran = false;
    for (ScanCache& c : s.scans) {
      if (c.normals == params.normals) continue;
      c.products.normals = std::make_shared<const NormalImage>(
          computeNormals(*c.products.points, params.normals, execution, c.historyOfNormals(params.normals)));
      c.normals = params.normals;
      c.classes.reset();
      c.planes.reset();
      ran = true;
    }
    return ran;
  });
  stage(Stage::Classes, [&] {
    bool ran = false;
    for (ScanCache& c : s.scans) {
      if (c.classes == params.classes) continue;
      c.products.classes = std::make_shared<const ClassImage>(
          computeClasses(*c.products.points, *c.products.normals, params.classes, execution,
                         c.historyOfClasses(params.classes)));
      c.classes = params.classes;
      c.earlier.reset();
      c.planes.reset();
      ran = true;
    }
    return ran;
  });
  stage(Stage::Planes, [&] {
    const std::pair<PlaneParams, double> wanted{params.planes, params.classes.classToleranceDeg};
    for (ScanCache& c : s.scans) {
      if (c.planes == wanted) continue;
      c.products.planes = std::make_shared<const PlaneImage>(
          computePlanes(*c.products.points, *c.products.normals, *c.products.classes, params.planes,
                        params.classes.classToleranceDeg, c.products.labelBase, execution));
      if (c.products.cloud)
        c.products.cloudLabels = std::make_shared<const std::vector<PlaneLabel>>(
            labelsOfCloud(c.products, params.planes.planeDistance));
      c.planes = wanted;
      c.edges.reset();
      labelsChanged = true;
    }
    if (labelsChanged) s.objectMap.reset();
    return labelsChanged;
  });
  stage(Stage::Edges, [&] {
    bool ran = false;
    for (ScanCache& c : s.scans) {
      if (c.edges == params.classes.angleToleranceDeg) continue;
      c.products.edges = std::make_shared<const EdgeSet>(
          computeEdges(*c.products.points, *c.products.classes, *c.products.planes,
                       params.classes.angleToleranceDeg, execution));
      c.edges = params.classes.angleToleranceDeg;
      ran = true;
    }
    return ran;
  });

  const std::vector<MapInput> inputs = s.mapInputs();
  std::optional<Error> failure;
  stage(Stage::Cells, [&] {
    if (s.grid == params.grid) return false;
    Expected<CellAssignment> cells = assignCells(inputs, params.grid, execution);
    if (!cells) {
      failure = cells.error();
      return true;
    }
    s.cells = std::make_shared<const CellAssignment>(std::move(*cells));
    s.grid = params.grid;
    s.heightMap.reset();
    s.intervals.reset();
    return true;
  });
  if (failure) return *failure;
  stage(Stage::HeightMap, [&] {
    if (s.heightMap) return false;
    s.heightMap = std::make_shared<const HeightMap>(buildHeightMap(*s.cells));
    return true;
  });
  stage(Stage::Intervals, [&] {
    if (s.intervals == params.intervals) return false;
    s.intervalMap =
        std::make_shared<const IntervalMap>(buildIntervalMap(*s.cells, params.intervals, execution));
    s.intervals = params.intervals;
    s.objectMap.reset();
    return true;
  });
  stage(Stage::Objects, [&] {
    if (s.objectMap) return false;
    s.objectMap = std::make_shared<const ObjectMap>(buildObjectMap(*s.cells, *s.intervalMap, inputs));
    return true;
  });

  auto snapshot = std::make_shared<Snapshot>();
  snapshot->generation = ++s.generation;
  snapshot->params = params;
  for (const ScanCache& c : s.scans) snapshot->scans.push_back(c.products);
  snapshot->cells = s.cells;
  snapshot->heightMap = s.heightMap;
  snapshot->intervalMap = s.intervalMap;
  snapshot->objectMap = s.objectMap;
  snapshot->stages = s.reports;
  BlockPool::common().startKeeping();  // whoever runs once may run again, and wants the same sizes
  return SnapshotPtr(std::move(snapshot));
}

}  // namespace stratascope
