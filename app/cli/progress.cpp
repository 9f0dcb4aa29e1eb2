// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/progress.h"

#include <unistd.h>

#include <iostream>

namespace stratascope::cli {
namespace {

bool onTerminal() {
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  return terminal;
}
constexpr const char* kWipeLine = "\r\033[K";

}  // namespace

void showProgress(const std::string& text) {
  if (onTerminal()) std::cerr << kWipeLine << text << std::flush;
}

void endProgress() {
  if (onTerminal()) std::cerr << kWipeLine << std::flush;
}

void note(const std::string& text) {
  std::cerr << "note: " << text << '\n';
}

}  // namespace stratascope::cli
