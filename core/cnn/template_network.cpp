// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cnn/template_network.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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
  Weights(const Grid<double>& weights, int cols) : radius_(weights.rows() / 2) {
    for (int di = -radius_; di <= radius_; ++di)
      for (int dj = -radius_; dj <= radius_; ++dj)
        if (const double w = weights({di + radius_, dj + radius_}); w != 0)
          taps_.push_back({di, dj, static_cast<std::ptrdiff_t>(di) * cols + dj, w});
  }

  /// Σ over the neighbourhood of weight·value; neurons outside the lattice stand at `boundary`.
  double sum(const Grid<double>& values, GridIndex at, double boundary) const {
    double total = 0;
    const bool inside = at.row >= radius_ && at.row + radius_ < values.rows() && at.col >= radius_ &&
                        at.col + radius_ < values.cols();
    if (inside) {
      const double* centre = values.values().data() + values.offset(at);
      for (const Tap& tap : taps_) total += tap.weight * centre[tap.offset];
    } else {
      for (const Tap& tap : taps_) {
        const GridIndex from{at.row + tap.line, at.col + tap.beam};
        total += tap.weight * (values.contains(from) ? values(from) : boundary);
      }
    }
    return total;
  }

private:
  struct Tap {
    int line, beam;
    std::ptrdiff_t offset;
    double weight;
  };
  int radius_;
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

void TemplateNetwork::computeDrive(const Execution& execution) {
  if (drive_.size() == state_.size()) return;
  drive_ = Grid<double>(state_.rows(), state_.cols());
  const Weights feedForward(template_.feedForward, state_.cols());
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j < state_.cols(); ++j)
        drive_({i, j}) = feedForward.sum(input_, {i, j}, boundary_) + template_.bias;
  });
}

void TemplateNetwork::step(double keep, double gain, const Execution& execution) {
  computeDrive(execution);
  const double outside = outputOf(template_.output, boundary_);
  const Weights feedback(template_.feedback, state_.cols());
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j < state_.cols(); ++j) output_({i, j}) = outputOf(template_.output, state_({i, j}));
  });
  parallelRows(state_.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j < state_.cols(); ++j)
        next_({i, j}) =
            keep * state_({i, j}) + gain * (feedback.sum(output_, {i, j}, outside) + drive_({i, j}));
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
