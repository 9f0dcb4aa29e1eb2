// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cnn/template_network.h"

namespace stratascope::test {

enum class CnnTime { Discrete, Continuous };

/// One synchronous step straight from the equations, sharing no code with core/cnn: (1) by Euler's rule with
/// step dt, or (2) (dt unused). Neurons outside the lattice have state and input `boundary`.
Grid<double> oracleStep(const CnnTemplate& t, const Grid<double>& state, const Grid<double>& input,
                        double boundary, CnnTime time, double dt = 1);

/// f of the equations.
double oracleOutput(OutputFunction function, double x);

}  // namespace stratascope::test
