// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/frame_options.h"

namespace stratascope::cli {

void FrameOptions::addTo(CLI::App& command) {
  command
      .add_option("--units", units_,
                  "Unit of the scan files' coordinates; auto: what format or file say, else metres unless "
                  "the distances "
                  "speak clearly for cm or mm (a note says so)")
      ->check(CLI::IsMember(lengthUnitNames()))
      ->capture_default_str();
  command
      .add_option("--axes", axes_,
                  "Axes of the scan files' coordinates: z-up (x forward, y left), y-up (x right, z "
                  "backward), y-up-forward "
                  "(x right, z forward), y-down (a camera's: x right, z forward), z-down (x forward, y "
                  "right); auto: z-up "
                  "unless format or data speak clearly for others (a note says so)")
      ->check(CLI::IsMember(fileAxesNames()))
      ->capture_default_str();
}

FileFrame FrameOptions::frame() const {
  return {lengthUnitFromText(units_).value_or(LengthUnit::Auto),
          fileAxesFromText(axes_).value_or(FileAxes::Auto)};
}

}  // namespace stratascope::cli
