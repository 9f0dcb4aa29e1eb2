// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/save_attack.h"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <thread>

#include "io/file_set.h"
#include "io/file_util.h"

namespace stratascope::test {
namespace {

namespace fs = std::filesystem;

size_t temporariesIn(const fs::path& folder) {
  size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    count += entry.path().filename().string().starts_with(".stratascope-");
  return count;
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

int exitStatus(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void must(bool good, const char* what) {
  if (!good) throw std::runtime_error(what);
}

}  // namespace

KillResult killDuringSaves(const std::string& folder, int kills, unsigned seed) {
  const std::string path = folder + "/file";
  constexpr size_t kBytes = 1u << 20;
  const auto content = [](int save) {
    return std::string(kBytes + static_cast<size_t>(save), static_cast<char>('a' + save % 26));
  };
  must(writeFileAtomically(path, content(0)).hasValue(), "the first save failed");
  std::mt19937 random(seed);
  KillResult result;
  int saved = 0;
  for (; result.kills < kills; ++result.kills) {
    int ready[2];
    must(::pipe(ready) == 0, "no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
      for (int save = saved + 1;; ++save) {
        const std::string bytes = content(save);
        if (::write(ready[1], "x", 1) != 1 || !writeFileAtomically(path, bytes)) ::_exit(1);
      }
    }
    ::close(ready[1]);
    char mark = 0;
    must(::read(ready[0], &mark, 1) == 1, "the child did not begin");  // the save begins now
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 1500));
    must(::kill(child, SIGKILL) == 0, "no kill");
    must(exitStatus(child) == 128 + SIGKILL, "a save failed");
    ::close(ready[0]);

    const auto now = readFile(path);
    const bool whole = now && now->size() >= kBytes + static_cast<size_t>(saved) &&
                       *now == content(static_cast<int>(now->size() - kBytes));
    result.survived += whole;
    if (whole) saved = static_cast<int>(now->size() - kBytes);
    if (temporariesIn(folder)) {
      ++result.interrupted;
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path() != path) fs::remove(entry.path());
    }
  }
  return result;
}

FullDisk saveOnFullDisk(const std::string& folder) {
  constexpr int kNotAllowed = 77;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto attack = [&] {
      if (!mountSmallDisk(folder)) return kNotAllowed;
      const std::string path = folder + "/file", old(3u << 20, 'o');
      if (!writeFileAtomically(path, old)) return 2;
      const Status full = writeFileAtomically(path, std::string(6u << 20, 'n'));
      if (full || full.error().what.find("full") == std::string::npos || full.error().file != path) return 3;
      const auto set = writeFileSet(folder, {{"file", "new"}, {"big", std::string(6u << 20, 'n')}});
      if (set || set.error().what.find("full") == std::string::npos) return 4;
      if (*readFile(path) != old) return 5;
      if (std::distance(fs::directory_iterator(folder), fs::directory_iterator()) != 1) return 6;
      return writeFileAtomically(path, std::string(4u << 20, 'n')) ? 0 : 7;  // what fits still works
    };
    ::_exit(attack());
  }
  const int status = exitStatus(child);
  return status == 0             ? FullDisk::OldFileKept
         : status == kNotAllowed ? FullDisk::NotAllowed
                                 : FullDisk::Failed;
}

}  // namespace stratascope::test
