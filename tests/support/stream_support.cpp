// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/stream_support.h"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "sim/random_room.h"
#include "sim/scan_simulator.h"

namespace stratascope::test {
namespace {

int entriesOf(const char* directory) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory)) ++count;
  return count;
}

}  // namespace

ScanPtr streamScan(const StreamScanOptions& options) {
  Scene scene = randomRoom(options.seed);
  scene.scanner.lines = options.lines;
  scene.scanner.beams = options.beams;
  scene.scanner.continuousHead = options.headTurns;
  return std::make_shared<const Scan>(simulateScan(scene, {.seed = options.seed}).scan);
}

bool sameLattice(const ScanLattice& a, const ScanLattice& b) {
  const auto p = a.points().values(), q = b.points().values();
  return a.lines() == b.lines() && a.beams() == b.beams() && a.missingCount() == b.missingCount() &&
         std::memcmp(p.data(), q.data(), p.size_bytes()) == 0;
}

ServerThread::ServerThread(ScanSupply scans, const ServeOptions& options)
    : listener_(TcpListener::listen("127.0.0.1", 0).value()),
      server_(std::move(scans), options),
      thread_([this](const std::stop_token& stop) { (void)server_.run(*listener_, stop); }) {}

ServerThread::~ServerThread() {
  thread_.request_stop();
  thread_.join();
}

int openDescriptors() {
  return entriesOf("/proc/self/fd");
}
int runningThreads() {
  return entriesOf("/proc/self/task");
}

std::size_t residentBytes() {
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace stratascope::test
