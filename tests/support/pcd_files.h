// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstring>
#include <string>
#include <vector>

#include "support/hostile_files.h"

namespace stratascope::test {

/// The bytes of a value, as they lie in memory.
std::string bytesOf(const auto& value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// A PCD header of three floats x y z, up to and with the DATA line.
std::string header(int width, int height, const std::string& data);
/// LZF that stores everything as literal runs.
std::string packLiterally(const std::string& bytes);
std::string compressedBody(const std::string& packed, size_t size);

/// Two lines of three beams…
extern const std::vector<Eigen::Vector3f> kPoints;
/// …as a PCD file in each encoding.
std::string asciiFile();
std::string binaryFile();
std::string compressedFile();

/// PCD files that must be refused.
std::vector<HostileFile> hostilePcds();

}  // namespace stratascope::test
