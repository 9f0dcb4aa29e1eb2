// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stratascope::test {

struct KillResult {
  int kills = 0;
  int survived = 0;     ///< the file was whole after it: the old one or the new one
  int interrupted = 0;  ///< the kill came during a save
};
/// Kills a process again and again while it saves a file of 1 MB in this folder.
KillResult killDuringSaves(const std::string& folder, int kills, unsigned seed);

enum class FullDisk {
  OldFileKept,  ///< and the error says that the disk is full, and what fits can be saved afterwards
  Failed,
  NotAllowed,  ///< no file system of one's own can be had here
};
/// Saves on a file system of 8 MB that only a child process sees.
FullDisk saveOnFullDisk(const std::string& folder);

}  // namespace stratascope::test
