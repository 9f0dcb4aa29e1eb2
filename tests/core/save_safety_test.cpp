// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is left of a file when its save is killed, or the disk is full.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>

#include "io/file_set.h"
#include "io/file_util.h"
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

size_t temporariesIn(const fs::path& folder) {
  size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    count += entry.path().filename().string().starts_with(".stratascope-");
  return count;
}

TEST(SaveSafety, AHundredKillsDuringASaveLeaveAWholeFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "file";
  constexpr size_t kBytes = 1u << 20;
  const auto content = [](int save) {
    return std::string(kBytes + static_cast<size_t>(save), static_cast<char>('a' + save % 26));
  };
  ASSERT_TRUE(writeFileAtomically(path, content(0)));
  std::mt19937 random(4);
  size_t interrupted = 0;
  int saved = 0;
  for (int kill = 0; kill < 100; ++kill) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      for (int save = saved + 1;; ++save) {
        const std::string bytes = content(save);
        if (::write(ready[1], "x", 1) != 1 || !writeFileAtomically(path, bytes)) ::_exit(1);
      }
    }
    ::close(ready[1]);
    char mark = 0;
    ASSERT_EQ(::read(ready[0], &mark, 1), 1);  // the save begins now
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 1500));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "a save failed";
    ::close(ready[0]);

    const auto now = readFile(path);
    ASSERT_TRUE(now);
    ASSERT_GE(now->size(), kBytes + static_cast<size_t>(saved));
    saved = static_cast<int>(now->size() - kBytes);
    ASSERT_TRUE(*now == content(saved)) << "kill " << kill << " left a part";
    if (const size_t left = temporariesIn(folder.path())) {
      ++interrupted;
      for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path() != path) fs::remove(entry.path());
    }
  }
  RecordProperty("interrupted", static_cast<int>(interrupted));
  EXPECT_GT(interrupted, 5u) << "too few kills came during a save to tell anything";
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

bool putText(const char* path, const std::string& text) {
  const int fd = ::open(path, O_WRONLY);
  const bool good = fd >= 0 && ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (fd >= 0) ::close(fd);
  return good;
}

/// A file system of 8 MB, seen by this process alone. False where that is not allowed.
bool mountSmallDisk(const std::string& where) {
  const std::string user = std::to_string(::geteuid()), group = std::to_string(::getegid());
  if (::unshare(CLONE_NEWNS) != 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    if (!putText("/proc/self/setgroups", "deny") || !putText("/proc/self/uid_map", "0 " + user + " 1") ||
        !putText("/proc/self/gid_map", "0 " + group + " 1"))
      return false;
  }
  ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
  return ::mount("tmpfs", where.c_str(), "tmpfs", 0, "size=8m") == 0;
}

TEST(SaveSafety, AFullDiskLeavesTheOldFileAndSaysSo) {
  constexpr int kNotAllowed = 77;
  const test::TemporaryFolder folder;
  const int result = inChild([&] {
    if (!mountSmallDisk(folder.path().string())) return kNotAllowed;
    const std::string old(3u << 20, 'o');
    if (!writeFileAtomically(folder / "file", old)) return 2;
    const Status full = writeFileAtomically(folder / "file", std::string(6u << 20, 'n'));
    if (full || full.error().what.find("full") == std::string::npos || full.error().file != folder / "file")
      return 3;
    const auto set =
        writeFileSet(folder.path().string(), {{"file", "new"}, {"big", std::string(6u << 20, 'n')}});
    if (set || set.error().what.find("full") == std::string::npos) return 4;
    if (*readFile(folder / "file") != old) return 5;
    if (std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) != 1) return 6;
    return writeFileAtomically(folder / "file", std::string(4u << 20, 'n')) ? 0 : 7;  // what fits still works
  });
  if (result == kNotAllowed) GTEST_SKIP() << "skipped: no file system of one's own here";
  EXPECT_EQ(result, 0);
}

}  // namespace
}  // namespace stratascope
