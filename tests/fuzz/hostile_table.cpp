// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads every hostile file in a child process of its own and prints a table: a row a format with cases, crashes, hangs, silent
// acceptances and the largest memory of a child. Exit status 1 if there was any.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "io/scan_io.h"
#include "support/hostile_lists.h"

namespace {

enum Outcome { Refused = 0, Accepted = 10, Crashed, Hung };

struct Result {
  Outcome outcome;
  long peakKiB;
};

Result readInChild(const std::string& path, const std::string& bytes) {
  constexpr unsigned kSeconds = 10;
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    const auto scans = stratascope::readAllScanBytes(path, bytes);
    _exit(scans ? Accepted : Refused);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (WIFEXITED(status) && (WEXITSTATUS(status) == Refused || WEXITSTATUS(status) == Accepted)) return {static_cast<Outcome>(WEXITSTATUS(status)), usage.ru_maxrss};
  return {WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? Hung : Crashed, usage.ru_maxrss};
}

}  // namespace

int main() {
  std::printf("%-12s %8s %8s %8s %8s %12s\n", "format", "hostile", "crashes", "hangs", "silent", "memory/MiB");
  int findings = 0;
  for (const auto& format : stratascope::test::formatsUnderAttack()) {
    int crashes = 0, hangs = 0, silent = 0;
    long peak = 0;
    for (const auto& file : format.hostile) {
      const Result result = readInChild("hostile" + format.extension, file.bytes);
      crashes += result.outcome == Crashed;
      hangs += result.outcome == Hung;
      silent += result.outcome == Accepted;
      peak = std::max(peak, result.peakKiB);
      if (result.outcome != Refused) std::fprintf(stderr, "%s: %s\n", format.name.c_str(), file.name.c_str());
    }
    std::printf("%-12s %8zu %8d %8d %8d %12ld\n", format.name.c_str(), format.hostile.size(), crashes, hangs, silent, peak / 1024);
    findings += crashes + hangs + silent;
  }
  return findings == 0 ? 0 : 1;
}
