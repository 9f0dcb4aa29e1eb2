// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// save_table DIR: kills a process a hundred times while it saves in DIR, saves on a full disk, and prints
// what was left. Exit status 1 if a file was lost.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "support/save_attack.h"

int main(int argc, char** argv) {
  using namespace stratascope::test;
  if (argc != 2) {
    std::fprintf(stderr, "usage: save_table DIR\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    for (const char* part : {"kills", "disk"}) std::filesystem::create_directories(folder / part);
    const KillResult kills = killDuringSaves((folder / "kills").string(), 100, 4);
    std::printf("%-34s %8d kills, %d of them during a save: the file was whole %d times\n",
                "killed while saving", kills.kills, kills.interrupted, kills.survived);
    const FullDisk disk = saveOnFullDisk((folder / "disk").string());
    std::printf("%-34s %s\n", "full disk of 8 MB",
                disk == FullDisk::OldFileKept  ? "the old file was kept, the error says why"
                : disk == FullDisk::NotAllowed ? "skipped: no file system of one's own here"
                                               : "FAILED");
    return kills.survived == kills.kills && disk != FullDisk::Failed ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "save_table: %s\n", e.what());
    return 1;
  }
}
