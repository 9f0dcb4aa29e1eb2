// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <iostream>
#include <string>

#include "app/cli/command.h"
#include "io/export.h"

namespace {

enum ExitStatus { kDone = 0, kBadInput = 1, kBadArguments = 2, kInternalError = 3 };

/// One line on stderr, whatever the text holds.
int complain(ExitStatus status, std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  std::cerr << "stratascope-cli: " << text << '\n';
  return status;
}

int run(int argc, char** argv) {
  using namespace stratascope;
  CLI::App app(
      "Turns scans of a rotating 2D laser scanner into planes, edges, 2.5D and extended 2.5D maps. "
      "Lengths are metres, angles degrees.",
      "stratascope-cli");
  app.set_version_flag("--version", versionText());
  app.require_subcommand(1);
  app.footer("Exit status: 0 done, 1 the input is bad, 2 the arguments are bad, 3 an internal error.");
  cli::Action action;
  cli::addInfo(app, action);
  cli::addProcess(app, action);
  cli::addConvert(app, action);
  cli::addSimulate(app, action);
  cli::addScore(app, action);
  cli::addBench(app, action);
  cli::addMerge(app, action);
  cli::addServe(app, action);
  cli::addStream(app, action);
  cli::addSweep(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain(kBadArguments, std::string(error.what()) + " (--help tells more)");
  }
  const Status status = action();
  if (!status) return complain(kBadInput, status.error().message());
  if (!std::cout.flush()) return complain(kBadInput, "standard output: cannot be written");
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const stratascope::cli::BadArguments& error) {
    return complain(kBadArguments, std::string(error.what()) + " (--help tells more)");
  } catch (const std::bad_alloc&) {
    return complain(kInternalError, "out of memory");
  } catch (const std::exception& error) {
    return complain(kInternalError, std::string("internal error: ") + error.what());
  } catch (...) {
    return complain(kInternalError, "internal error");
  }
}
