// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/scan_files.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace stratascope::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "stratascope-test-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void putFile(const std::string& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

std::optional<std::string> realScan(const std::string& name) {
  const char* given = std::getenv("STRATASCOPE_SCANS");
  const fs::path folder =
      given && *given ? fs::path(given) : fs::path(STRATASCOPE_SOURCE_DIR) / ".." / "shared" / "scans";
  std::error_code failed;
  const fs::path path = folder / name;
  if (!fs::is_regular_file(path, failed)) return std::nullopt;
  return path.string();
}

}  // namespace stratascope::test
