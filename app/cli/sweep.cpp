// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/sweep.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "app/cli/scan_arguments.h"
#include "app/cli/text_table.h"
#include "io/file_util.h"
#include "io/number_text.h"
#include "io/scan_paths.h"
#include "params/param_table.h"

namespace stratascope::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SweepOptions {
  std::vector<std::string> scans;
  SweepPlan plan;
  bool geometric = false, json = false;
  std::string csv;
  FrameOptions frame;
  ParamOptions params;
};

std::string tableText(const std::string& key, const std::vector<SweepSample>& samples) {
  std::vector<std::vector<std::string>> rows = {
      {key, "planes", "classified", "in planes", "records", "sigma/mm", "seconds"}};
  for (const SweepSample& s : samples) {
    if (s.figures)
      rows.push_back({numberText(s.value), std::to_string(s.figures->planes), fixed(s.figures->classified, 4),
                      fixed(s.figures->inPlanes, 4), std::to_string(s.figures->records),
                      fixed(1e3 * s.figures->meanSigma, 3), fixed(s.figures->seconds, 3)});
    else
      rows.push_back({numberText(s.value), "-", "-", "-", "-", "-", "-"});
  }
  return textTable(rows);
}

Json asJson(const SweepPlan& plan, const std::vector<SweepSample>& samples) {
  Json document;
  document["parameter"] = plan.key;
  document["samples"] = Json::array();
  for (const SweepSample& s : samples) {
    Json sample{{"value", s.value}};
    if (s.figures) {
      sample["planes"] = s.figures->planes;
      sample["classified"] = s.figures->classified;
      sample["in_planes"] = s.figures->inPlanes;
      sample["records"] = s.figures->records;
      sample["mean_sigma"] = s.figures->meanSigma;  // NaN is written as null
      sample["seconds"] = s.figures->seconds;
    } else {
      sample["problem"] = s.problem;
    }
    document["samples"].push_back(std::move(sample));
  }
  return document;
}

Status sweep(SweepOptions options) {
  SweepPlan& plan = options.plan;
  if (const ParamInfo* info = findParam(plan.key)) plan.key = info->key;
  if (options.geometric) plan.spacing = SweepPlan::Spacing::Geometric;
  if (const auto values = sweepValues(plan); !values) throw BadArguments(values.error().message());
  const auto settings = options.params.settings();
  if (!settings) return settings.error();
  const auto files = scanFiles(options.scans);
  if (!files) return files.error();
  auto scans = readScans(*files, {settings->poses.begin(), settings->poses.end()},
                         std::vector<FileFrame>(files->size(), options.frame.frame()));
  if (!scans) return scans.error();

  size_t done = 0;
  const auto samples =
      runSweep(*scans, settings->params, plan, options.params.execution(), [&](const SweepSample&) {
        showProgress("sample " + std::to_string(++done) + " of " + std::to_string(plan.steps));
      });
  endProgress();
  if (!samples) return samples.error();
  for (const SweepSample& s : *samples)
    if (!s.figures) note(plan.key + " " + numberText(s.value) + ": " + s.problem);
  if (!options.csv.empty()) {
    Snapshot inputs;
    for (const ScanPtr& scan : *scans) {
      inputs.scans.emplace_back();
      inputs.scans.back().scan = scan;
      inputs.scans.back().classes = std::make_shared<const ClassImage>();  // not told of here
    }
    const auto lines = sweepProvenance(inputs, settings->params, plan);
    if (!lines) return lines.error();
    const Status written = writeFileAtomically(options.csv, tableCsv(sweepTable(plan, *samples), *lines));
    if (!written) return written.error();
  }
  std::cout << (options.json
                    ? asJson(plan, *samples).dump(2, ' ', false, Json::error_handler_t::replace) + '\n'
                    : tableText(plan.key, *samples));
  return success();
}

}  // namespace

void addSweep(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* command = app.add_subcommand(
      "sweep", "Runs one parameter over a range and tells what each value leads to, without writing maps");
  command->add_option("SCAN", options->scans, "Scan files, as process takes them")->required();
  command->add_option("--param", options->plan.key, "The parameter's option, as in --help, without dashes")
      ->required();
  command->add_option("--from", options->plan.from, "First value")->required();
  command->add_option("--to", options->plan.to, "Last value")->required();
  command->add_option("--steps", options->plan.steps, "Number of samples, both ends included")
      ->capture_default_str();
  command->add_flag("--geometric", options->geometric, "Equal ratios and not equal differences");
  command->add_option("--csv", options->csv, "Write the samples to this file as well");
  command->add_flag("--json", options->json, "One JSON document on standard output");
  options->frame.addTo(*command);
  options->params.addTo(*command);
  command->callback([options, &action] { action = [options] { return sweep(*options); }; });
}

}  // namespace stratascope::cli
