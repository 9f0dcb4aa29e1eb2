// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"
#include "study/study_table.h"

namespace stratascope {

/// One parameter over a range; all others stay.
struct SweepPlan {
  std::string key;  ///< of a number in the parameter table
  double from = 0, to = 1;
  int steps = 11;  ///< samples, both ends included
  enum class Spacing { Linear, Geometric } spacing = Spacing::Linear;
};

/// What one set of parameters leads to, in a few figures.
struct SweepFigures {
  size_t planes = 0;
  size_t records = 0;     ///< of the extended map
  double classified = 0;  ///< share of measured neurons with a surface or edge class, 0 … 1; NaN without any
  double inPlanes = 0;    ///< share of measured neurons that lie in a plane
  double meanSigma = 0;   ///< Eq. (10) over all planes, weighted by their points, metres; NaN without planes
  double seconds = 0;     ///< of all stages, each as last run: what it would take from the start
  int stagesRun = 0;      ///< for this sample; the products of the others were kept
};
SweepFigures sweepFigures(const Snapshot& snapshot);

struct SweepSample {
  double value = 0;
  std::optional<SweepFigures> figures;
  std::string problem;  ///< why there are none: values that do not go together, a map too large
};

/// The values a plan takes: ascending or descending as from and to are, both ends exactly, those between
/// rounded to six digits (whole numbers for an integer parameter, each once). Errors name key and remedy: no
/// such number, out of its range, a geometric spacing from 0, fewer than 2 or more than 1000 samples.
Expected<std::vector<double>> sweepValues(const SweepPlan& plan);

/// The parameters of one sample.
PipelineParams sweepParams(const PipelineParams& base, const std::string& key, double value);

/// Runs all samples in order in one pipeline of its own, so that stages before the parameter's run once.
/// `sampled` hears of each as it is done, in the caller's thread. Errors: those of sweepValues(), no scan.
/// Throws Cancelled if asked to stop.
Expected<std::vector<SweepSample>> runSweep(const std::vector<ScanPtr>& scans, const PipelineParams& base,
                                            const SweepPlan& plan, const Execution& execution = {},
                                            const std::function<void(const SweepSample&)>& sampled = {});

/// Columns: the parameter, planes, classified, in_planes, records, mean_sigma_m, seconds.
StudyTable sweepTable(const SweepPlan& plan, const std::vector<SweepSample>& samples);
/// Program, inputs and all parameters as `base` has them, and the plan. `result`: any of the same scans.
/// Reads the inputs for their hashes; errors as runJson().
Expected<Provenance> sweepProvenance(const Snapshot& result, const PipelineParams& base,
                                     const SweepPlan& plan);

}  // namespace stratascope
