// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "app/cli/command.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "io/scan_io.h"

namespace stratascope::cli {
namespace {

struct ConvertOptions {
  std::string scan, out, pose;
  bool ascii = false;
  FrameOptions frame;
};

/// Throws BadArguments unless a format that can be written has the extension of `path`.
void requireWritable(const std::string& path) {
  std::string known;
  for (const FormatInfo& format : scanFormats()) {
    if (!format.canWrite) continue;
    for (const std::string extension : format.extensions) {
      if (path.size() > extension.size() && path.ends_with(extension)) return;
      known += (known.empty() ? "" : ", ") + extension;
    }
  }
  throw BadArguments("OUT: '" + path + "' ends in no extension that can be written; use one of " + known);
}

Status convert(const ConvertOptions& options) {
  requireWritable(options.out);
  const auto scan =
      readScan(options.scan, {.pose = poseFromOption(options.pose), .frame = options.frame.frame()});
  if (!scan) return scan.error();
  const Status written =
      writeScan(*scan, options.out, options.ascii ? ScanEncoding::Ascii : ScanEncoding::Binary);
  if (!written) return written;
  for (const std::string& sentence : scan->notes) note(sentence);
  return success();
}

}  // namespace

void addConvert(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert", "Writes a scan in another cloud format, told by OUT's extension");
  command->add_option("SCAN", options->scan, "The scan's file")->required();
  command
      ->add_option("OUT", options->out,
                   "The file to write: lattice and pose are kept where its format can hold them")
      ->required();
  command->add_option(
      "--pose", options->pose,
      "x,y,z,roll,pitch,yaw of the sensor in the map (m, degrees), for a scan in the sensor's own frame; OUT "
      "is written in the map frame");
  command->add_flag("--ascii", options->ascii, "Write PCD and PLY as text, not binary");
  options->frame.addTo(*command);
  command->callback([options, &action] { action = [options] { return convert(*options); }; });
}

}  // namespace stratascope::cli
