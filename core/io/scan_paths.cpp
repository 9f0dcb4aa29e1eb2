// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan_paths.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace stratascope {
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

Expected<std::vector<std::string>> scanFiles(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code code;
    if (!std::filesystem::is_directory(path, code)) {
      files.push_back(path);
      continue;
    }
    auto scans = uosScansOf(path);
    if (!scans) return scans.error();
    files.insert(files.end(), scans->begin(), scans->end());
  }
  return files;
}

}  // namespace stratascope
