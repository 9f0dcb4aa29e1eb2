// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/file_util.h"

namespace stratascope::test {

/// A folder of its own, gone with the object.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// Writes bytes as they are; throws if that fails.
void putFile(const std::string& path, std::string_view bytes);

/// Path of a real scan: in the folder STRATASCOPE_SCANS, else in ../shared/scans beside the checkout; none if
/// not there.
std::optional<std::string> realScan(const std::string& name);

}  // namespace stratascope::test

/// Leaves the test, saying so, where the real scan is not at hand.
#define STRATASCOPE_NEED_SCAN(variable, name)                     \
  const auto variable##Found = stratascope::test::realScan(name); \
  if (!variable##Found) GTEST_SKIP() << "skipped: no real scans"; \
  const std::string variable = *variable##Found
