// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/scan_arguments.h"

#include <algorithm>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "io/scan_io.h"

namespace stratascope::cli {

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
