// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/score_cases.h"
#include "params/pipeline_params.h"
#include "pipeline/snapshot.h"
#include "segment/score.h"

namespace stratascope {

/// What is measured. Peers that are not built in are left out.
struct BenchOptions {
  PipelineParams params;
  int threads = 0;  ///< 0 = all
  int runs = 7;     ///< >= 1, after one to warm up
  bool pcl = true, octomap = true;
  bool octomapSingly = false;  ///< as well
  double octomapResolution = 0.05;
};

/// How well normals fit the truth.
struct NormalQuality {
  double medianDeg = 0, ninetyDeg = 0, within10 = 0;
};

/// A peer's algorithm on the same points in the same run.
struct BenchPeer {
  std::string key, name;
  int threads = 1;
  double seconds = 0;                    ///< median
  std::optional<std::size_t> bytes;      ///< of a map
  std::optional<NormalQuality> normals;  ///< where there is truth
  std::optional<std::size_t> correct;    ///< planes, where there is truth
};

/// What changing one parameter of a finished result costs.
struct BenchChange {
  std::string parameter;
  double seconds = 0;         ///< median
  std::vector<Stage> stages;  ///< that ran again
};

/// Times are seconds, medians of the runs. Every run computes everything anew.
struct BenchResult {
  int threads = 1, runs = 0;
  std::size_t neurons = 0, points = 0;
  std::array<double, kStageCount> stages{};  ///< with `threads`, one stage at a time
  double pipeline = 0;                       ///< a pipeline of its own every run
  double again = 0;      ///< one pipeline given the same scan again: what does not change is not computed
  double oneThread = 0;  ///< as `pipeline`, with one thread
  double busyGain = 1;   ///< see busyThreadGain, measured between the runs
  bool sameBits = true;  ///< one thread and `threads` gave the same products
  std::size_t heightMapBytes = 0, intervalMapBytes = 0;
  std::optional<NormalQuality> normals;
  std::optional<std::size_t> truthPlanes, correct;
  std::vector<BenchChange> changes;
  std::vector<BenchPeer> peers;

  double normalSeconds() const;  ///< from points to normals
  double mapSeconds() const;     ///< cells, 2.5D and extended 2.5D map
  const BenchPeer* peer(const std::string& key) const;
};

/// `truth` may be without labels (empty grids): then nothing is said of quality. Errors: parameters or scan
/// cannot be used. `progress` hears what is measured next.
Expected<BenchResult> runBench(const TrueScan& scan, const BenchOptions& options,
                               const std::function<void(const std::string&)>& progress = {});

}  // namespace stratascope
