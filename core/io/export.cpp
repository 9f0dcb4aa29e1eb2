// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/export.h"

#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/file_util.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;

/// Files that come to stand together or not at all. What is not committed is undone by the destructor.
class FileSet {
public:
  explicit FileSet(std::string directory) : directory_(std::move(directory)) {}
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  ~FileSet() {
    if (!committed_) undo();
  }

  Status makeDirectory() {
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

  /// Writes under a name of its own beside `name`.
  Status stage(const std::string& name, std::string_view bytes) {
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

  Expected<std::vector<std::string>> commit() {
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

private:
  struct Entry {
    fs::path target, fresh, old;
    bool hasOld = false;  ///< `old` is the file that stood at `target`
    bool placed = false;  ///< `target` is ours and can be taken back
  };

  void undo() {
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

  std::string directory_;
  std::vector<fs::path> made_;
  std::vector<Entry> entries_;
  bool committed_ = false;
};

/// What a cloud file says of its origin, as comments.
std::vector<std::string> provenanceOf(const nlohmann::ordered_json& run, size_t scan) {
  const auto& input = run["inputs"][scan];
  const auto text = [](const auto& json) { return json.dump(-1, ' ', true); };
  return {"stratascope " + std::string(versionText()),
          "input " + text(input["name"]) + " sha256 " + text(input["sha256"]),
          "parameters " + text(run["parameters"])};
}

}  // namespace

Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory,
                                                 std::string_view streamCounters) {
  require(snapshot.heightMap && snapshot.intervalMap && !snapshot.scans.empty(),
          "exportResults: unfinished snapshot");
  const Expected<std::string> run = runJson(snapshot, streamCounters);
  if (!run) return run.error();
  const auto runDocument = nlohmann::ordered_json::parse(*run);

  FileSet files(directory);
  if (Status made = files.makeDirectory(); !made) return made.error();
  for (size_t i = 0; i < snapshot.scans.size(); ++i) {
    const std::string name = i == 0 ? "cloud.pcd" : "cloud_" + std::to_string(i) + ".pcd";
    if (Status s = files.stage(name, cloudPcd(snapshot.scans[i], provenanceOf(runDocument, i))); !s)
      return s.error();
  }
  if (Status s = files.stage("planes.json", planesJson(snapshot)); !s) return s.error();
  if (Status s = files.stage("edges.json", edgesJson(snapshot)); !s) return s.error();
  if (Status s = files.stage("height_map.asc", heightMapAsc(*snapshot.heightMap)); !s) return s.error();
  if (Status s = files.stage("intervals.csv", intervalsCsv(snapshot)); !s) return s.error();
  if (Status s = files.stage("run.json", *run); !s) return s.error();
  return files.commit();
}

}  // namespace stratascope
