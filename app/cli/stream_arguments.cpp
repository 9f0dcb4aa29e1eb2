// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/stream_arguments.h"

#include <map>

namespace stratascope::cli {

void PlayOptions::addTo(CLI::App& command) {
  command
      .add_option("--speed", speed,
                  "How many times faster than the scanner (a line in 26.64 ms); 0 = as fast as it goes")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_flag("--loop", loop, "Scans again and again; a scene with another seed each time");
  command.add_option("--seed", play.simulation.seed, "A scene's seed of the noise")->capture_default_str();
  command.add_option("--noise", play.simulation.noise, "A scene's noise: none, or lms200, the scanner's own")
      ->transform(CLI::Transformer(
          std::map<std::string, NoiseModel>{{"none", NoiseModel::None}, {"lms200", NoiseModel::Lms200}}))
      ->default_str("lms200");
  command
      .add_option("--head", play.head,
                  "Head over a scene: scene (as the scene says), steps, or turns while the mirror does")
      ->transform(CLI::Transformer(std::map<std::string, HeadMode>{
          {"scene", HeadMode::AsTheScene}, {"steps", HeadMode::Steps}, {"turns", HeadMode::Turns}}))
      ->default_str("scene");
  command.add_option("--moving", play.moving,
                     "Name of an item of the scene that walks to and fro from scan to scan");
}

PlayRequest playRequest(const PlayOptions& options) {
  PlayRequest request = options.play;
  request.file = playedFile(options.scan);
  request.rounds = options.loop ? Rounds::Endless : Rounds::Once;
  if (!request.moving.empty() && !isScene(request.file))
    throw BadArguments("--moving: only a scene has items that can move");
  return request;
}

}  // namespace stratascope::cli
