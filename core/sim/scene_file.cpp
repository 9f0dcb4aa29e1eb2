// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_util.h"
#include "sim/scene.h"

namespace stratascope {

Expected<Scene> loadScene(const std::string& path) {
  const Expected<std::string> bytes = readFile(path, (std::uint64_t{4} << 20) + 1);
  if (!bytes) return bytes.error();
  return sceneFromJson(*bytes, path);
}

}  // namespace stratascope
