// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/score_cases.h"

#include <cmath>
#include <filesystem>

#include "evaluate/sample_scenes.h"
#include "io/labelled_cloud.h"
#include "io/scan_io.h"
#include "segment/visible_pieces.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

TrueScan simulated(const Scene& scene, const SimulationOptions& options, const Execution& execution) {
  SimulatedScan scan = simulateScan(scene, options, execution);
  return {std::make_shared<const Scan>(std::move(scan.scan)), std::move(scan.truthLabels),
          std::move(scan.truthNormals), true};
}

Expected<TrueScan> synpeb(const std::string& path) {
  auto scan = readScan(path);
  if (!scan) return scan.error();
  const auto truth = readLabelledPcd(path);
  if (!truth) return truth.error();
  TrueScan result;
  result.labels = Grid<std::uint32_t>(scan->lattice->lines(), scan->lattice->beams());
  if (result.labels.size() != truth->labels.size())
    return Error{path, "HEIGHT", "no lattice", "SynPEB scans come as lines x beams"};
  std::copy(truth->labels.begin(), truth->labels.end(), result.labels.values().begin());
  result.scan = std::make_shared<const Scan>(std::move(*scan));
  return result;
}

void addSynpeb(const std::string& folder, ScoreCases& all) {
  for (const char* name : {"pc_01", "test_500"}) {
    const std::filesystem::path path =
        std::filesystem::path(folder) / "synpeb" / (std::string(name) + ".pcd");
    std::error_code failed;
    if (folder.empty() || !std::filesystem::is_regular_file(path, failed)) {
      all.notes.push_back(std::string("SynPEB ") + name + ": left out, no folder of scans with synpeb/" +
                          name + ".pcd");
      continue;
    }
    const std::string title = std::string("SynPEB ") + name;
    all.cases.push_back({title, title, [file = path.string()](const Execution&) { return synpeb(file); }});
  }
}

void addSamples(ScoreCases& all) {
  std::uint64_t seed = 0;
  for (const SampleScene& sample : sampleScenes()) {
    ++seed;
    all.cases.push_back(
        {sample.name, sample.name, [sample, seed](const Execution& execution) -> Expected<TrueScan> {
           const auto scene = sceneFromJson(sample.json, sample.name);
           if (!scene) return scene.error();
           return simulated(*scene, {.seed = seed}, execution);
         }});
  }
}

void addRooms(RoomKind kind, const char* purpose, const std::vector<std::uint64_t>& seeds, double sigma,
              ScoreCases& all) {
  const std::string noise = "σ " + std::to_string(std::lround(1000 * sigma)) + " mm";
  std::string list;
  for (const std::uint64_t seed : seeds) list += (list.empty() ? "" : ",") + std::to_string(seed);
  for (const std::uint64_t seed : seeds)
    all.cases.push_back({std::string(kind == RoomKind::Plain ? "plain" : "furnished") + " rooms " + noise +
                             ", " + purpose + " " + list,
                         "room " + std::to_string(seed) + " " + noise,
                         [kind, seed, sigma](const Execution& execution) -> Expected<TrueScan> {
                           return simulated(randomRoom(seed, kind),
                                            {.seed = seed, .sigma = sigma, .systematic = 0}, execution);
                         }});
}

}  // namespace

Grid<std::uint32_t> TrueScan::labelsFor(std::span<const std::uint32_t> found, double overlap) const {
  return wholePlanes ? piecesAsFound(labels, found, overlap) : labels;
}

ScoreCases scoreCases(const ScoreCaseSelection& selection) {
  ScoreCases all;
  addSynpeb(selection.scansFolder, all);
  if (selection.samples) addSamples(all);
  for (const RoomKind kind : selection.kinds)
    for (const double sigma : selection.sigmas) {
      addRooms(kind, "tuning seeds", selection.tuningSeeds, sigma, all);
      addRooms(kind, "checking seeds", selection.checkingSeeds, sigma, all);
    }
  return all;
}

}  // namespace stratascope
