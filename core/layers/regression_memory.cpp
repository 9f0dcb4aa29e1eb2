// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/regression_memory.h"

#include <cstring>

namespace stratascope {

bool Unchanged::canTell(const PointImage& before, const PointImage& now) {
  return before.range.cols() == now.range.cols() && before.sensor == now.sensor;
}

Unchanged::Unchanged(const PointImage& before, const PointImage& now)
    : changedStates_(now.range.rows(), [](int) { return true; }),
      changed_(now.range.rows(), now.range.cols()) {
  while (lines_ < now.range.rows() && sameLine(before, now, lines_)) ++lines_;
}

void Unchanged::update() {
  changedStates_ = ChangedLines(changed_.rows(), [&](int i) {
    const auto line = changed_.row(i);
    return line.empty() || std::memchr(line.data(), 1, line.size()) == nullptr;
  });
}

}  // namespace stratascope
