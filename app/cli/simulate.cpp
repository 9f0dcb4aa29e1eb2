// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "io/file_util.h"
#include "io/pcd_compressed_writer.h"
#include "sim/scan_simulator.h"
#include "sim/truth_export.h"

namespace stratascope::cli {
namespace {

struct SimulateOptions {
  std::string scene, out, truth;
  SimulationOptions simulation;
  int threads = 0;
};

Status simulate(const SimulateOptions& options) {
  const auto scene = loadScene(options.scene);
  if (!scene) return scene.error();
  showProgress("scanning " + scene->name);
  const SimulatedScan result = simulateScan(*scene, options.simulation, {.threads = options.threads});
  endProgress();
  // Both or none: what is new is taken away again if its companion cannot be written.
  std::error_code code;
  const bool outWasThere = std::filesystem::exists(options.out, code);
  const Status written = writeFileAtomically(options.out, pcdCompressed(result.scan));
  if (!written) return written;
  if (!options.truth.empty()) {
    const Status truth = writeFileAtomically(options.truth, truthPcd(result));
    if (!truth) {
      if (!outWasThere) std::filesystem::remove(options.out, code);
      return truth;
    }
  }
  const ScanLattice& lattice = *result.scan.lattice;
  std::cout << options.out << ": " << lattice.lines() << " lines x " << lattice.beams() << " beams, "
            << lattice.missingCount() << " without a return\n";
  return success();
}

}  // namespace

void addSimulate(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Scans a scene with a rotating 2D laser scanner");
  command->add_option("SCENE", options->scene, "JSON file of the scene")->required();
  command->add_option("-o,--out", options->out, "PCD file to write")->required();
  command->add_option("--seed", options->simulation.seed, "Seed of the noise")->capture_default_str();
  command->add_option("--noise", options->simulation.noise, "none, or lms200: the scanner's own")
      ->transform(CLI::Transformer(
          std::map<std::string, NoiseModel>{{"none", NoiseModel::None}, {"lms200", NoiseModel::Lms200}}))
      ->default_str("lms200");
  command
      ->add_option("--sigma", options->simulation.sigma, "Standard deviation of the range noise of lms200, m")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--truth", options->truth,
                      "PCD file for the truth: x y z normal_x normal_y normal_z label, without noise");
  command->add_option("--threads", options->threads, "Number of threads, 0 = all; never changes a result")
      ->check(CLI::Range(0, 1024));
  command->callback([options, &action] { action = [options] { return simulate(*options); }; });
}

}  // namespace stratascope::cli
