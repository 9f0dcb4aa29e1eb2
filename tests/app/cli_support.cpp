// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli_support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/units.h"

namespace stratascope::test {
namespace {

const char* const kScene = R"({"name": "cell", "scanner": {"position": [0, 0, 1], "lines": 40, "beams": 61},
  "items": [{"shape": "room", "base": [0, 0, 0], "size": [6, 5, 3]}]})";

}  // namespace

std::string contentsOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

size_t linesIn(const std::string& text) {
  return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::set<std::string> listing(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    names.insert(fs::relative(entry.path(), directory).string());
  return names;
}

std::string roomPcd(int lines, int beams, const std::string& viewpoint) {
  std::ostringstream points;
  points.imbue(std::locale::classic());
  for (int i = 0; i < lines; ++i) {
    for (int j = 0; j < beams; ++j) {
      const double elevation = degToRad(-50 + 100.0 * i / (lines - 1));
      const double azimuth = degToRad(80 - 160.0 * j / (beams - 1));
      const double d[3] = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation)};
      const double low[3] = {-2, -3, -1}, high[3] = {2, 3, 1.5};  // seen from (0, 0, 1)
      double range = 1e9;
      for (int a = 0; a < 3; ++a)
        if (d[a] != 0) range = std::min(range, (d[a] > 0 ? high[a] : low[a]) / d[a]);
      if (i % 17 == 3 && j % 13 == 5)
        points << "nan nan nan\n";
      else
        points << range * d[0] << ' ' << range * d[1] << ' ' << 1 + range * d[2] << '\n';
    }
  }
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(beams) +
         "\nHEIGHT " + std::to_string(lines) + "\nVIEWPOINT " + viewpoint + "\nPOINTS " +
         std::to_string(lines * beams) + "\nDATA ascii\n" + points.str();
}

void Cli::SetUp() {
  std::string pattern = (fs::temp_directory_path() / "stratascope_cli_XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  work_ = pattern;
  write("room.pcd", roomPcd(60, 90));
  write("scene.json", kScene);
}

void Cli::TearDown() {
  fs::remove_all(work_);
}

void Cli::write(const std::string& name, const std::string& bytes) {
  fs::create_directories((work_ / name).parent_path());
  std::ofstream(work_ / name, std::ios::binary) << bytes;
}

Result Cli::run(const std::string& arguments) {
  const std::string out = work_.string() + ".out", err = work_.string() + ".err";
  const std::string command = "cd '" + work_.string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY '" +
                              STRATASCOPE_CLI + "' " + arguments + " >'" + out + "' 2>'" + err +
                              "' </dev/null";
  const int status = std::system(command.c_str());
  Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentsOf(out), contentsOf(err)};
  fs::remove(out);
  fs::remove(err);
  return result;
}

void Cli::expectRefused(const std::string& arguments, int status, const std::vector<std::string>& words) {
  const auto before = listing(work_);
  const Result r = run(arguments);
  EXPECT_EQ(r.status, status) << arguments << "\n" << r.err;
  EXPECT_EQ(r.out, "") << arguments;
  EXPECT_EQ(linesIn(r.err), 1u) << arguments << "\n" << r.err;
  for (const std::string& word : words)
    EXPECT_NE(r.err.find(word), std::string::npos) << arguments << "\n" << r.err;
  EXPECT_EQ(listing(work_), before) << arguments;
}

json Cli::runDocument(const std::string& directory) {
  return json::parse(contentsOf(work_ / directory / "run.json"));
}

}  // namespace stratascope::test
