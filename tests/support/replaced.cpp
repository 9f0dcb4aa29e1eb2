// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "support/hostile_files.h"

namespace stratascope::test {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("replaced: not there");
  return text.replace(at, from.size(), to);
}

}  // namespace stratascope::test
