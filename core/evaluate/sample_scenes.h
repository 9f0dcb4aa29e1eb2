// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace stratascope {

/// A scene of sample_scans/scenes, built in: its name without extension, and its JSON.
struct SampleScene {
  const char* name;
  const char* json;
};

/// In the order of sample_scans/README.md: the i-th sample scan was simulated with seed i + 1.
std::span<const SampleScene> sampleScenes();

}  // namespace stratascope
