// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "app/cli/scan_arguments.h"
#include "app/cli/text_table.h"
#include "io/export.h"
#include "io/file_util.h"
#include "layers/surface_class.h"
#include "pipeline/pipeline.h"

namespace stratascope::cli {
namespace {

struct ProcessOptions {
  std::vector<std::string> scans;
  std::string out;
  bool json = false;
  FrameOptions frame;
  ParamOptions params;
};

std::string stageTable(const Snapshot& snapshot) {
  std::vector<std::vector<std::string>> rows = {{"stage", "seconds"}};
  for (int i = 0; i < kStageCount; ++i)
    rows.push_back(
        {stageName(static_cast<Stage>(i)), fixed(snapshot.stages[static_cast<size_t>(i)].seconds, 3)});
  return textTable(rows);
}

std::string countTable(const Snapshot& snapshot, const std::vector<const Plane*>& planes) {
  size_t measured = 0, missing = 0, edges = 0;
  for (const ScanProducts& scan : snapshot.scans) {
    missing += scan.scan->lattice->missingCount();
    measured += scan.scan->lattice->points().size() - scan.scan->lattice->missingCount();
    edges += scan.edges->edges.size();
  }
  return textTable(
      {{"scans", "neurons", "missing", "planes", "edges", "columns", "rows", "intervals"},
       {std::to_string(snapshot.scans.size()), std::to_string(measured), std::to_string(missing),
        std::to_string(planes.size()), std::to_string(edges),
        std::to_string(snapshot.heightMap->frame.columns), std::to_string(snapshot.heightMap->frame.rows),
        std::to_string(snapshot.intervalMap->records.size())}});
}

std::string planeTable(const std::vector<const Plane*>& planes) {
  constexpr size_t kShown = 10;
  std::vector<std::vector<std::string>> rows = {
      {"class", "role", "label", "points", "sigma/m", "rms/m", "normal", "offset/m"}};
  for (size_t i = 0; i < std::min(kShown, planes.size()); ++i) {
    const Plane& p = *planes[i];
    rows.push_back({surfaceClassName(p.surfaceClass), p.role.empty() ? "none" : p.role,
                    std::to_string(p.label), std::to_string(p.points), fixed(p.sigma, 4), fixed(p.rms, 4),
                    fixed(p.normal, 3), fixed(p.offset, 3)});
  }
  return textTable(rows);
}

std::vector<const Plane*> planesBySize(const Snapshot& snapshot) {
  std::vector<const Plane*> planes;
  for (const ScanProducts& scan : snapshot.scans)
    for (const Plane& plane : scan.planes->planes) planes.push_back(&plane);
  std::sort(planes.begin(), planes.end(), [](const Plane* a, const Plane* b) {
    return a->points != b->points ? a->points > b->points : a->label < b->label;
  });
  return planes;
}

Status process(const ProcessOptions& options) {
  const auto settings = options.params.settings();
  if (!settings) return settings.error();
  const auto files = scanFiles(options.scans);
  if (!files) return files.error();
  auto scans = readScans(*files, settings->poses, options.frame.frame());
  if (!scans) return scans.error();

  Pipeline pipeline;
  pipeline.setScans(*scans);
  const auto result = pipeline.run(settings->params, options.params.execution(),
                                   [](Stage stage) { showProgress(stageLabel(stage)); });
  endProgress();
  if (!result) return result.error();
  const Snapshot& snapshot = **result;
  const auto written = exportResults(snapshot, options.out);
  if (!written) return written.error();

  for (const ScanProducts& scan : snapshot.scans) {
    for (const std::string& sentence : scan.scan->notes) note(scan.scan->name + ": " + sentence);
    for (const std::string& sentence : scan.planes->notes) note(scan.scan->name + ": " + sentence);
  }
  if (options.json) {
    const auto document = readFile((std::filesystem::path(options.out) / "run.json").string());
    if (!document) return document.error();
    std::cout << *document;
    return success();
  }
  const auto planes = planesBySize(snapshot);
  std::cout << stageTable(snapshot) << '\n'
            << countTable(snapshot, planes) << '\n'
            << planeTable(planes) << '\n';
  for (const std::string& path : *written) std::cout << path << '\n';
  return success();
}

}  // namespace

void addProcess(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ProcessOptions>();
  CLI::App* command =
      app.add_subcommand("process", "Computes planes, edges and both maps of one or several scans");
  command
      ->add_option("SCAN", options->scans,
                   "Scan files, or directories of UOS scans (scanNNN.3d); several go into one map")
      ->required();
  command->add_option("--out", options->out, "Directory for the results; made if missing")->required();
  command->add_flag("--json", options->json, "The document of run.json on standard output");
  options->frame.addTo(*command);
  options->params.addTo(*command);
  command->callback([options, &action] { action = [options] { return process(*options); }; });
}

}  // namespace stratascope::cli
