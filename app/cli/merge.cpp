// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "app/cli/text_table.h"
#include "io/map_io.h"
#include "params/param_table.h"

namespace stratascope::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> maps;
  std::string out, cell, epsilon;
  bool json = false;
};

std::optional<double> lengthFromOption(const char* key, const std::string& text) {
  if (text.empty()) return {};
  PipelineParams params;
  const Status set = setParam(params, key, text);
  if (!set) throw BadArguments(std::string("--") + key + ": " + set.error().what + "; " + set.error().remedy);
  if (const auto problems = params.validate(); !problems.empty()) throw BadArguments(problems.front());
  return findParam(key)->get(params);
}

Status merge(const MergeOptions& options) {
  const MapAssumptions assumptions{lengthFromOption("cell", options.cell),
                                   lengthFromOption("epsilon", options.epsilon)};
  std::vector<OpenedMap> maps;
  for (const std::string& path : options.maps) {
    showProgress("reading " + path);
    auto map = readMap(path, assumptions);
    endProgress();
    if (!map) return map.error();
    maps.push_back(*std::move(map));
  }
  showProgress("merging");
  const auto merged = mergeMaps(maps);
  endProgress();
  if (!merged) return merged.error();
  std::string directory;
  const auto files = mapFiles(merged->stored, options.out, directory);
  if (!files) return files.error();
  const auto written = writeFileSet(directory, *files);
  if (!written) return written.error();

  for (const std::string& sentence : merged->notes) note(sentence);
  if (options.json) {
    std::cout << mapDocument(merged->stored);
    return success();
  }
  std::cout << textTable({{"maps", "scans", "cells", "records"},
                          {std::to_string(maps.size()), std::to_string(merged->stored.sources.size()),
                           std::to_string(merged->stored.map.cells()),
                           std::to_string(merged->stored.map.records.size())}})
            << '\n';
  for (const std::string& path : *written) std::cout << path << '\n';
  return success();
}

}  // namespace

void addMerge(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command = app.add_subcommand(
      "merge", "Joins exported extended maps of the same grid: the map of all their points, in any order");
  command
      ->add_option("MAP", options->maps,
                   "Results of process or merge: directories, .strata files, or intervals.csv; one alone is "
                   "written anew in OUT's format")
      ->required();
  command
      ->add_option(
          "-o,--out", options->out,
          "What to write: .strata, .csv (intervals), .asc or .tif (2.5D map), .ply or .vtp (mesh), or a "
          "directory for the first three")
      ->required();
  command->add_option(
      "--cell", options->cell,
      "Cell size of tables without a run.json beside them (m); else found from their centres");
  command->add_option("--epsilon", options->epsilon,
                      "Height gap of tables without a run.json beside them (m), default 0.1");
  command->add_flag("--json", options->json,
                    "The result's provenance as one JSON document on standard output");
  command->callback([options, &action] { action = [options] { return merge(*options); }; });
}

}  // namespace stratascope::cli
