// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stratascope {

/// A file to be written: its name in a directory, and what it holds.
struct OutputFile {
  std::string name;
  std::string bytes;
};

/// Files that come to stand together or not at all. What is not committed is undone by the destructor.
class FileSet {
public:
  explicit FileSet(std::string directory) : directory_(std::move(directory)) {}
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  ~FileSet();

  Status makeDirectory();
  /// Writes under a name of its own beside `name`. Errors as writeFileAtomically().
  Status stage(const std::string& name, std::string_view bytes);
  /// Gives the files their names; the paths in the order they were staged.
  Expected<std::vector<std::string>> commit();

private:
  struct Entry {
    std::filesystem::path target, fresh, old;
    bool hasOld = false;  ///< `old` is the file that stood at `target`
    bool placed = false;  ///< `target` is ours and can be taken back
  };
  void undo();

  std::string directory_;
  std::vector<std::filesystem::path> made_;
  std::vector<Entry> entries_;
  bool committed_ = false;
};

/// Writes all of them into `directory` (made if missing), all or nothing. Returns the paths.
Expected<std::vector<std::string>> writeFileSet(const std::string& directory,
                                                const std::vector<OutputFile>& files);

}  // namespace stratascope
