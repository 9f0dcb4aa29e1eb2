// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/scan_arguments.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "io/scan_io.h"

namespace stratascope::cli {
namespace {

bool isUosScanName(std::string_view name) {
  constexpr std::string_view kPrefix = "scan", kSuffix = ".3d";
  if (name.size() <= kPrefix.size() + kSuffix.size() || !name.starts_with(kPrefix) ||
      !name.ends_with(kSuffix))
    return false;
  const auto number = name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
  return number.find_first_not_of("0123456789") == std::string_view::npos;
}

Expected<std::vector<std::string>> uosScansOf(const std::string& directory) {
  std::vector<std::string> names;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(directory, code), end; !code && entry != end;
       entry.increment(code)) {
    std::string name = entry->path().filename().string();
    if (isUosScanName(name)) names.push_back(std::move(name));
  }
  if (code) return Error{directory, "", "the directory cannot be read: " + code.message(), ""};
  if (names.empty())
    return Error{directory, "", "no UOS scans (scanNNN.3d) in this directory", "name the scan's file itself"};
  // By number: shorter names first, so that scan1000 comes after scan999.
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  for (std::string& name : names) name = (std::filesystem::path(directory) / name).string();
  return names;
}

}  // namespace

Expected<std::vector<std::string>> scanFiles(const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (const std::string& argument : arguments) {
    std::error_code code;
    if (!std::filesystem::is_directory(argument, code)) {
      files.push_back(argument);
      continue;
    }
    auto scans = uosScansOf(argument);
    if (!scans) return scans.error();
    files.insert(files.end(), scans->begin(), scans->end());
  }
  return files;
}

Expected<std::vector<ScanPtr>> readScans(const std::vector<std::string>& files,
                                         const std::vector<std::optional<Eigen::Isometry3d>>& poses,
                                         const std::vector<FileFrame>& frames,
                                         const std::vector<std::vector<int>>& hidden) {
  if (!poses.empty() && poses.size() != files.size())
    throw BadArguments("--pose: " + std::to_string(poses.size()) + " for " + std::to_string(files.size()) +
                       " scans; give it once for each scan, or not at all");
  require(frames.empty() || frames.size() == files.size(), "readScans: one frame a file, or none");
  require(hidden.empty() || hidden.size() == files.size(), "readScans: hidden scans of each file, or none");
  std::vector<ScanPtr> scans;
  std::optional<Eigen::Vector3d> origin;  // of the first file, shown or not
  for (size_t i = 0; i < files.size(); ++i) {
    showProgress("reading " + files[i]);
    ReadOptions options;
    if (!frames.empty()) options.frame = frames[i];
    if (!poses.empty()) options.pose = poses[i];
    options.localOrigin = origin;
    auto read = readAllScans(files[i], options);
    if (!read) {
      endProgress();
      return read.error();
    }
    if (!origin) origin = read->front().localOrigin;
    for (size_t k = 0; k < read->size(); ++k)
      if (hidden.empty() || !std::binary_search(hidden[i].begin(), hidden[i].end(), static_cast<int>(k)))
        scans.push_back(std::make_shared<const Scan>(std::move((*read)[k])));
  }
  endProgress();
  return scans;
}

}  // namespace stratascope::cli
