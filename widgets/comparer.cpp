// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/comparer.h"

#include <exception>

#include "widgets/difference.h"

namespace stratascope {
namespace {

struct Job {
  ViewGeometryPtr a, b;
  CompareMode mode;
  Comparer::Result last;
};

struct Outcome {
  Comparer::Result result;
  QString error;
};

/// A as B is looked at: what differs in the pictures is the result, not the scale.
ViewOptions optionsFor(const ViewGeometry& b) {
  ViewOptions options = b.options;
  options.cut = b.cut;
  if (options.colouring > CloudColouring::Direction)
    options.cloudRange = {b.cloudScale.low, b.cloudScale.high};
  options.mapRange = {b.mapScale.low, b.mapScale.high};
  return options;
}

Outcome work(const Job& job) {
  Outcome out;
  try {
    Comparer::Result& r = out.result;
    r.b = job.b;
    const bool same = job.last.comparison && job.last.a->snapshot == job.a->snapshot &&
                      job.last.b->snapshot == job.b->snapshot;
    r.comparison = same ? job.last.comparison
                        : std::make_shared<const SnapshotComparison>(
                              compareSnapshots(*job.a->snapshot, *job.b->snapshot));
    const bool drawn = job.mode == CompareMode::SideBySide || job.mode == CompareMode::Wipe;
    const ViewGeometryPtr& before =
        job.last.a && job.last.a->snapshot == job.a->snapshot ? job.last.a : job.a;
    r.a = drawn ? buildViewGeometry(job.a->snapshot, optionsFor(*job.b), before) : before;
    if (job.mode == CompareMode::Differences)
      r.difference = buildDifference(*job.b, *job.a->snapshot, *r.comparison);
  } catch (const std::exception& e) {
    out.error = Comparer::tr("A and B could not be compared: %1").arg(QString::fromUtf8(e.what()));
  }
  return out;
}

}  // namespace

QString compareModeName(CompareMode mode) {
  switch (mode) {
    case CompareMode::Present:
      return Comparer::tr("B only");
    case CompareMode::SideBySide:
      return Comparer::tr("A beside B");
    case CompareMode::Wipe:
      return Comparer::tr("Wipe");
    case CompareMode::Differences:
      return Comparer::tr("Differences");
  }
  return {};
}

void Comparer::setA(const ViewGeometryPtr& a) {
  a_ = a;
  if (a_) return request();
  result_ = {};
  wanted_ = false;
  emit changed();
}

void Comparer::setB(const ViewGeometryPtr& b) {
  b_ = b;
  request();
}

void Comparer::setMode(CompareMode mode) {
  mode_ = mode;
  request();
}

void Comparer::request() {
  if (!a_ || !b_) return;
  wanted_ = true;
  if (!running_) start();
}

void Comparer::start() {
  wanted_ = false;
  running_ = true;
  background_.run(
      this, [job = Job{a_, b_, mode_, result_}] { return work(job); },
      [this](Outcome outcome) {
        running_ = false;
        if (a_ && outcome.error.isEmpty()) result_ = std::move(outcome.result);
        if (wanted_ && a_ && b_) start();
        if (!outcome.error.isEmpty()) emit failed(outcome.error);
        if (a_) emit changed();
      });
}

}  // namespace stratascope
