// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "support/hostile_files.h"

namespace stratascope::test {

/// A format with small valid files, and files that must be refused.
struct FormatUnderAttack {
  std::string name;
  std::string extension;  ///< with the dot
  std::vector<std::string> valid;
  std::vector<HostileFile> hostile;
  bool counted = true;  ///< says how much follows, so that every prefix can be told from the whole
};

std::vector<FormatUnderAttack> formatsUnderAttack();

}  // namespace stratascope::test
