// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/stream_arguments.h"

#include <algorithm>
#include <limits>

#include "io/scan_io.h"

namespace stratascope::cli {

void PlayOptions::addTo(CLI::App& command) {
  command
      .add_option("--speed", speed,
                  "How many times faster than the scanner (a line in 26.64 ms); 0 = as fast as it goes")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_flag("--loop", loop, "Scans again and again; a scene with another seed each time");
  command.add_option("--seed", simulated.simulation.seed, "A scene's seed of the noise")
      ->capture_default_str();
  command.add_option("--moving", moving,
                     "Name of an item of the scene that walks to and fro from scan to scan");
}

Expected<ScanSupply> scanSupply(const PlayOptions& options) {
  const Rounds rounds = options.loop ? Rounds::Endless : Rounds::Once;
  if (!options.scan.ends_with(".json")) {
    if (!options.moving.empty()) throw BadArguments("--moving: only a scene has items that can move");
    auto scan = readScan(options.scan);
    if (!scan) return scan.error();
    return supplyOf(std::make_shared<const Scan>(*std::move(scan)), rounds);
  }
  auto scene = loadScene(options.scan);
  if (!scene) return scene.error();
  SimulatedScans simulated = options.simulated;
  simulated.rounds = rounds;
  if (!options.moving.empty()) {
    const auto item = std::find_if(scene->items.begin(), scene->items.end(),
                                   [&](const Scene::Item& i) { return i.name == options.moving; });
    if (item == scene->items.end())
      return Error{options.scan, "", "has no item named \"" + options.moving + "\"", "name one of its items"};
    simulated.movingItem = static_cast<int>(item - scene->items.begin());
  }
  return supplyOf(*std::move(scene), simulated);
}

}  // namespace stratascope::cli
