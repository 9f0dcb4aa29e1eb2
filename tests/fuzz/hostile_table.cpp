// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads every hostile file in a child process of its own and prints a table: a row a format with cases,
// crashes, hangs, silent acceptances and the most memory a child took for reading. Exit status 1 if there was
// any.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "io/scan_io.h"
#include "support/hostile_lists.h"

namespace {

enum Outcome { Refused = 0, Accepted = 10, Crashed, Hung };

struct Result {
  Outcome outcome;
  long peakKiB;
};

/// A line "NAME: 123 kB" of this process's status.
long statusKiB(const char* name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name, 0) == 0) return std::atol(line.c_str() + std::strlen(name) + 1);
  return 0;
}

Result readInChild(const std::string& path, const std::string& bytes) {
  constexpr unsigned kSeconds = 10;
  std::fflush(stdout);
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak of this process, not of its parent
    const long before = statusKiB("VmRSS");
    const auto scans = stratascope::readAllScanBytes(path, bytes);
    const long grown = statusKiB("VmHWM") - before;
    _exit(write(ends[1], &grown, sizeof grown) != sizeof grown ? Crashed : scans ? Accepted : Refused);
  }
  close(ends[1]);
  long grown = 0;
  const bool told = read(ends[0], &grown, sizeof grown) == sizeof grown;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (told && WIFEXITED(status) && (WEXITSTATUS(status) == Refused || WEXITSTATUS(status) == Accepted))
    return {static_cast<Outcome>(WEXITSTATUS(status)), grown};
  return {WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? Hung : Crashed, grown};
}

}  // namespace

int main() {
  std::printf("%-12s %8s %8s %8s %8s %12s\n", "format", "hostile", "crashes", "hangs", "silent",
              "memory/MiB");
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
    std::printf("%-12s %8zu %8d %8d %8d %12ld\n", format.name.c_str(), format.hostile.size(), crashes, hangs,
                silent, peak / 1024);
    findings += crashes + hangs + silent;
  }
  return findings == 0 ? 0 : 1;
}
