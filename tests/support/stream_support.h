// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <thread>

#include "stream/scanner_server.h"

namespace stratascope::test {

struct StreamScanOptions {
  std::uint64_t seed = 1;
  int lines = 80, beams = 61;
  bool headTurns = false;
};
/// A simulated scan of a random room with the scanner's noise: ranges in whole millimetres already.
ScanPtr streamScan(const StreamScanOptions& options = {});

/// Bit for bit, NaN included.
bool sameLattice(const ScanLattice& a, const ScanLattice& b);

/// A ScannerServer on a free loopback port, in a thread of its own until destroyed.
class ServerThread {
public:
  ServerThread(ScanSupply scans, const ServeOptions& options);
  ~ServerThread();
  std::uint16_t port() const { return listener_->port(); }

private:
  std::unique_ptr<TcpListener> listener_;
  ScannerServer server_;
  std::jthread thread_;
};

/// Open files and threads of this process, for leaks.
int openDescriptors();
int runningThreads();
/// Resident memory of this process, bytes.
std::size_t residentBytes();
/// Whether memory that is freed leaves the process, or serves anew: this sanitizer holds it back.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kFreedMemoryReturns = false;
#else
inline constexpr bool kFreedMemoryReturns = true;
#endif

}  // namespace stratascope::test
