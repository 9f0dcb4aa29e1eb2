// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>

#include "base/block_pool.h"
#include "base/stopwatch.h"
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
  std::optional<PlaneParams> planes;
  std::optional<PlaneImage> unnamed;  ///< planes that have no names yet
  std::optional<double> names;        ///< the tolerance of classes
  std::optional<double> edges;        ///< the tolerance of angles

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
std::vector<PlaneLabel> labelsOfCloud(const ScanProducts& scan, const PlaneImage& image,
                                      double planeDistance) {
  std::unordered_map<PlaneLabel, const Plane*> planes;
  for (const Plane& plane : image.planes) planes[plane.label] = &plane;
  std::vector<PlaneLabel> labels(scan.cloud->size(), kNoPlane);
  for (size_t i = 0; i < labels.size(); ++i) {
    const std::int32_t neuron = scan.scan->neuronOfPoint[i];
    if (neuron < 0) continue;
    const PlaneLabel label = image.labels[static_cast<size_t>(neuron)];
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
      if (c.products.cloud)
        inputs.push_back({*c.products.cloud, {}});
      else
        inputs.push_back({c.products.points->points.values(), {}, c.products.points->bounds});
    }
    return inputs;
  }
  std::vector<MapInput> labelledInputs() const {
    std::vector<MapInput> inputs = mapInputs();
    for (size_t i = 0; i < inputs.size(); ++i) {
      const ScanProducts& p = scans[i].products;
      if (p.cloud)
        inputs[i].labels = *p.cloudLabels;
      else
        inputs[i].labels = p.planes->labels.values();
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

/// One run over all stages, with what is kept from the runs before.
class Pipeline::Run {
public:
  Run(State& state, const PipelineParams& params, const Execution& execution, const Progress& progress)
      : s_(state), params_(params), execution_(execution), progress_(progress) {}

  /// An error if the map cannot be made.
  std::optional<Error> everything() {
    stage(Stage::Points, [this] { return points(); });
    stage(Stage::Normals, [this] { return normals(); });
    if (execution_.oneStageAtATime) {
      stage(Stage::Classes, [this] { return classes(); });
      announce(Stage::Planes);
      segment();
      timed(
          Stage::Planes, [this] { return name(); }, segmentSeconds_);
      stage(Stage::Edges, [this] { return edges(); });
      stage(Stage::Cells, [this] { return cells(); });
      stage(Stage::HeightMap, [this] { return heightMap(); });
      stage(Stage::Intervals, [this] { return intervals(); });
      if (!failure_) stage(Stage::Objects, [this] { return objects(); });
    } else {
      announce(Stage::Classes);
      announce(Stage::Planes);
      classesPlanesMaps();
      timed(
          Stage::Planes, [this] { return name(); }, segmentSeconds_);
      for (const Stage which :
           {Stage::Edges, Stage::Cells, Stage::HeightMap, Stage::Intervals, Stage::Objects})
        announce(which);
      if (!failure_)
        sideBySide({[this] { timed(Stage::Edges, [this] { return edges(); }); },
                    [this] { timed(Stage::Objects, [this] { return objects(); }); }});
    }
    return failure_;
  }

private:
  void announce(Stage which) const {
    throwIfStopped(execution_);
    if (progress_) progress_(which);
  }
  /// `work` does what a stage needs for everything and says whether anything had to be computed.
  template <class Work>
  void timed(Stage which, const Work& work, double secondsBefore = 0) {
    StageReport& report = s_.reports[static_cast<size_t>(which)];
    const Stopwatch watch;
    const bool ran = work();
    if (ran) {
      report.seconds = secondsBefore + watch.seconds();
      ++s_.executions[static_cast<size_t>(which)];
    }
    report.reused = !ran;
  }
  template <class Work>
  void stage(Stage which, const Work& work) {
    announce(which);
    timed(which, work);
  }

  using Work = std::function<void()>;
  void sideBySide(const std::vector<Work>& works) const {
    parallelRows(
        static_cast<int>(works.size()), execution_,
        [&](int begin, int end) {
          for (int i = begin; i < end; ++i) works[static_cast<size_t>(i)]();
        },
        1);
  }

  // They need nothing of each other: where one goes on step by step on a single thread, another has the rest.
  // The longest comes first.
  void classesPlanesMaps() {
    const auto anyScan = [this](const auto& needs) { return std::ranges::any_of(s_.scans, needs); };
    std::vector<Work> needed;
    const auto add = [&](bool isNeeded, Work work) {
      if (isNeeded)
        needed.push_back(std::move(work));
      else
        work();  // says that nothing has to be done
    };
    add(anyScan([this](const ScanCache& c) { return c.planes != params_.planes; }), [this] { segment(); });
    add(anyScan([this](const ScanCache& c) { return c.classes != params_.classes; }),
        [this] { timed(Stage::Classes, [this] { return classes(); }); });
    add(s_.grid != params_.grid || !s_.heightMap || s_.intervals != params_.intervals, [this] {
      timed(Stage::Cells, [this] { return cells(); });
      timed(Stage::HeightMap, [this] { return heightMap(); });
      timed(Stage::Intervals, [this] { return intervals(); });
    });
    sideBySide(needed);
  }

  bool points() {
    bool ran = false;
    for (ScanCache& c : s_.scans) {
      if (c.range == params_.range) continue;
      auto image =
          std::make_shared<const PointImage>(computePoints(*c.products.scan, params_.range, execution_));
      if (c.products.scan->unordered())
        c.products.cloud =
            std::make_shared<const std::vector<Eigen::Vector3f>>(cloudInMap(*c.products.scan, params_.range));
      c.products.points = std::move(image);
      c.range = params_.range;
      c.normals.reset();
      ran = true;
    }
    if (ran) s_.grid.reset();
    return ran;
  }

  bool normals() {
    bool ran = false;
    for (ScanCache& c : s_.scans) {
      if (c.normals == params_.normals) continue;
      c.products.normals = std::make_shared<const NormalImage>(computeNormals(
          *c.products.points, params_.normals, execution_, c.historyOfNormals(params_.normals)));
      c.normals = params_.normals;
      c.classes.reset();
      c.planes.reset();
      ran = true;
    }
    return ran;
  }

  bool classes() {
    bool ran = false;
    for (ScanCache& c : s_.scans) {
      if (c.classes == params_.classes) continue;
      c.products.classes = std::make_shared<const ClassImage>(
          computeClasses(*c.products.points, *c.products.normals, params_.classes, execution_,
                         c.historyOfClasses(params_.classes)));
      c.classes = params_.classes;
      c.earlier.reset();
      c.names.reset();
      c.edges.reset();
      ran = true;
    }
    return ran;
  }

  void segment() {
    const Stopwatch watch;
    for (ScanCache& c : s_.scans) {
      if (c.planes == params_.planes) continue;
      c.unnamed = computePlanes(*c.products.points, *c.products.normals, params_.planes, c.products.labelBase,
                                execution_);
      if (c.products.cloud)
        c.products.cloudLabels = std::make_shared<const std::vector<PlaneLabel>>(
            labelsOfCloud(c.products, *c.unnamed, params_.planes.planeDistance));
      c.planes = params_.planes;
    }
    segmentSeconds_ = watch.seconds();
  }

  bool name() {
    const double tolerance = params_.classes.classToleranceDeg;
    bool ran = false;
    for (ScanCache& c : s_.scans) {
      if (!c.unnamed && c.names == tolerance) continue;
      if (c.unnamed) c.edges.reset(), s_.objectMap.reset();
      PlaneImage image = c.unnamed ? std::move(*c.unnamed) : *c.products.planes;
      c.unnamed.reset();
      namePlanes(image, *c.products.classes, tolerance, c.products.points->sensor.z());
      c.products.planes = std::make_shared<const PlaneImage>(std::move(image));
      c.names = tolerance;
      ran = true;
    }
    return ran;
  }

  bool edges() {
    bool ran = false;
    for (ScanCache& c : s_.scans) {
      if (c.edges == params_.classes.angleToleranceDeg) continue;
      c.products.edges = std::make_shared<const EdgeSet>(
          computeEdges(*c.products.points, *c.products.classes, *c.products.planes,
                       params_.classes.angleToleranceDeg, execution_));
      c.edges = params_.classes.angleToleranceDeg;
      ran = true;
    }
    return ran;
  }

  bool cells() {
    if (s_.grid == params_.grid) return false;
    Expected<CellAssignment> cells = assignCells(s_.mapInputs(), params_.grid, execution_);
    if (!cells) {
      failure_ = cells.error();
      return true;
    }
    s_.cells = std::make_shared<const CellAssignment>(std::move(*cells));
    s_.grid = params_.grid;
    s_.heightMap.reset();
    s_.intervals.reset();
    return true;
  }

  bool heightMap() {
    if (failure_ || s_.heightMap) return false;
    s_.heightMap = std::make_shared<const HeightMap>(buildHeightMap(*s_.cells));
    return true;
  }

  bool intervals() {
    if (failure_ || s_.intervals == params_.intervals) return false;
    s_.intervalMap =
        std::make_shared<const IntervalMap>(buildIntervalMap(*s_.cells, params_.intervals, execution_));
    s_.intervals = params_.intervals;
    s_.objectMap.reset();
    return true;
  }

  bool objects() {
    if (s_.objectMap) return false;
    s_.objectMap =
        std::make_shared<const ObjectMap>(buildObjectMap(*s_.cells, *s_.intervalMap, s_.labelledInputs()));
    return true;
  }

  State& s_;
  const PipelineParams& params_;
  const Execution& execution_;
  const Progress& progress_;
  std::optional<Error> failure_;
  double segmentSeconds_ = 0;
};

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
  const Stopwatch watch;
  if (const std::optional<Error> failure = Run(s, params, execution, progress).everything()) return *failure;

  auto snapshot = std::make_shared<Snapshot>();
  snapshot->generation = ++s.generation;
  snapshot->params = params;
  for (const ScanCache& c : s.scans) snapshot->scans.push_back(c.products);
  snapshot->cells = s.cells;
  snapshot->heightMap = s.heightMap;
  snapshot->intervalMap = s.intervalMap;
  snapshot->objectMap = s.objectMap;
  snapshot->stages = s.reports;
  snapshot->seconds = watch.seconds();
  BlockPool::common().startKeeping();  // whoever runs once may run again, and wants the same sizes
  return SnapshotPtr(std::move(snapshot));
}

}  // namespace stratascope
