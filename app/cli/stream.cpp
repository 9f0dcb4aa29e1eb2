// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/param_options.h"
#include "app/cli/progress.h"
#include "app/cli/stream_arguments.h"
#include "app/cli/text_table.h"
#include "app/steady_memory.h"
#include "io/export.h"
#include "io/file_util.h"
#include "stream/live_session.h"

namespace stratascope::cli {
namespace {

struct Options {
  PlayOptions play;
  std::string out;
  bool untilEnd = false, json = false;
  double giveUp = 10;
  HeadMotion motion;
  ParamOptions params;
};

Expected<std::unique_ptr<RowSource>> sourceFor(const Options& options) {
  StreamRequest request;
  request.address = options.play.scan;
  request.speed = options.play.speed;
  if (looksLikeDeviceAddress(request.address)) {
    const auto address = streamAddressFromText(request.address);
    if (!address) throw BadArguments(address.error().message());
  } else {
    request.play = playRequest(options.play);
  }
  request.telegrams.motion = options.motion;
  request.telegrams.giveUp = std::chrono::milliseconds(static_cast<std::int64_t>(options.giveUp * 1000));
  request.telegrams.endWhenRefused = options.untilEnd;
  return openStream(request);
}

std::string progressLine(const LiveProgress& p) {
  const StreamCounters& c = p.counters;
  std::string line = std::string(streamStateName(p.state)) + ": " + std::to_string(p.arrived) + " of " +
                     std::to_string(p.lines) + " lines, " + std::to_string(p.computed) + " computed";
  for (const auto& [name, count] : {std::pair{"missing", c.missing},
                                    {"dropped", c.dropped},
                                    {"bad CRC", c.badCrc},
                                    {"reconnected", c.connections > 0 ? c.connections - 1 : 0}})
    if (count > 0) line += ", " + std::to_string(count) + " " + name;
  return line;
}

std::string counterTable(const LiveProgress& p) {
  const StreamCounters& c = p.counters;
  std::vector<std::string> names, counts;
  for (const auto& [name, count] : {std::pair{"received", c.received},
                                    {"missing", c.missing},
                                    {"dropped", c.dropped},
                                    {"duplicated", c.duplicated},
                                    {"out of order", c.outOfOrder},
                                    {"bad CRC", c.badCrc},
                                    {"resynchronised", c.resynchronised},
                                    {"connections", c.connections}}) {
    names.emplace_back(name);
    counts.push_back(std::to_string(count));
  }
  return textTable({names, counts});
}

Status stream(const Options& options) {
  const auto settings = options.params.settings();
  if (!settings) return settings.error();
  if (settings->poses.size() > 1) throw BadArguments("--pose: one stream has one pose");
  auto source = sourceFor(options);
  if (!source) return source.error();

  LiveOptions live;
  const std::string file = playedFile(options.play.scan);
  live.path = file.empty() ? options.play.scan : file;
  live.params = settings->params;
  live.threads = options.params.execution().threads;
  live.scans = options.untilEnd ? 0 : 1;
  if (!settings->poses.empty()) live.pose = settings->poses[0];
  catchInterrupts();
  returnLargeBlocks();
  LiveSession session(*std::move(source), live);
  bool stopping = false;
  while (!session.waitFinished(std::chrono::milliseconds(100))) {
    showProgress(progressLine(session.progress()));
    if (interrupted() && !std::exchange(stopping, true)) session.stop();
  }
  endProgress();
  const LiveUpdate end = session.take();
  const SnapshotPtr snapshot = session.snapshot();
  if (end.error) return Error{options.play.scan, "", *end.error, ""};
  if (!snapshot) {
    const std::string why =
        end.progress.state == StreamState::Failed ? end.progress.message : "no line arrived";
    return Error{options.play.scan, "", why, "nothing was written"};
  }
  const auto written = exportResults(*snapshot, options.out, countersJson(end.progress.counters));
  if (!written) return written.error();

  const ScanProducts& scan = snapshot->scans[0];
  for (const std::string& sentence : scan.planes->notes) note(scan.scan->name + ": " + sentence);
  if (end.progress.arrived < end.progress.lines)
    note(std::to_string(end.progress.lines - end.progress.arrived) + " of " +
         std::to_string(end.progress.lines) + " lines are missing");
  if (options.json) {
    const auto document = readFile((std::filesystem::path(options.out) / "run.json").string());
    if (!document) return document.error();
    std::cout << *document;
    return success();
  }
  std::cout << counterTable(end.progress) << '\n';
  for (const std::string& path : *written) std::cout << path << '\n';
  return success();
}

}  // namespace

void addStream(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("stream", "Maps a scan while it comes in, and writes what process would");
  command
      ->add_option(
          "SOURCE", options->play.scan,
          "tcp://HOST:PORT, serial:DEVICE?baud=500000, or a scan file or scene (.json) to be replayed, "
          "with or without replay: before it")
      ->required();
  command->add_option("--out", options->out, "Directory for the results; made if missing")->required();
  command->add_flag(
      "--until-end", options->untilEnd,
      "Goes on after the first scan, until the stream ends or Ctrl+C; the last scan is written");
  command->add_flag("--json", options->json, "The document of run.json on standard output");
  command
      ->add_option("--give-up", options->giveUp,
                   "Seconds without a byte after which a peer is given up; 0 = never")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  const std::string head = "Scanner whose head does not speak";
  command->add_option("--head-start", options->motion.startDeg, "Elevation of the first line, degrees")
      ->capture_default_str()
      ->group(head);
  command->add_option("--head-step", options->motion.stepDeg, "From line to line, degrees")
      ->capture_default_str()
      ->group(head);
  command->add_flag("--head-turns", options->motion.turnsOn, "The head does not stop while the mirror turns")
      ->group(head);
  command->add_option("--lines", options->motion.lines, "Lines of a scan; 0 = it ends with the stream")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str()
      ->group(head);
  command
      ->add_option("--range-bits", options->motion.rangeBits,
                   "Bits of a range: 13 (8 m or 80 m), 14 (16 m), 15 (32 m)")
      ->check(CLI::Range(13, 15))
      ->capture_default_str()
      ->group(head);
  options->play.addTo(*command);
  options->params.addTo(*command);
  command->callback([options, &action] { action = [options] { return stream(*options); }; });
}

}  // namespace stratascope::cli
