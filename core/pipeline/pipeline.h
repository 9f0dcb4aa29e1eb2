// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "base/expected.h"
#include "base/parallel_rows.h"
#include "params/pipeline_params.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// The synchronous engine: scans and parameters in, a snapshot out. Complete without threads of its own;
/// keeps the last products and reruns only stages whose inputs or parameters changed. Not thread-safe: one
/// caller at a time.
class Pipeline {
public:
  Pipeline();
  ~Pipeline();
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;

  void setScans(std::vector<ScanPtr> scans);

  /// Called in the caller's thread for one stage after the other, before its product is there. Classes, planes
  /// and maps are worked on side by side, so a map may be done by then.
  using Progress = std::function<void(Stage stage)>;

  /// Errors: parameters that do not validate, a map too large for its cell size, no scan.
  /// Throws Cancelled if asked to stop; products finished before that are kept for the next run.
  Expected<SnapshotPtr> run(const PipelineParams& params, const Execution& execution = {},
                            const Progress& progress = {});

  /// How often each stage has really run since construction.
  const std::array<int, kStageCount>& executions() const;

private:
  struct State;
  class Run;
  std::unique_ptr<State> state_;
};

}  // namespace stratascope
