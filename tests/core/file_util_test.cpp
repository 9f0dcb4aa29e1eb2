// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_util.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "support/scan_files.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;
using test::putFile;
using test::TemporaryFolder;

size_t filesIn(const TemporaryFolder& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

TEST(FileUtil, WritesAndReadsAnyBytes) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  for (const std::string& content : {std::string(), std::string("a\0b", 3), bytes}) {
    ASSERT_TRUE(writeFileAtomically(folder / "file", content));
    const auto read = readFile(folder / "file");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, content);
  }
  EXPECT_EQ(filesIn(folder), 1u);
}

TEST(FileUtil, ReadsOnlyRegularFiles) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  fs::create_symlink(folder / "pipe", folder / "link");
  for (const std::string& path :
       {folder / "pipe", folder / "link", folder.path().string(), std::string("/dev/null"),
        std::string("/dev/zero"), folder / "absent", std::string(), std::string("a\0b", 3)}) {
    const auto read = readFile(path);
    ASSERT_FALSE(read) << path;
    EXPECT_FALSE(read.error().what.empty());
    EXPECT_EQ(read.error().message().find('\n'), std::string::npos);
  }
}

TEST(FileUtil, RefusesWhatIsLargerThanAllowed) {
  const TemporaryFolder folder;
  putFile(folder / "file", "12345");
  EXPECT_TRUE(readFile(folder / "file", 5));
  EXPECT_FALSE(readFile(folder / "file", 4));
  ASSERT_EQ(::truncate((folder / "file").c_str(), off_t{1} << 40),
            0);  // a sparse file says it has a terabyte
  EXPECT_FALSE(readFile(folder / "file"));
}

TEST(FileUtil, FailedWriteLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  EXPECT_FALSE(writeFileAtomically(folder / "no/such/folder/file", "x"));
  EXPECT_FALSE(writeFileAtomically(folder.path().string(), "x"));
  EXPECT_FALSE(writeFileAtomically("", "x"));
  EXPECT_FALSE(writeFileAtomically("/dev/full", "x"));
  EXPECT_FALSE(writeFileAtomically(folder / std::string(300, 'n'), "x"));
  EXPECT_EQ(filesIn(folder), 0u);
}

TEST(FileUtil, ReplacesThroughALinkAndKeepsTheMode) {
  const TemporaryFolder folder;
  putFile(folder / "target", "old");
  fs::permissions(folder / "target", fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("target", folder / "link");
  ASSERT_TRUE(writeFileAtomically(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(*readFile(folder / "target"), "new");
  EXPECT_EQ(fs::status(folder / "target").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(FileUtil, ReaderSeesTheOldOrTheNewFileNeverAPart) {
  const TemporaryFolder folder;
  const std::string path = folder / "file";
  const std::string contents[] = {std::string(200000, 'a'), std::string(300000, 'b')};
  ASSERT_TRUE(writeFileAtomically(path, contents[0]));
  std::jthread writer([&](std::stop_token stop) {
    for (int i = 1; !stop.stop_requested(); ++i) EXPECT_TRUE(writeFileAtomically(path, contents[i % 2]));
  });
  for (int i = 0; i < 200; ++i) {
    const auto read = readFile(path);
    ASSERT_TRUE(read);
    EXPECT_TRUE(*read == contents[0] || *read == contents[1]);
  }
}

TEST(FileUtil, Sha256OfKnownTexts) {
  EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace stratascope
