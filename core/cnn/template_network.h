// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/grid.h"
#include "base/parallel_rows.h"

namespace stratascope {

/// Output functions f.
enum class OutputFunction : unsigned char {
  Saturation,  ///< f(x) = (|x+1| − |x−1|)/2
  Sign,        ///< −1, 0, +1
  Identity,
};
double outputOf(OutputFunction function, double x);

/// A cloning template: the same weights for every neuron. A and B are (2r+1) × (2r+1), row-major.
struct CnnTemplate {
  Grid<double> feedback;     ///< A
  Grid<double> feedForward;  ///< B; multiplies the input u itself, not f(u) (the paper's misprint)
  double bias = 0;           ///< I
  OutputFunction output = OutputFunction::Saturation;

  int radius() const { return feedback.rows() / 2; }
  /// Throws std::logic_error unless A and B are square, of the same odd size.
  void check() const;
};

/// A layer of scalar neurons under one template. Neurons outside the lattice are held at `boundary` (as state
/// and input). All neurons step synchronously; results do not depend on threads.
class TemplateNetwork {
public:
  /// state: x(0); input: u; same size.
  TemplateNetwork(CnnTemplate cloningTemplate, Grid<double> state, Grid<double> input, double boundary = 0);

  /// The same template and input from another x(0), of the same size; keeps its memory.
  void restart(const Grid<double>& state);

  /// Discrete time, Eq. (2) corrected: x(t+1) = Σ A·y(t) + Σ B·u + I, y_ij = f(x_ij).
  void stepDiscrete(const Execution& execution = {});
  /// Continuous time, Eq. (1) corrected: dx/dt = −x + Σ A·f(x) + Σ B·u + I, by one Euler step of length dt in
  /// (0, 1].
  void stepContinuous(double dt, const Execution& execution = {});
  /// Euler steps until no state moves by more than `tolerance` a step; returns the steps taken, at most
  /// `most`.
  int settle(double dt, double tolerance, int most, const Execution& execution = {});

  const Grid<double>& state() const { return state_; }
  Grid<double> output() const;

private:
  void step(double keep, double gain, const Execution& execution);
  void computeDrive(const Execution& execution);

  CnnTemplate template_;
  Grid<double> state_, next_, output_, input_,
      drive_;  // drive = Σ B·u + I, constant in time; empty where it is 0 everywhere
  double boundary_;
  bool driveKnown_ = false;
};

/// Well-known templates (3 × 3).
namespace template_library {
/// Binary smoothing: a neuron follows the majority of itself (twice) and its four neighbours; input only as
/// x(0).
CnnTemplate majority();
/// Edge extraction from a binary image (B centre 8, others −1, I = −1).
CnnTemplate edges();
/// Logical NOT.
CnnTemplate inversion();
}  // namespace template_library

}  // namespace stratascope
