// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "params/pipeline_params.h"

#include <cmath>

#include "params/param_table.h"

namespace stratascope {
namespace {

std::string inWords(const ParamInfo& info, double value) {
  return paramNumberText(value) + (*info.unit ? std::string(" ") + info.unit : "");
}

/// "" if the value can be used.
std::string rangeProblem(const ParamInfo& info, double value) {
  if (info.kind == ParamKind::Flag) return {};
  if (info.kind == ParamKind::Choice) {
    // An index beyond the words can only come from a cast; the set of words is closed.
    if (value >= 0 && value < static_cast<double>(info.choices.size())) return {};
    return std::string(info.key) + " is none of its choices";
  }
  if (!std::isfinite(value)) return std::string(info.key) + " is not a finite number";
  if (value >= info.minimum && value <= info.maximum) return {};
  return std::string(info.key) + " = " + inWords(info, value) + " is outside " +
         paramNumberText(info.minimum) + " to " + inWords(info, info.maximum);
}

}  // namespace

std::vector<std::string> PipelineParams::validate() const {
  std::vector<std::string> problems;
  for (const ParamInfo& info : paramTable()) {
    std::string problem = rangeProblem(info, info.get(*this));
    if (!problem.empty()) problems.push_back(std::move(problem));
  }
  if (normals.epsilon2 >= normals.epsilon1)
    problems.push_back("epsilon2 = " + paramNumberText(normals.epsilon2) +
                       " m must be smaller than epsilon1 = " + paramNumberText(normals.epsilon1) + " m");
  if (range.maxRange > 0 && range.maxRange <= range.minRange)
    problems.push_back(
        "max_range = " + paramNumberText(range.maxRange) +
        " m must be 0 (no limit) or larger than min_range = " + paramNumberText(range.minRange) + " m");
  // One parameter that two stages keep a copy of; not <, so that NaN is caught as well.
  if (!(classes.angleToleranceDeg == planes.angleToleranceDeg))
    problems.push_back("angle_tolerance must be the same for classes and planes");
  return problems;
}

}  // namespace stratascope
