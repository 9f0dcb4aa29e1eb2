// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace stratascope::test {

namespace fs = std::filesystem;
using nlohmann::json;

struct Result {
  int status = -1;
  std::string out, err;
};

std::string contentsOf(const fs::path& path);
size_t linesIn(const std::string& text);
/// Every file below `directory` by relative path.
std::set<std::string> listing(const fs::path& directory);
/// A lattice scan of the inside of a box 4 × 6 × 2.5 m around (0, 0, 1.25), as an ASCII PCD; some returns are
/// missing.
std::string roomPcd(int lines, int beams, const std::string& viewpoint = "0 0 1 1 0 0 0");

/// A folder with room.pcd and scene.json, and stratascope-cli run in it.
class Cli : public testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;

  void write(const std::string& name, const std::string& bytes);
  /// Runs `stratascope-cli ARGUMENTS` in the working directory. Its outputs are kept beside, not in it.
  Result run(const std::string& arguments);
  /// Exit status `status`, nothing on stdout, one line on stderr that contains every one of `words`, no file
  /// made.
  void expectRefused(const std::string& arguments, int status, const std::vector<std::string>& words);
  json runDocument(const std::string& directory);

  fs::path work_;
};

}  // namespace stratascope::test
