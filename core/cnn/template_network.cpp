// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cnn/template_network.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace stratascope {

double outputOf(OutputFunction function, double x) {
  switch (function) {
    case OutputFunction::Saturation:
      return 0.5 * (std::abs(x + 1) - std::abs(x - 1));
    case OutputFunction::Sign:
      return x > 0 ? 1 : x < 0 ? -1 : 0;
    case OutputFunction::Identity:
      return x;
  }
  throw std::logic_error("outputOf: unknown function");
}

namespace {
void outputOf(OutputFunction function, std::span<const double> x, std::span<double> y) {
  if (function == OutputFunction::Saturation)
    for (size_t j = 0; j < x.size(); ++j) y[j] = 0.5 * (std::abs(x[j] + 1) - std::abs(x[j] - 1));
  else
    for (size_t j = 0; j < x.size(); ++j) y[j] = outputOf(function, x[j]);
}
}  // namespace

void CnnTemplate::check() const {
  require(feedback.rows() == feedback.cols() && feedback.rows() % 2 == 1,
          "CnnTemplate: A must be square and odd");
  require(feedForward.rows() == feedback.rows() && feedForward.cols() == feedback.cols(),
          "CnnTemplate: B must be of A's size");
}

namespace {

/// The weights of a template that are not 0, in row-major order.
class Weights {
public:
  explicit Weights(const Grid<double>& weights) {
    const int radius = weights.rows() / 2;
    for (int di = -radius; di <= radius; ++di)
      for (int dj = -radius; dj <= radius; ++dj)
        if (const double w = weights({di + radius, dj + radius}); w != 0) taps_.push_back({di, dj, w});
  }

  bool empty() const { return taps_.empty(); }

  /// Σ over the neighbourhood of weight·value for every neuron of a line; neurons outside the lattice stand
  /// at `boundary`. Tap by tap along the line, so that the loop runs over memory in order.
  void sumLine(const Grid<double>& values, int line, double boundary, std::span<double> sums) const {
    if (taps_.empty()) std::fill(sums.begin(), sums.end(), 0.0);
    for (const Tap& tap : taps_) {
      if (&tap == &taps_.front() && line + tap.line >= 0 && line + tap.line < values.rows() &&
          tap.beam == 0) {
        const double* row = values.row(line + tap.line).data();  // spares a pass of zeros
        for (size_t j = 0; j < sums.size(); ++j) sums[j] = tap.weight * row[j];
        continue;
      }
      if (&tap == &taps_.front()) std::fill(sums.begin(), sums.end(), 0.0);
      const int from = line + tap.line, cols = values.cols();
      if (from < 0 || from >= values.rows()) {
        for (double& sum : sums) sum += tap.weight * boundary;
        continue;
      }
      const double* row = values.row(from).data();
      const int first = std::clamp(-tap.beam, 0, cols), end = std::clamp(cols - tap.beam, first, cols);
      for (int j = 0; j < first; ++j) sums[static_cast<size_t>(j)] += tap.weight * boundary;
      for (int j = first; j < end; ++j) sums[static_cast<size_t>(j)] += tap.weight * row[j + tap.beam];
      for (int j = end; j < cols; ++j) sums[static_cast<size_t>(j)] += tap.weight * boundary;
    }
  }

private:
  struct Tap {
    int line, beam;
    double weight;
  };
  std::vector<Tap> taps_;
};

}  // namespace

TemplateNetwork::TemplateNetwork(CnnTemplate cloningTemplate, Grid<double> state, Grid<double> input,
                                 double boundary)
    : template_(std::move(cloningTemplate)),
      state_(std::move(state)),
      input_(std::move(input)),
      boundary_(boundary) {
  template_.check();
  require(state_.rows() == input_.rows() && state_.cols() == input_.cols(),
          "TemplateNetwork: state and input differ in size");
  next_ = Grid<double>(state_.rows(), state_.cols());
  output_ = Grid<double>(state_.rows(), state_.cols());
}

void TemplateNetwork::restart(const Grid<double>& state) {
  require(state_.rows() == state.rows() && state_.cols() == state.cols(),
          "TemplateNetwork: state of another size");
  state_ = state;
}

void TemplateNetwork::computeDrive(const Execution& execution) {
  if (driveKnown_) return;
  driveKnown_ = true;
  const Weights feedForward(template_.feedForward);
  if (feedForward.empty() && template_.bias == 0) return;
  drive_ = Grid<double>(state_.rows(), state_.cols());
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      feedForward.sumLine(input_, i, boundary_, drive_.row(i));
      for (double& drive : drive_.row(i)) drive += template_.bias;
    }
  });
}

void TemplateNetwork::step(double keep, double gain, const Execution& execution) {
  computeDrive(execution);
  const double outside = outputOf(template_.output, boundary_);
  const Weights feedback(template_.feedback);
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) outputOf(template_.output, state_.row(i), output_.row(i));
  });
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const auto next = next_.row(i), state = state_.row(i);
      feedback.sumLine(output_, i, outside, next);
      if (!drive_.empty())
        for (size_t j = 0; j < next.size(); ++j) next[j] += drive_({i, static_cast<int>(j)});
      if (keep != 0 || gain != 1)
        for (size_t j = 0; j < next.size(); ++j) next[j] = keep * state[j] + gain * next[j];
    }
  });
  std::swap(state_, next_);
}

void TemplateNetwork::stepDiscrete(const Execution& execution) {
  step(0, 1, execution);
}

void TemplateNetwork::stepContinuous(double dt, const Execution& execution) {
  require(dt > 0 && dt <= 1, "TemplateNetwork: dt must lie in (0, 1]");
  step(1 - dt, dt, execution);
}

int TemplateNetwork::settle(double dt, double tolerance, int most, const Execution& execution) {
  for (int t = 0; t < most; ++t) {
    stepContinuous(dt, execution);
    double moved = 0;
    for (size_t o = 0; o < state_.size(); ++o) moved = std::max(moved, std::abs(state_[o] - next_[o]));
    if (moved <= tolerance) return t + 1;
  }
  return most;
}

Grid<double> TemplateNetwork::output() const {
  Grid<double> y(state_.rows(), state_.cols());
  for (size_t o = 0; o < y.size(); ++o) y[o] = outputOf(template_.output, state_[o]);
  return y;
}

namespace template_library {
namespace {
Grid<double> square3(std::initializer_list<double> weights) {
  Grid<double> grid(3, 3);
  std::copy(weights.begin(), weights.end(), grid.values().begin());
  return grid;
}
}  // namespace

CnnTemplate majority() {
  return {square3({0, 1, 0, 1, 2, 1, 0, 1, 0}), square3({0, 0, 0, 0, 0, 0, 0, 0, 0}), 0,
          OutputFunction::Saturation};
}
CnnTemplate edges() {
  return {square3({0, 0, 0, 0, 1, 0, 0, 0, 0}), square3({-1, -1, -1, -1, 8, -1, -1, -1, -1}), -1,
          OutputFunction::Saturation};
}
CnnTemplate inversion() {
  return {square3({0, 0, 0, 0, 1, 0, 0, 0, 0}), square3({0, 0, 0, 0, -2, 0, 0, 0, 0}), 0,
          OutputFunction::Saturation};
}
}  // namespace template_library

}  // namespace stratascope
