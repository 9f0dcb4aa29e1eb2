// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/score_table.h"

#include <algorithm>

namespace stratascope {
namespace {

/// Planes whose angle is known, which weigh the mean of a sum of rows.
struct Measured {
  ScoreRow row;
  double angleSumDeg = 0;
  std::size_t angles = 0;
};

Measured scoreOf(const std::string& name, const TrueScan& truth, Method method, MethodResult found,
                 const ScoreOptions& options) {
  ScoreInput input;
  input.foundLabels = found.labels.values();
  const Grid<std::uint32_t> truthLabels = truth.labelsFor(input.foundLabels, options.overlap);
  input.truthLabels = truthLabels.values();
  input.foundNormals = found.normals.values();
  input.truthNormals = truth.normals.values();
  input.foundPoints = truth.scan->lattice->points().values();
  input.foundPlaneNormals = std::move(found.planeNormals);
  const SegmentationScore score = scoreSegmentation(input, options);
  Measured measured;
  ScoreRow& row = measured.row;
  row.name = name;
  row.method = method;
  row.scans = 1;
  row.truthRegions = score.truthRegions;
  row.foundRegions = score.foundRegions;
  row.correct = score.correct;
  row.over = score.over;
  row.under = score.under;
  row.missed = score.missed;
  row.noise = score.noise;
  row.noiseSmall = score.noiseSmall;
  row.share = score.share;
  row.planeAngleMeanDeg = score.planeAngleMeanDeg;
  row.normalSeconds = found.normalSeconds;
  row.seconds = found.seconds;
  row.normals = normalErrors(input);
  for (const CorrectPair& pair : score.pairs)
    if (pair.angleErrorDeg) {
      measured.angleSumDeg += *pair.angleErrorDeg;
      ++measured.angles;
    }
  return measured;
}

void addTo(Measured& sum, const Measured& one) {
  ScoreRow& a = sum.row;
  const ScoreRow& b = one.row;
  const auto before = static_cast<double>(a.scans), all = before + 1;
  const auto joinMean = [&](double mean, double value) { return (mean * before + value) / all; };
  a.share = joinMean(a.share, b.share);
  a.normalSeconds = joinMean(a.normalSeconds, b.normalSeconds);
  a.seconds = joinMean(a.seconds, b.seconds);
  a.scans += 1;
  a.truthRegions += b.truthRegions;
  a.foundRegions += b.foundRegions;
  a.correct += b.correct;
  a.over += b.over;
  a.under += b.under;
  a.missed += b.missed;
  a.noise += b.noise;
  a.noiseSmall += b.noiseSmall;
  a.normals.add(b.normals);
  sum.angleSumDeg += one.angleSumDeg;
  sum.angles += one.angles;
  if (sum.angles > 0) a.planeAngleMeanDeg = sum.angleSumDeg / static_cast<double>(sum.angles);
}

}  // namespace

Expected<ScoreTable> measureScoreTable(const ScoreTableOptions& options, const Execution& execution,
                                       const std::function<void(const std::string&)>& progress) {
  const ScoreCases all = scoreCases(options.cases);
  ScoreTable table;
  table.notes = all.notes;
  std::vector<Measured> groups;
  for (const ScoreCase& scoreCase : all.cases) {
    if (progress) progress(scoreCase.name);
    const auto truth = scoreCase.make(execution);
    if (!truth) return truth.error();
    for (const Method method : options.methods) {
      throwIfStopped(execution);
      if (progress) progress(scoreCase.name + ": " + methodName(method));
      auto found = runMethod(method, truth->scan, options.params, execution);
      if (!found) return found.error();
      Measured one = scoreOf(scoreCase.name, *truth, method, std::move(*found), options.score);
      auto group = std::find_if(groups.begin(), groups.end(), [&](const Measured& g) {
        return g.row.name == scoreCase.group && g.row.method == method;
      });
      if (group == groups.end()) {
        group = groups.insert(groups.end(), Measured{});
        group->row.name = scoreCase.group;
        group->row.method = method;
      }
      addTo(*group, one);
      one.row.normals.anglesDeg.clear();
      table.scans.push_back(std::move(one.row));
    }
  }
  for (Measured& group : groups) table.groups.push_back(std::move(group.row));
  return table;
}

}  // namespace stratascope
