// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "base/grid.h"
#include "base/parallel_rows.h"

namespace stratascope {

/// A feed-forward layer: the state of every neuron follows from the layers before it. rule(GridIndex) →
/// State, called once a neuron, possibly from several threads; it may read any finished layer but nothing of
/// this one.
template <class State, class Rule>
Grid<State> feedForward(int lines, int beams, const Rule& rule, const Execution& execution = {}) {
  Grid<State> state = Grid<State>::unset(lines, beams);
  parallelRows(lines, execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j < beams; ++j) state({i, j}) = rule(GridIndex{i, j});
  });
  return state;
}

/// A layer with feedback: locally connected finite state machines (Chua's wider sense) that step all at once.
/// Every neuron reads the states at t and writes its state at t + 1 (two buffers), so the order of neurons
/// cannot matter.
template <class State>
class Layer {
public:
  explicit Layer(Grid<State> initial) : now_(std::move(initial)), next_(now_.rows(), now_.cols()) {}

  const Grid<State>& state() const { return now_; }

  /// rule(GridIndex, const Grid<State>& now) → State. Returns how many neurons changed (needs ==).
  template <class Rule>
  size_t step(const Rule& rule, const Execution& execution = {}) {
    Grid<int> changed(now_.rows(), now_.rows() > 0 ? 1 : 0, 0);
    parallelRows(now_.rows(), execution, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        int count = 0;
        for (int j = 0; j < now_.cols(); ++j) {
          const GridIndex index{i, j};
          next_(index) = rule(index, std::as_const(now_));
          count += next_(index) == now_(index) ? 0 : 1;
        }
        changed({i, 0}) = count;
      }
    });
    std::swap(now_, next_);
    size_t total = 0;
    for (int count : changed.values()) total += static_cast<size_t>(count);
    return total;
  }

  /// Steps until nothing changes or `most` steps are done; returns the number of steps.
  template <class Rule>
  int settle(const Rule& rule, int most, const Execution& execution = {}) {
    for (int t = 0; t < most; ++t)
      if (step(rule, execution) == 0) return t + 1;
    return most;
  }

  Grid<State> release() && { return std::move(now_); }

private:
  Grid<State> now_, next_;
};

}  // namespace stratascope
