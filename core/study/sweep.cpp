// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/sweep.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/units.h"
#include "io/export.h"
#include "io/number_text.h"
#include "params/param_table.h"

namespace stratascope {
namespace {

constexpr int kMostSteps = 1000;

/// To six significant digits, so that a sample can be named and typed.
double rounded(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
  std::from_chars(text, end.ptr, value);
  return value;
}

Error planError(const SweepPlan& plan, std::string what, std::string remedy) {
  return Error{"", plan.key, std::move(what), std::move(remedy)};
}

std::string rangeText(const ParamInfo& info) {
  return numberText(info.minimum) + " to " + numberText(info.maximum);
}

}  // namespace

SweepFigures sweepFigures(const Snapshot& snapshot) {
  SweepFigures f;
  size_t measured = 0, classified = 0, inPlanes = 0;
  double sigmas = 0, weight = 0;
  for (const ScanProducts& scan : snapshot.scans) {
    for (size_t i = 0; i < scan.points->range.size(); ++i) {
      if (std::isnan(scan.points->range[i])) continue;
      ++measured;
      classified += scan.classes->classes[i] != SurfaceClass::Unknown;
      inPlanes += scan.planes->labels[i] != kNoPlane;
    }
    f.planes += scan.planes->planes.size();
    for (const Plane& plane : scan.planes->planes) {
      sigmas += plane.sigma * static_cast<double>(plane.points);
      weight += static_cast<double>(plane.points);
    }
  }
  const auto share = [&](size_t n) {
    return measured ? static_cast<double>(n) / static_cast<double>(measured) : kNaN;
  };
  f.classified = share(classified);
  f.inPlanes = share(inPlanes);
  f.meanSigma = weight > 0 ? sigmas / weight : kNaN;
  f.records = snapshot.intervalMap->records.size();
  for (const StageReport& stage : snapshot.stages) {
    f.seconds += stage.seconds;
    f.stagesRun += !stage.reused;
  }
  return f;
}

Expected<std::vector<double>> sweepValues(const SweepPlan& plan) {
  const ParamInfo* info = findParam(plan.key);
  if (!info)
    return planError(plan, "there is no such parameter",
                     std::string("did you mean ") + nearestParamKey(plan.key) + "?");
  if (info->kind != ParamKind::Real && info->kind != ParamKind::Integer)
    return planError(plan, "it is not a number", "sweep one that is");
  for (const double end : {plan.from, plan.to})
    if (!(end >= info->minimum && end <= info->maximum))
      return planError(plan, numberText(end) + " is out of its range", "give " + rangeText(*info));
  if (plan.steps < 2 || plan.steps > kMostSteps)
    return planError(plan, std::to_string(plan.steps) + " samples cannot be made",
                     "give 2 to " + std::to_string(kMostSteps));
  if (plan.from == plan.to)
    return planError(plan, "the range begins where it ends", "give two different values");
  const bool geometric = plan.spacing == SweepPlan::Spacing::Geometric;
  if (geometric && !(plan.from > 0 && plan.to > 0))
    return planError(plan, "a geometric row cannot hold 0", "begin above 0, or take even steps");

  std::vector<double> values;
  for (int i = 0; i < plan.steps; ++i) {
    const double share = static_cast<double>(i) / (plan.steps - 1);
    double value = i == 0                ? plan.from
                   : i + 1 == plan.steps ? plan.to
                   : geometric           ? rounded(plan.from * std::pow(plan.to / plan.from, share))
                                         : rounded(plan.from + share * (plan.to - plan.from));
    if (info->kind == ParamKind::Integer) value = std::round(value);
    // Rounding may leave the range by its last digit, or make two samples one.
    value = std::clamp(value, std::min(plan.from, plan.to), std::max(plan.from, plan.to));
    if (values.empty() || value != values.back()) values.push_back(value);
  }
  return values;
}

PipelineParams sweepParams(const PipelineParams& base, const std::string& key, double value) {
  const ParamInfo* info = findParam(key);
  require(info, "sweepParams: no such parameter");
  PipelineParams params = base;
  info->set(params, value);
  return params;
}

Expected<std::vector<SweepSample>> runSweep(const std::vector<ScanPtr>& scans, const PipelineParams& base,
                                            const SweepPlan& plan, const Execution& execution,
                                            const std::function<void(const SweepSample&)>& sampled) {
  const auto values = sweepValues(plan);
  if (!values) return values.error();
  if (scans.empty()) return Error{"", "", "there is no scan to sweep over", "open one first"};
  Execution apart = execution;
  apart.oneStageAtATime = true;  // a sample's seconds are the sum of its stages', some of them from before
  Pipeline pipeline;
  pipeline.setScans(scans);
  std::vector<SweepSample> samples;
  for (const double value : *values) {
    throwIfStopped(execution);
    SweepSample sample{value, {}, {}};
    const auto result = pipeline.run(sweepParams(base, plan.key, value), apart);
    if (result)
      sample.figures = sweepFigures(**result);
    else
      sample.problem = result.error().message();
    samples.push_back(sample);
    if (sampled) sampled(sample);
  }
  return samples;
}

StudyTable sweepTable(const SweepPlan& plan, const std::vector<SweepSample>& samples) {
  StudyTable table{{plan.key, "planes", "classified", "in_planes", "records", "mean_sigma_m", "seconds"}, {}};
  for (const SweepSample& s : samples) {
    if (s.figures)
      table.rows.push_back({s.value, static_cast<double>(s.figures->planes), s.figures->classified,
                            s.figures->inPlanes, static_cast<double>(s.figures->records),
                            s.figures->meanSigma, s.figures->seconds});
    else
      table.rows.push_back({s.value, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN});
  }
  return table;
}

Expected<Provenance> sweepProvenance(const Snapshot& result, const PipelineParams& base,
                                     const SweepPlan& plan) {
  Snapshot based = result;
  based.params = base;
  const auto run = runJson(based);
  if (!run) return run.error();
  Provenance lines = provenanceOf(*run);
  lines.push_back("sweep " + plan.key + " from " + numberText(plan.from) + " to " + numberText(plan.to) +
                  " in " + std::to_string(plan.steps) +
                  (plan.spacing == SweepPlan::Spacing::Geometric ? " geometric" : " even") + " steps");
  return lines;
}

}  // namespace stratascope
