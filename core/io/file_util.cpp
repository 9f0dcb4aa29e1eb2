// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_util.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <new>
#include <system_error>

namespace stratascope {

namespace {

std::string causeOf(int errorNumber) {
  return std::generic_category().message(errorNumber);
}

/// Closes on leaving the scope; close() tells whether that worked.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  int get() const { return fd_; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

private:
  int fd_;
};

const char* kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "this is a directory";
  if (S_ISFIFO(mode)) return "this is a pipe";
  if (S_ISSOCK(mode)) return "this is a socket";
  return "this is a device";
}

Error unreadable(const std::string& path, int errorNumber) {
  const char* remedy = errorNumber == ENOENT ? "check the name" : "";
  return {path, "", "cannot be read: " + causeOf(errorNumber), remedy};
}

Error unwritable(const std::string& path, int errorNumber) {
  if (errorNumber == ENOSPC || errorNumber == EDQUOT)
    return {path, "", "cannot be written: the disk is full (" + causeOf(errorNumber) + ")",
            "free some space or choose another folder"};
  if (errorNumber == ENOENT)
    return {path, "", "cannot be written: its folder does not exist", "make the folder first"};
  return {path, "", "cannot be written: " + causeOf(errorNumber), "choose another file or folder"};
}

/// errno, or 0 when all bytes are written.
int writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd, bytes.data(), std::min(bytes.size(), size_t{1} << 30));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return EIO;
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return 0;
}

/// A file of its own name beside the target, so that the rename stays inside one file system.
std::string temporaryBeside(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter{0};
  return (target.parent_path() /
          (".stratascope-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp"))
      .string();
}

}  // namespace

Expected<std::string> readFile(const std::string& path, std::uint64_t maxBytes) {
  if (path.empty()) return Error{path, "", "no file name given", "name a file"};
  if (path.find('\0') != std::string::npos)
    return Error{path, "", "the file name holds a NUL byte", "check the name"};
  // O_NONBLOCK: opening a pipe must not wait for someone to write to it
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.get() < 0) return unreadable(path, errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return unreadable(path, errno);
  if (!S_ISREG(info.st_mode))
    return Error{path, "", std::string(kindOf(info.st_mode)) + ", not a file", "name a regular file"};
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size > maxBytes)
    return Error{
        path, "",
        "too large: " + std::to_string(size) + " bytes, at most " + std::to_string(maxBytes) + " are read",
        "split or thin the file"};
  std::string bytes;
  try {
    bytes.resize(size);
  } catch (const std::bad_alloc&) {
    return Error{path, "", "its " + std::to_string(size) + " bytes do not fit into memory",
                 "split or thin the file"};
  }
  std::uint64_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::read(file.get(), bytes.data() + done, std::min<std::uint64_t>(size - done, 1u << 30));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(path, errno);
    if (count == 0)
      return Error{path, "", "became shorter while it was read", "wait until it is written completely"};
    done += static_cast<std::uint64_t>(count);
  }
  return bytes;
}

Status writeFileAtomically(const std::string& path, std::string_view bytes) {
  namespace fs = std::filesystem;
  if (path.empty() || path.find('\0') != std::string::npos)
    return Error{path, "", "no usable file name given", "name a file"};
  // A link stays a link: what it points to is replaced.
  std::error_code failed;
  fs::path target = path;
  if (fs::is_symlink(target, failed))
    if (const fs::path resolved = fs::weakly_canonical(target, failed); !failed) target = resolved;
  mode_t mode = 0;
  struct stat info {};
  if (::stat(target.c_str(), &info) == 0) {
    if (!S_ISREG(info.st_mode))
      return Error{path, "", "cannot be written: " + std::string(kindOf(info.st_mode)),
                   "name a regular file"};
    mode = info.st_mode & 07777;
  }

  std::string temporary;
  int fd = -1;
  do {  // a crashed process with our id may have left its file behind
    temporary = temporaryBeside(target);
    fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (fd < 0 && (errno == EEXIST || errno == EINTR));
  if (fd < 0) return unwritable(path, errno);
  Descriptor file(fd);
  int cause = writeAll(fd, bytes);
  if (cause == 0 && mode != 0 && ::fchmod(fd, mode) != 0) cause = errno;
  if (cause == 0 && ::fsync(fd) != 0) cause = errno;
  if (!file.close() && cause == 0) cause = errno;
  if (cause == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) cause = errno;
  if (cause != 0) {
    ::unlink(temporary.c_str());
    return unwritable(path, cause);
  }

  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // The new file is whole and in place; only an I/O error here means it may not survive a power cut.
  if (directory.get() >= 0 && ::fsync(directory.get()) != 0 &&
      (errno == EIO || errno == ENOSPC || errno == EDQUOT))
    return unwritable(path, errno);
  return success();
}

std::string sha256Hex(std::string_view bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  require(EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr) == 1,
          "sha256Hex: OpenSSL failed");
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

}  // namespace stratascope
