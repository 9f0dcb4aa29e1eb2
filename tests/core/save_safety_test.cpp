// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is left of a file when its save is killed, or the disk is full.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "io/file_set.h"
#include "io/file_util.h"
#include "support/save_attack.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;

/// Runs body() in a child; returns what it returns, or 128 + the signal that ended it.
int inChild(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(SaveSafety, AHundredKillsDuringASaveLeaveAWholeFile) {
  const test::TemporaryFolder folder;
  const test::KillResult result = test::killDuringSaves(folder.path().string(), 100, 4);
  EXPECT_EQ(result.survived, 100);
  RecordProperty("interrupted", result.interrupted);
  EXPECT_GT(result.interrupted, 5) << "too few kills came during a save to tell anything";
}

/// A limit on the size of files stands in for a disk that is full: the write stops in the middle.
TEST(SaveSafety, AWriteThatStopsInTheMiddleLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  test::putFile(folder / "file", "old");
  const int result = inChild([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100000, 100000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 2;
    if (writeFileAtomically(folder / "file", std::string(200000, 'x'))) return 3;
    if (writeFileSet(folder.path().string(), {{"file", "new"}, {"other", std::string(200000, 'x')}}))
      return 4;
    return 0;
  });
  EXPECT_EQ(result, 0);
  EXPECT_EQ(*readFile(folder / "file"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(SaveSafety, AFullDiskLeavesTheOldFileAndSaysSo) {
  const test::TemporaryFolder folder;
  const test::FullDisk result = test::saveOnFullDisk(folder.path().string());
  if (result == test::FullDisk::NotAllowed) GTEST_SKIP() << "skipped: no file system of one's own here";
  EXPECT_EQ(result, test::FullDisk::OldFileKept);
}

}  // namespace
}  // namespace stratascope
