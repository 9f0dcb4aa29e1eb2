// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <thread>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/stream_arguments.h"
#include "stream/scan_encoder.h"
#include "stream/scanner_server.h"

namespace stratascope::cli {
namespace {

struct Options {
  PlayOptions play;
  std::uint16_t port = 0;
  std::string bind = "127.0.0.1";
  bool once = false;
};

Status serve(const Options& options) {
  auto scans = openSupply(playRequest(options.play));
  if (!scans) return scans.error();
  // What cannot be sent should be said before anyone listens.
  const ScanPtr first = (*scans)(0);
  if (const auto encoder = ScanEncoder::make(first); !encoder) return encoder.error();
  auto listener = TcpListener::listen(options.bind, options.port);
  if (!listener) return listener.error();

  ServeOptions serving;
  serving.speed = options.play.speed;
  serving.once = options.once;
  serving.log = [](const std::string& text) { note(text); };
  ScannerServer server([&](std::uint32_t round) { return round == 0 ? first : (*scans)(round); }, serving);
  catchInterrupts();
  const bool six = options.bind.find(':') != std::string::npos;
  std::cout << "tcp://" << (six ? "[" : "") << options.bind << (six ? "]" : "") << ":" << (*listener)->port()
            << std::endl;
  std::stop_source stop;
  const std::jthread watch([&](const std::stop_token& over) {
    while (!over.stop_requested() && !interrupted())
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  return server.run(**listener, stop.get_token());
}

}  // namespace

void addServe(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("serve", "Plays the scanner: sends a scan's lines over TCP as LMS 2xx telegrams");
  command->add_option("SCAN", options->play.scan, "A scan with a lattice, or a scene (.json) to be scanned")
      ->required();
  command->add_option("--port", options->port, "TCP port; 0 takes a free one. The address is printed")
      ->required();
  command->add_option("--bind", options->bind, "Address to listen on; 0.0.0.0 lets other machines in")
      ->capture_default_str();
  command->add_flag("--once", options->once, "Ends when all has been sent once");
  options->play.addTo(*command);
  command->callback([options, &action] {
    if (options->once && options->play.loop) throw BadArguments("--once and --loop exclude each other");
    action = [options] { return serve(*options); };
  });
}

}  // namespace stratascope::cli
