// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/bench.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "app/cli/bench_process.h"
#include "app/cli/bench_report.h"
#include "app/cli/command.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "evaluate/sample_scenes.h"
#include "interop/peers.h"
#include "io/labelled_cloud.h"
#include "io/scan_io.h"
#include "sim/scan_simulator.h"

namespace stratascope::cli {
namespace {

struct BenchArguments {
  std::string scan, truth;
  std::vector<std::string> against;
  std::vector<double> times = {10, 50};
  int runs = 7;
  bool json = false, scale = false, costOnly = false;
  ParamOptions params;
};

/// The first sample scene at `lines` × `beams`; 0 × 0 = its own size.
Expected<TrueScan> sampleScan(const Execution& execution, int lines = 0, int beams = 0) {
  const SampleScene& sample = sampleScenes().front();
  auto scene = sceneFromJson(sample.json, sample.name);
  if (!scene) return scene.error();
  if (lines > 0) scene->scanner.lines = lines, scene->scanner.beams = beams;
  SimulatedScan simulated = simulateScan(*scene, {.seed = 1}, execution);
  return TrueScan{std::make_shared<const Scan>(std::move(simulated.scan)), std::move(simulated.truthLabels),
                  std::move(simulated.truthNormals), true};
}

Status addTruth(const std::string& path, TrueScan& scan) {
  const auto truth = readLabelledPcd(path);
  if (!truth) return truth.error();
  const ScanLattice& lattice = *scan.scan->lattice;
  if (truth->lines != lattice.lines() || truth->beams != lattice.beams())
    return Error{path, "WIDTH x HEIGHT",
                 std::to_string(truth->beams) + " x " + std::to_string(truth->lines) + ", but the scan is " +
                     std::to_string(lattice.beams()) + " x " + std::to_string(lattice.lines()),
                 "both must be of the same scan, point by point"};
  scan.labels = Grid<std::uint32_t>(truth->lines, truth->beams);
  std::copy(truth->labels.begin(), truth->labels.end(), scan.labels.values().begin());
  if (truth->normals.empty()) return success();
  scan.normals = Grid<Eigen::Vector3f>(truth->lines, truth->beams);
  std::copy(truth->normals.begin(), truth->normals.end(), scan.normals.values().begin());
  return success();
}

Expected<TrueScan> scanToMeasure(const BenchArguments& arguments, const Settings& settings) {
  if (arguments.scan.empty()) return sampleScan(arguments.params.execution());
  ReadOptions options;
  if (!settings.poses.empty()) options.pose = settings.poses.front();
  auto scan = readScan(arguments.scan, options);
  if (!scan) return scan.error();
  TrueScan result;
  result.scan = std::make_shared<const Scan>(std::move(*scan));
  if (!arguments.truth.empty())
    if (const Status added = addTruth(arguments.truth, result); !added) return added.error();
  return result;
}

/// Of this scan, and with --scale of the same scene on larger lattices.
Expected<std::vector<ProcessCost>> measureCosts(const BenchArguments& arguments, const PipelineParams& params,
                                                const Scan& scan) {
  const Execution execution = arguments.params.execution();
  showProgress("memory of a process of its own");
  const auto own = costOfProcess(scan, params, execution.threads, arguments.runs);
  if (!own) return own.error();
  std::vector<ProcessCost> costs{*own};
  if (!arguments.scale) return costs;
  std::vector<std::pair<int, int>> sizes;
  for (const double times : arguments.times)
    sizes.emplace_back(static_cast<int>(std::lround(std::sqrt(times) * own->lines)),
                       static_cast<int>(std::lround(std::sqrt(times) * own->beams)));
  for (const auto& [lines, beams] : sizes) {
    showProgress(std::to_string(lines) + " x " + std::to_string(beams));
    Expected<ScanPtr> large = [&]() -> Expected<ScanPtr> {
      const auto simulated = sampleScan(execution, lines, beams);
      if (!simulated) return simulated.error();
      return simulated->scan;
    }();
    if (!large) return large.error();
    const auto cost = costOfProcess(**large, params, execution.threads, std::min(arguments.runs, 2));
    if (!cost) return cost.error();
    costs.push_back(*cost);
  }
  return costs;
}

bool wanted(const std::vector<std::string>& against, const char* peer) {
  return against.empty() || std::find(against.begin(), against.end(), peer) != against.end();
}

Status bench(const BenchArguments& arguments) {
  const auto settings = arguments.params.settings();
  if (!settings) return settings.error();
  if (arguments.costOnly)
    return printCost(arguments.scan, *settings, arguments.params.execution(), arguments.runs);
  if (arguments.scan.empty() && !arguments.truth.empty()) throw BadArguments("--truth: belongs to a SCAN");
  if (!arguments.scan.empty() && arguments.scale)
    throw BadArguments("--scale: simulates its own scans; leave SCAN out");
  const auto scan = scanToMeasure(arguments, *settings);
  if (!scan) return scan.error();

  BenchReport report;
  report.scan =
      arguments.scan.empty() ? std::string("sample scene ") + sampleScenes().front().name : arguments.scan;
  BenchOptions options;
  options.params = settings->params;
  options.threads = arguments.params.execution().threads;
  options.runs = arguments.runs;
  options.pcl = wanted(arguments.against, "pcl");
  options.octomap = wanted(arguments.against, "octomap");
  options.octomapSingly = std::ranges::find(arguments.against, "octomap-singly") != arguments.against.end();
  const auto missing = [&](bool asked, const std::string& version, const char* name) {
    if (asked && version.empty())
      report.notes.push_back(std::string(name) + " is not built in: not measured");
  };
  missing(options.pcl, pclVersion(), "PCL");
  missing(options.octomap || options.octomapSingly, octomapVersion(), "OctoMap");
  auto costs = measureCosts(arguments, settings->params, *scan->scan);
  if (!costs) return costs.error();
  report.costs = *std::move(costs);
  auto result = runBench(*scan, options, showProgress);
  endProgress();
  if (!result) return result.error();
  report.result = *std::move(result);
  if (arguments.json) {
    std::cout << benchJson(report);
    return success();
  }
  for (const std::string& sentence : report.notes) note(sentence);
  std::cout << benchText(report);
  return success();
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand(
      "bench", "Times every stage and the whole pipeline, and peers on the same points in the same run");
  command->add_option("SCAN", arguments->scan, "The scan's file; without one a sample scene is simulated");
  command->add_option("--truth", arguments->truth,
                      "PCD with the scan's true labels and normals, as simulate --truth writes it");
  command
      ->add_option("--against", arguments->against,
                   "Peers: pcl, octomap, none [default: pcl and octomap where built in]; octomap-singly: "
                   "OctoMap called with every point and ray by itself")
      ->delimiter(',')
      ->check(CLI::IsMember({"pcl", "octomap", "octomap-singly", "none"}));
  command->add_option("--runs", arguments->runs, "Runs, of which the median is told")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--scale", arguments->scale,
                    "Also larger lattices of the same scene: some GiB and some minutes");
  command->add_option("--times", arguments->times, "With --scale: how many times as large")
      ->delimiter(',')
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "One JSON document on standard output");
  command->add_flag("--cost-only", arguments->costOnly)->group("");
  arguments->params.addTo(*command);
  command->callback([arguments, &action] { action = [arguments] { return bench(*arguments); }; });
}

}  // namespace stratascope::cli
