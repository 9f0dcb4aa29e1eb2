// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// A dragged slider runs the pipeline again and again: after the first few times it does so in memory the process
// has already.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>

#include "pipeline/pipeline.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

/// Pages this process got from the system so far.
long freshPages() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

TEST(Memory, ADraggedSliderTakesHardlyAnyFromTheSystem) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  Scene scene = randomRoom(5);
  scene.scanner.lines = 350, scene.scanner.beams = 361;
  const ScanPtr scan = std::make_shared<const Scan>(simulateScan(scene, {.seed = 5}).scan);
  struct Slider {
    const char* name;
    void (*drag)(PipelineParams& params, int step);
  };
  for (const Slider& slider :
       {Slider{"epsilon1", [](PipelineParams& p, int step) { p.normals.epsilon1 = 0.25 + 0.01 * step; }},
        Slider{"cell", [](PipelineParams& p, int step) { p.grid.cell = 0.05 + 0.0005 * step; }},
        Slider{"epsilon", [](PipelineParams& p, int step) { p.intervals.epsilon = 0.1 + 0.01 * step; }}}) {
    SCOPED_TRACE(slider.name);
    Pipeline pipeline;
    pipeline.setScans({scan});
    PipelineParams params;
    SnapshotPtr shown;
    std::vector<long> pages;
    for (int step = 0; step < 12; ++step) {
      slider.drag(params, step);
      const long before = freshPages();
      shown = *pipeline.run(params);  // the window lets go of the last result when it has the next
      pages.push_back(freshPages() - before);
    }
    // Of some 250 bytes a neuron that a run of normals and planes goes through, 7,700 pages, not one in fifty.
    std::sort(pages.begin() + 5, pages.end());
    EXPECT_LT(pages[8], 150) << "in the middle of the later runs; at most " << pages.back();
  }
}

}  // namespace
}  // namespace stratascope
