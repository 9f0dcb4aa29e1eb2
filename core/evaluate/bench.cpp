// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/bench.h"

#include <algorithm>
#include <cstring>
#include <thread>

#include "base/stopwatch.h"
#include "evaluate/methods.h"
#include "evaluate/statistics.h"
#include "interop/peers.h"
#include "layers/point_layer.h"
#include "pipeline/pipeline.h"

namespace stratascope {
namespace {

/// Peers that take seconds need not run as often as what takes milliseconds.
constexpr int kRunsOfSlowPeers = 3;

template <class T>
bool sameBytes(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

bool sameProducts(const Snapshot& a, const Snapshot& b) {
  const ScanProducts &p = a.scans.front(), &q = b.scans.front();
  return sameBytes(p.normals->normals.values(), q.normals->normals.values()) &&
         sameBytes(p.classes->classes.values(), q.classes->classes.values()) &&
         sameBytes(p.planes->labels.values(), q.planes->labels.values()) &&
         sameBytes(std::span<const float>(a.heightMap->height),
                   std::span<const float>(b.heightMap->height)) &&
         sameBytes(std::span<const HeightInterval>(a.intervalMap->records),
                   std::span<const HeightInterval>(b.intervalMap->records)) &&
         sameBytes(std::span<const PlaneLabel>(a.objectMap->labels),
                   std::span<const PlaneLabel>(b.objectMap->labels));
}

/// Our own runs, and what they took.
class OwnRuns {
public:
  OwnRuns(const TrueScan& scan, const BenchOptions& options) : scan_(scan), options_(options) {}

  /// Everything anew in a pipeline of its own.
  Expected<SnapshotPtr> fresh(const Execution& execution, std::vector<double>& seconds) {
    const Stopwatch watch;
    Pipeline pipeline;
    pipeline.setScans({scan_.scan});
    auto result = pipeline.run(options_.params, execution);
    seconds.push_back(watch.seconds());
    return result;
  }

  /// Everything anew in a pipeline that has run before.
  Expected<SnapshotPtr> again(int threads, std::vector<double>& seconds) {
    const Stopwatch watch;
    kept_.setScans({scan_.scan});
    auto result = kept_.run(options_.params, {threads});
    seconds.push_back(watch.seconds());
    return result;
  }

private:
  const TrueScan& scan_;
  const BenchOptions& options_;
  Pipeline kept_;
};

ScoreInput scoreInput(const TrueScan& truth, std::span<const std::uint32_t> labels,
                      std::span<const Eigen::Vector3f> normals) {
  ScoreInput input;
  input.truthLabels = truth.labels.values();
  input.truthNormals = truth.normals.values();
  input.foundLabels = labels;
  input.foundNormals = normals;
  return input;
}

std::optional<NormalQuality> normalQuality(const TrueScan& truth, std::span<const Eigen::Vector3f> normals) {
  if (truth.normals.empty()) return std::nullopt;
  const NormalErrors errors = normalErrors(scoreInput(truth, {}, normals));
  if (errors.anglesDeg.empty()) return std::nullopt;
  return NormalQuality{*errors.quantileDeg(0.5), *errors.quantileDeg(0.9), *errors.shareWithin(10)};
}

std::optional<std::size_t> correctPlanes(const TrueScan& truth, std::span<const std::uint32_t> labels) {
  if (truth.labels.empty()) return std::nullopt;
  ScoreInput input = scoreInput(truth, labels, {});
  const ScoreOptions options;
  const Grid<std::uint32_t> truthLabels = truth.labelsFor(labels, options.overlap);
  input.truthLabels = truthLabels.values();
  return scoreSegmentation(input, options).correct;
}

std::vector<BenchChange> measureChanges(const TrueScan& scan, const BenchOptions& options, int threads) {
  struct Change {
    const char* parameter;
    void (*apply)(PipelineParams&);
  };
  constexpr Change kChanges[] = {
      {"epsilon", [](PipelineParams& p) { p.intervals.epsilon *= 1.5; }},
      {"cell", [](PipelineParams& p) { p.grid.cell *= 1.5; }},
      {"epsilon1", [](PipelineParams& p) { p.normals.epsilon1 *= 1.2; }},
  };
  Pipeline pipeline;
  pipeline.setScans({scan.scan});
  std::vector<BenchChange> changes;
  for (const Change& change : kChanges) {
    BenchChange measured;
    measured.parameter = change.parameter;
    PipelineParams other = options.params;
    change.apply(other);
    std::vector<double> seconds;
    (void)pipeline.run(options.params, {threads});
    for (int run = 0; run < 2 * options.runs; ++run) {  // there and back
      const auto before = pipeline.executions();
      const Stopwatch watch;
      const auto result = pipeline.run(run % 2 ? options.params : other, {threads});
      if (!result) break;
      seconds.push_back(watch.seconds());
      measured.stages.clear();
      for (int s = 0; s < kStageCount; ++s)
        if (pipeline.executions()[static_cast<size_t>(s)] > before[static_cast<size_t>(s)])
          measured.stages.push_back(static_cast<Stage>(s));
    }
    measured.seconds = medianOf(seconds);
    changes.push_back(std::move(measured));
  }
  return changes;
}

/// A peer's times over the runs; the last result is kept for its quality.
template <class Run>
auto timed(int runs, double& median, const Run& run) {
  auto result = run();
  if (runs > 1) result = run();  // the first warmed up
  std::vector<double> seconds{result.seconds};
  for (int i = 1; i < runs; ++i) {
    result = run();
    seconds.push_back(result.seconds);
  }
  median = medianOf(seconds);
  return result;
}

void measurePcl(const TrueScan& truth, const PointImage& points, const BenchOptions& options, int threads,
                BenchResult& result) {
  const int slow = std::min(options.runs, kRunsOfSlowPeers);
  const auto addNormals = [&](const char* key, const char* name, int used, double seconds,
                              const PeerNormals& normals) {
    result.peers.push_back(
        {key, name, used, seconds, {}, normalQuality(truth, normals.normals.values()), {}});
  };
  const auto addPlanes = [&](const char* key, const char* name, const PeerNormals& normals,
                             const PclPlaneSettings& settings) {
    BenchPeer peer{key, name, 1, 0, {}, {}, {}};
    const PeerPlanes planes =
        timed(options.runs, peer.seconds, [&] { return pclMultiPlane(points, normals.normals, settings); });
    peer.correct = correctPlanes(truth, planes.labels.values());
    result.peers.push_back(std::move(peer));
  };
  double seconds = 0;
  const PeerNormals radius =
      timed(slow, seconds, [&] { return pclRadiusNormals(points, kPclRadius, threads); });
  addNormals("pcl_radius_normals", "PCL normals, radius 0.10 m, kd-tree", threads, seconds, radius);
  addPlanes("pcl_radius_planes", "PCL organised multi-plane on these", radius, kPclPlanesOfRadius);
  const PeerNormals integral = timed(options.runs, seconds, [&] { return pclIntegralImageNormals(points); });
  addNormals("pcl_integral_normals", "PCL normals, integral image", 1, seconds, integral);
  addPlanes("pcl_integral_planes", "PCL organised multi-plane on these", integral, kPclPlanesOfIntegralImage);
}

void measureOctomap(const PointImage& points, const BenchOptions& options, BenchResult& result) {
  const auto add = [&](const char* key, const char* name, int runs, auto insert, OctomapCalls calls) {
    BenchPeer peer{key, name, 1, 0, {}, {}, {}};
    peer.bytes =
        timed(runs, peer.seconds, [&] { return insert(points, options.octomapResolution, calls); }).bytes;
    result.peers.push_back(std::move(peer));
  };
  const int few = std::min(options.runs, kRunsOfSlowPeers);
  if (options.octomap) {
    add("octomap_end_points", "OctoMap, end points only", options.runs, octomapEndPoints,
        OctomapCalls::Together);
    add("octomap_rays", "OctoMap, with rays", few, octomapWithRays, OctomapCalls::Together);
  }
  if (options.octomapSingly) {
    add("octomap_end_points_singly", "OctoMap, end points, each by itself", few, octomapEndPoints,
        OctomapCalls::Singly);
    add("octomap_rays_singly", "OctoMap, with rays, each by itself", few, octomapWithRays,
        OctomapCalls::Singly);
  }
}

}  // namespace

Expected<BenchResult> runBench(const TrueScan& scan, const BenchOptions& options,
                               const std::function<void(const std::string&)>& progress) {
  require(options.runs >= 1 && options.threads >= 0, "runBench: no runs, or a negative number of threads");
  const auto say = [&](const char* what) {
    if (progress) progress(what);
  };
  BenchResult result;
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  result.threads = options.threads > 0 ? options.threads : processors;
  result.runs = options.runs;
  result.neurons = scan.scan->lattice->points().size();

  OwnRuns own(scan, options);
  std::vector<double> unused, pipeline, again, one, busy;
  std::array<std::vector<double>, kStageCount> stages;
  say("warming up");
  auto snapshot = own.fresh({result.threads}, unused);
  if (!snapshot) return snapshot.error();
  const auto single = own.fresh({1}, unused);
  if (!single) return single.error();
  result.sameBits = sameProducts(**snapshot, **single);
  (void)own.again(result.threads, unused);
  for (int run = 0; run < options.runs; ++run) {  // in turns, so that what else the machine does meets all
    say("whole pipeline");
    snapshot = own.fresh({result.threads}, pipeline);
    const auto apart = own.fresh({.threads = result.threads, .oneStageAtATime = true}, unused);
    for (size_t s = 0; s < stages.size(); ++s) stages[s].push_back((*apart)->stages[s].seconds);
    (void)own.again(result.threads, again);
    (void)own.fresh({1}, one);
    if (result.threads > 1) busy.push_back(busyThreadGain(result.threads));
  }
  for (size_t s = 0; s < stages.size(); ++s) result.stages[s] = medianOf(stages[s]);
  result.pipeline = medianOf(pipeline);
  result.again = medianOf(again);
  result.oneThread = medianOf(one);
  result.busyGain = result.threads > 1 ? medianOf(busy) : 1;

  const Snapshot& products = **snapshot;
  result.points = products.cells->source.size();
  result.heightMapBytes = products.heightMap->height.size() * sizeof(float);
  result.intervalMapBytes = products.intervalMap->first.size() * sizeof(std::uint32_t) +
                            products.intervalMap->records.size() * sizeof(HeightInterval);
  result.normals = normalQuality(scan, products.scans.front().normals->normals.values());
  result.correct = correctPlanes(scan, products.scans.front().planes->labels.values());
  if (!scan.labels.empty())
    result.truthPlanes = scoreSegmentation(scoreInput(scan, scan.labels.values(), {})).truthRegions;
  say("only what changed");
  result.changes = measureChanges(scan, options, result.threads);

  const PointImage points = computePoints(*scan.scan, options.params.range, {options.threads});
  if (options.pcl && !pclVersion().empty()) {
    say("PCL");
    measurePcl(scan, points, options, result.threads, result);
  }
  if ((options.octomap || options.octomapSingly) && !octomapVersion().empty()) {
    say("OctoMap");
    measureOctomap(points, options, result);
  }
  return result;
}

double BenchResult::normalSeconds() const {
  return stages[static_cast<size_t>(Stage::Points)] + stages[static_cast<size_t>(Stage::Normals)];
}

double BenchResult::mapSeconds() const {
  return stages[static_cast<size_t>(Stage::Cells)] + stages[static_cast<size_t>(Stage::HeightMap)] +
         stages[static_cast<size_t>(Stage::Intervals)];
}

const BenchPeer* BenchResult::peer(const std::string& key) const {
  const auto found =
      std::find_if(peers.begin(), peers.end(), [&](const BenchPeer& p) { return p.key == key; });
  return found == peers.end() ? nullptr : &*found;
}

}  // namespace stratascope
