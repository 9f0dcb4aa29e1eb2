// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/cnn_oracle.h"

#include <cmath>
#include <cstdlib>

namespace stratascope::test {

double oracleOutput(OutputFunction function, double x) {
  if (function == OutputFunction::Identity) return x;
  if (function == OutputFunction::Sign) return x == 0 ? 0 : x / std::abs(x);
  return x > 1 ? 1 : x < -1 ? -1 : x;  // what (|x+1| − |x−1|)/2 draws
}

Grid<double> oracleStep(const CnnTemplate& t, const Grid<double>& state, const Grid<double>& input,
                        double boundary, CnnTime time, double dt) {
  const int r = (t.feedback.rows() - 1) / 2;
  Grid<double> next(state.rows(), state.cols());
  for (int i = 0; i < state.rows(); ++i)
    for (int j = 0; j < state.cols(); ++j) {
      double sum = t.bias;
      for (int k = i - r; k <= i + r; ++k)
        for (int l = j - r; l <= j + r; ++l) {
          const bool inside = k >= 0 && l >= 0 && k < state.rows() && l < state.cols();
          const double x = inside ? state({k, l}) : boundary;
          const double u = inside ? input({k, l}) : boundary;
          sum += t.feedback({k - i + r, l - j + r}) * oracleOutput(t.output, x);
          sum += t.feedForward({k - i + r, l - j + r}) * u;
        }
      const double x = state({i, j});
      next({i, j}) = time == CnnTime::Discrete ? sum : x + dt * (-x + sum);
    }
  return next;
}

}  // namespace stratascope::test
