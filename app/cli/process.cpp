// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "app/cli/scan_arguments.h"
#include "app/cli/text_table.h"
#include "io/extra_export.h"
#include "io/file_util.h"
#include "io/scan_paths.h"
#include "io/session_file.h"
#include "io/text_lines.h"
#include "layers/surface_class.h"
#include "pipeline/pipeline.h"

namespace stratascope::cli {
namespace {

struct ProcessOptions {
  std::vector<std::string> scans;
  std::string out, session;
  bool json = false;
  std::string exports, robotStart;
  RobotParams robot;
  FrameOptions frame;
  ParamOptions params;
};

ExtraOptions extraOptions(const ProcessOptions& options) {
  ExtraOptions extra;
  if (!options.exports.empty()) {
    auto kinds = exportKindsFromText(options.exports);
    if (!kinds) throw BadArguments("--export: " + kinds.error().what + "; " + kinds.error().remedy);
    extra.kinds = *std::move(kinds);
  }
  extra.robot = options.robot;
  if (options.robotStart.empty()) return extra;
  const size_t comma = options.robotStart.find(',');
  const auto x = numberFromText(std::string_view(options.robotStart).substr(0, comma));
  const auto y = comma == std::string::npos
                     ? std::nullopt
                     : numberFromText(std::string_view(options.robotStart).substr(comma + 1));
  constexpr double kFarthest = 1e6;
  if (!x || !y || !(std::abs(*x) <= kFarthest) || !(std::abs(*y) <= kFarthest))
    throw BadArguments("--robot-start: '" + options.robotStart + "' is no place; give x,y in metres");
  extra.robotStart = {*x, *y};
  return extra;
}

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

/// What is to be computed, from the arguments or from a session.
struct Job {
  std::vector<std::string> files;
  std::vector<std::optional<Eigen::Isometry3d>> poses;
  std::vector<FileFrame> frames;
  PipelineParams params;
  std::vector<std::vector<int>> hidden = {};
};

Expected<Job> jobOfSession(const ProcessOptions& options) {
  if (!options.scans.empty()) throw BadArguments("--session: it names the scans; give no SCAN");
  const auto session = readSession(options.session);
  if (!session) return session.error();
  if (const Status same = checkInputs(*session); !same) return same.error();
  const Settings base{session->params, {}};
  const auto settings = options.params.settings(&base);
  if (!settings) return settings.error();
  Job job{{}, {settings->poses.begin(), settings->poses.end()}, {}, settings->params};
  for (const SessionInput& input : session->inputs) {
    const FileFrame asked = options.frame.frame();
    job.frames.push_back({asked.unit == LengthUnit::Auto ? input.frame.unit : asked.unit,
                          asked.axes == FileAxes::Auto ? input.frame.axes : asked.axes});
    job.files.push_back(input.path);
    job.hidden.push_back(input.hidden);
    if (settings->poses.empty()) job.poses.push_back(sessionPose(input));
  }
  return job;
}

Expected<Job> jobOf(const ProcessOptions& options) {
  if (!options.session.empty()) return jobOfSession(options);
  if (options.scans.empty()) throw BadArguments("SCAN is required, or --session");
  const auto settings = options.params.settings();
  if (!settings) return settings.error();
  const auto files = scanFiles(options.scans);
  if (!files) return files.error();
  Job job{*files, {settings->poses.begin(), settings->poses.end()}, {}, settings->params};
  job.frames.assign(files->size(), options.frame.frame());
  return job;
}

Status process(const ProcessOptions& options) {
  const ExtraOptions extra = extraOptions(options);
  const auto job = jobOf(options);
  if (!job) return job.error();
  auto scans = readScans(job->files, job->poses, job->frames, job->hidden);
  if (!scans) return scans.error();

  Pipeline pipeline;
  pipeline.setScans(*scans);
  const auto result = pipeline.run(job->params, options.params.execution(),
                                   [](Stage stage) { showProgress(stageLabel(stage)); });
  endProgress();
  if (!result) return result.error();
  const Snapshot& snapshot = **result;
  std::vector<std::string> notes;
  const auto written = exportResults(snapshot, options.out, extra, notes);
  if (!written) return written.error();

  for (const ScanProducts& scan : snapshot.scans) {
    for (const std::string& sentence : scan.scan->notes) note(scan.scan->name + ": " + sentence);
    for (const std::string& sentence : scan.planes->notes) note(scan.scan->name + ": " + sentence);
  }
  for (const std::string& sentence : notes) note(sentence);
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
  command->add_option("SCAN", options->scans,
                      "Scan files, or directories of UOS scans (scanNNN.3d); several go into one map");
  command->add_option(
      "--session", options->session,
      "A .stratascope file instead of SCAN: its scans, poses and parameters; options win over it");
  command->add_option("--out", options->out, "Directory for the results; made if missing")->required();
  command->add_flag("--json", options->json, "The document of run.json on standard output");
  std::string words;
  for (const ExportKindInfo& info : exportKinds())
    words += std::string(words.empty() ? "" : ", ") + info.word;
  command->add_option("--export", options->exports,
                      "What to write besides, separated by commas: " + words + "; or all");
  const auto length = CLI::Range(0.0, 100.0);
  command->add_option("--robot-height", options->robot.height, "Free height a robot needs, for pgm (m)")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str()
      ->group("Robot");
  command->add_option("--robot-step", options->robot.step, "Largest step it takes (m)")
      ->check(length)
      ->capture_default_str()
      ->group("Robot");
  command->add_option("--robot-radius", options->robot.radius, "Radius of its footprint (m)")
      ->check(length)
      ->capture_default_str()
      ->group("Robot");
  command
      ->add_option("--robot-start", options->robotStart,
                   "x,y where it stands in the map (m); without it at the first scan's sensor")
      ->group("Robot");
  options->frame.addTo(*command);
  options->params.addTo(*command);
  command->callback([options, &action] { action = [options] { return process(*options); }; });
}

}  // namespace stratascope::cli
