// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The architecture as a test: app → widgets → core, and inside core one way only.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = STRATASCOPE_SOURCE_DIR;

/// Folders of core, each of which may include itself and those before it.
const std::vector<std::string> kCoreOrder = {"base",    "scan",     "params", "cnn",    "layers",
                                             "segment", "map",      "geo",    "io",     "sim",
                                             "interop", "pipeline", "study",  "stream", "evaluate"};

/// {folder, header}: what a folder may include although it stands further down. The snapshot is a bundle of
/// products without code of its own, and what io exports.
const std::set<std::pair<std::string, std::string>> kSharedData = {{"io", "pipeline/snapshot.h"}};

struct Include {
  std::string file;  ///< relative to the root
  std::string name;  ///< between the quotes or brackets
};

std::vector<fs::path> filesOf(const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders) {
    if (!fs::exists(kRoot / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
      if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), kRoot));
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool isCpp(const fs::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

std::vector<Include> includesIn(const std::string& folder) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  std::vector<Include> includes;
  for (const fs::path& file : filesOf({folder})) {
    if (!isCpp(file)) continue;
    std::ifstream stream(kRoot / file);
    for (std::string line; std::getline(stream, line);) {
      std::smatch match;
      if (std::regex_search(line, match, pattern)) includes.push_back({file.string(), match[1]});
    }
  }
  return includes;
}

bool isQtOrVtk(const std::string& name) {
  return std::regex_search(name, std::regex("^(Q[A-Z]|Qt[A-Z]|vtk)"));
}

std::string firstFolder(const std::string& path) {
  return path.substr(0, path.find('/'));
}

}  // namespace

TEST(IncludeRules, CoreKnowsNeitherWindowNorToolkit) {
  const auto includes = includesIn("core");
  ASSERT_GT(includes.size(), 50u);  // the walk found the sources
  for (const Include& include : includes) {
    EXPECT_FALSE(isQtOrVtk(include.name)) << include.file << " includes " << include.name;
    EXPECT_TRUE(firstFolder(include.name) != "widgets" && firstFolder(include.name) != "app")
        << include.file << " includes " << include.name;
  }
}

TEST(IncludeRules, PeersOnlyInInterop) {
  for (const Include& include : includesIn("core")) {
    if (firstFolder(include.name) == "pcl" || firstFolder(include.name) == "octomap") {
      EXPECT_TRUE(include.file.starts_with("core/interop/")) << include.file << " includes " << include.name;
    }
  }
}

TEST(IncludeRules, GdalOnlyInGeo) {
  size_t found = 0;
  for (const Include& include : includesIn("core"))
    if (include.name.starts_with("gdal") || include.name.starts_with("cpl_") ||
        include.name.starts_with("ogr")) {
      EXPECT_TRUE(include.file.starts_with("core/geo/")) << include.file << " includes " << include.name;
      ++found;
    }
  EXPECT_GT(found, 0u);
}

TEST(IncludeRules, FoldersOfCoreIncludeOneWay) {
  const auto rank = [](const std::string& folder) {
    return std::find(kCoreOrder.begin(), kCoreOrder.end(), folder) - kCoreOrder.begin();
  };
  const auto unknown = static_cast<std::ptrdiff_t>(kCoreOrder.size());
  for (const Include& include : includesIn("core")) {
    const std::string from = firstFolder(include.file.substr(5));
    const std::string to = firstFolder(include.name);
    ASSERT_NE(rank(from), unknown) << include.file << ": add its folder to the order";
    // <map> is no folder of ours, nor are the headers of libraries.
    if (include.name.find('/') == std::string::npos || rank(to) == unknown ||
        kSharedData.count({from, include.name}))
      continue;
    EXPECT_LE(rank(to), rank(from)) << include.file << " includes " << include.name;
  }
}

TEST(IncludeRules, WidgetsDoNotKnowTheApp) {
  for (const Include& include : includesIn("widgets"))
    EXPECT_NE(firstFolder(include.name), "app") << include.file << " includes " << include.name;
}

TEST(IncludeRules, TheCommandLineNeedsNoDisplay) {
  const auto includes = includesIn("app/cli");
  ASSERT_FALSE(includes.empty());
  for (const Include& include : includes) {
    EXPECT_FALSE(isQtOrVtk(include.name)) << include.file << " includes " << include.name;
    EXPECT_NE(firstFolder(include.name), "widgets") << include.file << " includes " << include.name;
  }
}

TEST(SourceRules, EveryFileSaysWhoseItIs) {
  const std::set<std::string> scripts = {"app/run", "tests/run", ".ci/run"};
  size_t checked = 0;
  for (const fs::path& file : filesOf({"core", "widgets", "app", "tests", ".ci"})) {
    if (!isCpp(file) && file.extension() != ".sh" && file.filename() != "CMakeLists.txt" &&
        !scripts.count(file.string()))
      continue;
    std::ifstream stream(kRoot / file);
    std::string head;
    std::string line;
    for (int i = 0; i < 3 && std::getline(stream, line); ++i) head += line + '\n';
    EXPECT_NE(head.find("SPDX-FileCopyrightText: 2026 the Stratascope authors\n"), std::string::npos) << file;
    EXPECT_NE(head.find("SPDX-License-Identifier: BSD-3-Clause\n"), std::string::npos) << file;
    if (file.extension() == ".h") {
      EXPECT_NE(head.find("#pragma once"), std::string::npos) << file;
    }
    ++checked;
  }
  EXPECT_GT(checked, 50u);
}
