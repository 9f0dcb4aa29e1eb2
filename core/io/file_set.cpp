// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_set.h"

#include <unistd.h>

#include "io/file_util.h"

namespace stratascope {

namespace fs = std::filesystem;

FileSet::~FileSet() {
  if (!committed_) undo();
}

Status FileSet::makeDirectory() {
  std::error_code error;
  for (fs::path p = fs::path(directory_) / ""; p.has_relative_path() && !fs::exists(p, error);
       p = p.parent_path())
    if (p.has_filename()) made_.push_back(p);
  fs::create_directories(directory_, error);
  if (std::error_code ignored; error || !fs::is_directory(directory_, ignored))
    return Error{directory_, "",
                 "cannot be made a directory: " + (error ? error.message() : "a file has this name"),
                 "give another output directory"};
  return success();
}

Status FileSet::stage(const std::string& name, std::string_view bytes) {
  const fs::path target = fs::path(directory_) / name;
  const std::string hidden = "." + name + "." + std::to_string(::getpid());
  const Entry& entry = entries_.emplace_back(
      Entry{target, fs::path(directory_) / (hidden + ".new"), fs::path(directory_) / (hidden + ".old")});
  Status written = writeFileAtomically(entry.fresh.string(), bytes);
  if (written) return written;
  Error error = written.error();
  error.file = target.string();
  return error;
}

Expected<std::vector<std::string>> FileSet::commit() {
  std::vector<std::string> paths;
  for (Entry& entry : entries_) {
    std::error_code error;
    // a second name for the old file, so that it can come back and is never absent meanwhile
    fs::create_hard_link(entry.target, entry.old, error);
    entry.hasOld = !error;
    const bool existed = entry.hasOld || fs::exists(fs::symlink_status(entry.target, error));
    fs::rename(entry.fresh, entry.target, error);
    if (error)
      return Error{entry.target.string(), "", "cannot be replaced: " + error.message(),
                   "remove what has this name or give another output directory"};
    entry.placed =
        !existed || entry.hasOld;  // without a second name (some file systems) there is no way back
    paths.push_back(entry.target.string());
  }
  committed_ = true;
  std::error_code ignored;
  for (const Entry& entry : entries_)
    if (entry.hasOld) fs::remove(entry.old, ignored);
  return paths;
}

void FileSet::undo() {
  std::error_code ignored;
  for (const Entry& entry : entries_) {
    if (entry.placed && entry.hasOld)
      fs::rename(entry.old, entry.target, ignored);
    else if (entry.placed)
      fs::remove(entry.target, ignored);
    else if (entry.hasOld)
      fs::remove(entry.old, ignored);
    fs::remove(entry.fresh, ignored);
  }
  for (const fs::path& p : made_)
    fs::remove(p, ignored);  // deepest first; stays if others have put something in
}

Expected<std::vector<std::string>> writeFileSet(const std::string& directory,
                                                const std::vector<OutputFile>& files) {
  FileSet set(directory);
  if (Status made = set.makeDirectory(); !made) return made.error();
  for (const OutputFile& file : files)
    if (Status staged = set.stage(file.name, file.bytes); !staged) return staged.error();
  return set.commit();
}

}  // namespace stratascope
