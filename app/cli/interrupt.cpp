// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace stratascope::cli {
namespace {

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void onSignal(int signal) {
  asked = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGPIPE, SIG_IGN);  // a peer that is gone is an error of the write, not of the program
}

bool interrupted() {
  return asked;
}

}  // namespace stratascope::cli
