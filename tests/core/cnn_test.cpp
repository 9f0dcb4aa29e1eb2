// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "base/units.h"
#include "cnn/layer.h"
#include "cnn/neighbourhood.h"
#include "cnn/template_network.h"
#include "sim/counter_noise.h"
#include "support/cnn_oracle.h"

namespace stratascope {
namespace {

using test::CnnTime;
using test::oracleStep;

Grid<double> randomGrid(int rows, int cols, double scale, std::uint64_t seed) {
  const CounterNoise noise(seed);
  Grid<double> grid(rows, cols);
  for (size_t o = 0; o < grid.size(); ++o) grid[o] = scale * (2 * noise.uniform(o, 0, 0) - 1);
  return grid;
}
Grid<double> randomBinary(int rows, int cols, double share, std::uint64_t seed) {
  const CounterNoise noise(seed);
  Grid<double> grid(rows, cols);
  for (size_t o = 0; o < grid.size(); ++o) grid[o] = noise.uniform(o, 0, 0) < share ? 1 : -1;
  return grid;
}
CnnTemplate randomTemplate(int size, OutputFunction f, std::uint64_t seed) {
  return {randomGrid(size, size, 0.6, seed), randomGrid(size, size, 0.6, seed + 1),
          randomGrid(1, 1, 0.5, seed + 2)[0], f};
}

void expectNear(const Grid<double>& got, const Grid<double>& wanted) {
  ASSERT_EQ(got.rows(), wanted.rows());
  ASSERT_EQ(got.cols(), wanted.cols());
  for (size_t o = 0; o < got.size(); ++o)
    ASSERT_NEAR(got[o], wanted[o], 1e-11 * (1 + std::abs(wanted[o]))) << "neuron " << o;
}

struct NetworkCase {
  int size;
  OutputFunction output;
  CnnTime time;
};
class AgainstTheEquations : public ::testing::TestWithParam<NetworkCase> {};

TEST_P(AgainstTheEquations, RandomTemplatesStatesAndInputs) {
  const auto [size, f, time] = GetParam();
  const int shapes[][2] = {{1, 1}, {1, 9}, {7, 1}, {3, 4}, {37, 23}};
  std::uint64_t seed = 100;
  for (const auto& shape : shapes)
    for (const double boundary : {0.0, -1.0, 1.7}) {
      SCOPED_TRACE(testing::Message() << shape[0] << " x " << shape[1] << ", boundary " << boundary);
      seed += 10;
      const CnnTemplate t = randomTemplate(size, f, seed);
      Grid<double> state = randomGrid(shape[0], shape[1], 2, seed + 3);
      const Grid<double> input = randomGrid(shape[0], shape[1], 2, seed + 4);
      TemplateNetwork network(t, state, input, boundary);
      for (int step = 0; step < 6; ++step) {
        const double dt = 0.15 * (step + 1);
        if (time == CnnTime::Discrete)
          network.stepDiscrete();
        else
          network.stepContinuous(dt);
        state = oracleStep(t, state, input, boundary, time, dt);
        expectNear(network.state(), state);
        if (HasFatalFailure()) return;
        const Grid<double> output = network.output();
        for (size_t o = 0; o < output.size(); ++o)
          ASSERT_NEAR(output[o], test::oracleOutput(f, network.state()[o]),
                      1e-12 * (1 + std::abs(output[o])));
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Networks, AgainstTheEquations,
                         ::testing::Values(NetworkCase{3, OutputFunction::Saturation, CnnTime::Discrete},
                                           NetworkCase{3, OutputFunction::Saturation, CnnTime::Continuous},
                                           NetworkCase{3, OutputFunction::Sign, CnnTime::Discrete},
                                           NetworkCase{3, OutputFunction::Sign, CnnTime::Continuous},
                                           NetworkCase{3, OutputFunction::Identity, CnnTime::Discrete},
                                           NetworkCase{3, OutputFunction::Identity, CnnTime::Continuous},
                                           NetworkCase{5, OutputFunction::Saturation, CnnTime::Discrete},
                                           NetworkCase{5, OutputFunction::Saturation, CnnTime::Continuous},
                                           NetworkCase{5, OutputFunction::Sign, CnnTime::Discrete},
                                           NetworkCase{5, OutputFunction::Identity, CnnTime::Continuous}));

TEST(TemplateNetwork, OneAndTwoThreadsGiveTheSameBits) {
  const CnnTemplate t = randomTemplate(5, OutputFunction::Saturation, 7);
  const Grid<double> state = randomGrid(101, 67, 1, 8), input = randomGrid(101, 67, 1, 9);
  TemplateNetwork one(t, state, input), two(t, state, input);
  for (int step = 0; step < 5; ++step) one.stepContinuous(0.3, {1}), two.stepContinuous(0.3, {2});
  one.stepDiscrete({1}), two.stepDiscrete({2});
  EXPECT_EQ(
      std::memcmp(one.state().values().data(), two.state().values().data(), state.size() * sizeof(double)),
      0);
}

TEST(TemplateNetwork, BadCallsThrow) {
  const Grid<double> three(3, 3), five(5, 5), even(4, 4), oblong(3, 5);
  const auto make = [&](const Grid<double>& a, const Grid<double>& b) {
    return TemplateNetwork({a, b, 0, OutputFunction::Saturation}, Grid<double>(6, 6), Grid<double>(6, 6));
  };
  EXPECT_NO_THROW(make(three, three));
  EXPECT_THROW(make(three, five), std::logic_error);
  EXPECT_THROW(make(even, even), std::logic_error);
  EXPECT_THROW(make(oblong, oblong), std::logic_error);
  EXPECT_THROW(make(Grid<double>(), Grid<double>()), std::logic_error);
  EXPECT_THROW(TemplateNetwork(template_library::majority(), Grid<double>(6, 6), Grid<double>(6, 5)),
               std::logic_error);
  TemplateNetwork network(template_library::majority(), Grid<double>(6, 6), Grid<double>(6, 6));
  for (const double dt : {0.0, -0.1, 1.1, kNaN})
    EXPECT_THROW(network.stepContinuous(dt), std::logic_error) << dt;
}

TEST(TemplateNetwork, MajorityFollowsTheVotes) {
  const Grid<double> image = randomBinary(40, 50, 0.5, 11);
  TemplateNetwork network(template_library::majority(), image, Grid<double>(40, 50));
  network.stepDiscrete();
  const Grid<double> output = network.output();
  int won = 0, lost = 0, tied = 0;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 50; ++j) {
      double votes = 2 * image({i, j});
      for (const GridIndex d : {GridIndex{0, 1}, {1, 0}, {0, -1}, {-1, 0}})
        if (image.contains({i + d.row, j + d.col})) votes += image({i + d.row, j + d.col});
      const double wanted = votes > 0 ? 1 : votes < 0 ? -1 : 0;
      ASSERT_EQ(output({i, j}), wanted) << i << ", " << j;
      (votes > 0 ? won : votes < 0 ? lost : tied) += 1;
    }
  EXPECT_GT(won, 100);
  EXPECT_GT(lost, 100);
  EXPECT_GT(tied, 10);
}

TEST(TemplateNetwork, MajorityRemovesStraysAndKeepsStraightBorders) {
  Grid<double> clean(30, 30), spotted(30, 30);
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j) clean({i, j}) = spotted({i, j}) = j < 15 ? 1 : -1;
  for (const GridIndex at : {GridIndex{5, 5}, {20, 7}, {8, 22}, {24, 25}}) spotted(at) = -spotted(at);
  TemplateNetwork network(template_library::majority(), spotted, Grid<double>(30, 30));
  for (int t = 0; t < 3; ++t) network.stepDiscrete();
  EXPECT_EQ(network.output(), clean);
}

TEST(TemplateNetwork, EdgesAreTheMembersOfAShapeWithANeighbourOutside) {
  for (const double share : {0.8, 0.95}) {
    const Grid<double> image = randomBinary(25, 33, share, 12);
    TemplateNetwork network(template_library::edges(), Grid<double>(25, 33), image, -1);
    EXPECT_LT(network.settle(0.2, 1e-9, 1000), 1000);
    const Grid<double> output = network.output();
    int inside = 0;
    for (int i = 0; i < 25; ++i)
      for (int j = 0; j < 33; ++j) {
        bool edge = false;
        for (int k = i - 1; k <= i + 1; ++k)
          for (int l = j - 1; l <= j + 1; ++l) edge = edge || !image.contains({k, l}) || image({k, l}) < 0;
        inside += image({i, j}) > 0 && !edge;
        ASSERT_EQ(output({i, j}), image({i, j}) > 0 && edge ? 1 : -1) << i << ", " << j;
      }
    EXPECT_GT(inside, 0);
  }
}

TEST(TemplateNetwork, InversionIsNot) {
  const Grid<double> image = randomBinary(20, 20, 0.4, 13);
  for (const bool fromInput : {false, true}) {
    TemplateNetwork network(template_library::inversion(), fromInput ? image : Grid<double>(20, 20), image);
    network.settle(0.25, 1e-9, 1000);
    const Grid<double> output = network.output();
    for (size_t o = 0; o < image.size(); ++o) ASSERT_EQ(output[o], -image[o]);
  }
}

TEST(TemplateNetwork, SettleStopsAtAnEquilibriumAndCountsSteps) {
  // weak feedback: one equilibrium for every input
  CnnTemplate t = randomTemplate(3, OutputFunction::Saturation, 21);
  for (double& a : t.feedback.values()) a *= 0.1;
  const Grid<double> input = randomGrid(15, 18, 1, 22);
  TemplateNetwork network(t, randomGrid(15, 18, 3, 23), input, 0.5), again = network;
  const int steps = network.settle(0.5, 1e-12, 500);
  ASSERT_LT(steps, 500);
  ASSERT_GT(steps, 5);
  // dx/dt = 0 there: the discrete equation maps the state to itself
  const Grid<double> mapped = oracleStep(t, network.state(), input, 0.5, CnnTime::Discrete);
  for (size_t o = 0; o < mapped.size(); ++o) ASSERT_NEAR(mapped[o], network.state()[o], 1e-11);
  EXPECT_EQ(network.settle(0.5, 1e-11, 500), 1);

  // as many single steps bring the other network to the same bits; one fewer does not suffice
  EXPECT_EQ(again.settle(0.5, 1e-12, steps - 1), steps - 1);
  again.stepContinuous(0.5);
  TemplateNetwork fresh(t, randomGrid(15, 18, 3, 23), input, 0.5);
  fresh.settle(0.5, 1e-12, 500);
  EXPECT_EQ(again.state(), fresh.state());
}

// ---- layers of finite state machines

int lifeRule(GridIndex at, const Grid<int>& now) {
  int alive = 0;
  for (int k = at.row - 1; k <= at.row + 1; ++k)
    for (int l = at.col - 1; l <= at.col + 1; ++l)
      if (now.contains({k, l}) && !(k == at.row && l == at.col)) alive += now({k, l});
  return alive == 3 || (alive == 2 && now(at) == 1) ? 1 : 0;
}

TEST(Layer, AllNeuronsStepAtOnce) {
  Grid<int> start(40, 31);
  const CounterNoise noise(5);
  for (size_t o = 0; o < start.size(); ++o) start[o] = noise.uniform(o, 0, 0) < 0.4 ? 1 : 0;
  Layer<int> one(start), two(start);
  Grid<int> naive = start;
  for (int t = 0; t < 20; ++t) {
    Grid<int> next(40, 31);
    size_t changed = 0;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 31; ++j) {
        next({i, j}) = lifeRule({i, j}, naive);
        changed += next({i, j}) != naive({i, j});
      }
    naive = next;
    ASSERT_EQ(one.step(lifeRule, {1}), changed);
    ASSERT_EQ(two.step(lifeRule, {2}), changed);
    ASSERT_EQ(one.state(), naive);
    ASSERT_EQ(two.state(), naive);
  }
}

TEST(Layer, ABlinkerTurnsAndNeverSettles) {
  Grid<int> start(5, 5);
  start({2, 1}) = start({2, 2}) = start({2, 3}) = 1;
  Layer<int> layer(start);
  EXPECT_EQ(layer.step(lifeRule), 4u);
  EXPECT_EQ(layer.state()({1, 2}) + layer.state()({2, 2}) + layer.state()({3, 2}), 3);
  EXPECT_EQ(layer.settle(lifeRule, 7), 7);
  EXPECT_EQ(std::move(layer).release(), start);
}

TEST(Layer, SettleCountsTheStepThatChangedNothing) {
  // the largest value runs one neuron a step
  const auto spread = [](GridIndex at, const Grid<int>& now) {
    int best = now(at);
    for (const GridIndex d : {GridIndex{0, 1}, {0, -1}})
      if (now.contains({at.row, at.col + d.col})) best = std::max(best, now({at.row, at.col + d.col}));
    return best;
  };
  Grid<int> start(1, 12);
  start({0, 0}) = 9;
  Layer<int> layer(start);
  EXPECT_EQ(Layer<int>(start).settle(spread, 4), 4);
  EXPECT_EQ(layer.settle(spread, 100), 12);
  EXPECT_EQ(layer.state(), Grid<int>(1, 12, 9));
  EXPECT_EQ(layer.settle(spread, 100), 1);
}

TEST(Layer, FeedForwardCallsTheRuleForEveryNeuron) {
  for (const int threads : {1, 2}) {
    const Grid<int> made =
        feedForward<int>(50, 7, [](GridIndex at) { return 100 * at.row + at.col; }, {threads});
    ASSERT_EQ(made.rows(), 50);
    ASSERT_EQ(made.cols(), 7);
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 7; ++j) ASSERT_EQ(made({i, j}), 100 * i + j);
  }
}

// ---- neighbourhoods

TEST(RegularNeighbourhood, IsConditionOneInLatticeOrder) {
  for (const int radius : {0, 1, 2, 5})
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 4; ++j) {
        std::vector<GridIndex> wanted, got;
        for (int k = 0; k < 6; ++k)
          for (int l = 0; l < 4; ++l)
            if (std::max(std::abs(i - k), std::abs(j - l)) <= radius) wanted.push_back({k, l});
        RegularNeighbourhood{radius}.forEach({i, j}, 6, 4, [&](GridIndex at) { got.push_back(at); });
        ASSERT_EQ(got, wanted) << radius << " about " << i << ", " << j;
      }
}

TEST(ShellNeighbourhood, IsEquationSix) {
  const CounterNoise noise(31);
  const ShellNeighbourhood shell{0.5, 0.25};
  int in = 0, out = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Eigen::Vector3f p, q;
    for (std::uint64_t c = 0; c < 3; ++c) {
      p[static_cast<int>(c)] = static_cast<float>(noise.uniform(i, c, 0));
      q[static_cast<int>(c)] = p[static_cast<int>(c)] + static_cast<float>(noise.uniform(i, c, 1) - 0.5);
    }
    const double distance = (p - q).cast<double>().norm();
    ASSERT_EQ(shell.contains(p, q), distance <= 0.5 && distance >= 0.25);
    ASSERT_EQ(shell.contains(q, p), shell.contains(p, q));
    (shell.contains(p, q) ? in : out) += 1;
  }
  EXPECT_GT(in, 200);
  EXPECT_GT(out, 200);
  // both bounds belong to the shell; a missing return does not
  const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
  EXPECT_TRUE(shell.contains(zero, {0.5F, 0, 0}));
  EXPECT_TRUE(shell.contains(zero, {0, 0.25F, 0}));
  EXPECT_FALSE(shell.contains(zero, Eigen::Vector3f::Constant(kNaNf)));
}

TEST(ShellNeighbourhood, WalksToTheFirstNeighbourInTheShell) {
  const CounterNoise noise(32);
  Grid<Eigen::Vector3f> points(14, 15);
  for (int i = 0; i < 14; ++i)
    for (int j = 0; j < 15; ++j) {
      const auto a = static_cast<std::uint64_t>(i), b = static_cast<std::uint64_t>(j);
      points({i, j}) = {static_cast<float>(2 + 0.3 * noise.uniform(a, b, 0)), 0.06F * j, 0.06F * i};
      if (noise.uniform(a, b, 1) < 0.15) points({i, j}).setConstant(kNaNf);
      if (noise.uniform(a, b, 1) > 0.95) points({i, j}).x() += 3;  // something far behind
    }
  const ShellNeighbourhood shell{0.4, 0.2};
  int found = 0, none = 0;
  for (int i = 0; i < 14; ++i)
    for (int j = 0; j < 15; ++j) {
      if (!points({i, j}).allFinite()) continue;
      for (const GridIndex d : kLatticeDirections) {
        GridIndex wanted{-1, -1};
        for (GridIndex at{i + d.row, j + d.col}; points.contains(at); at = {at.row + d.row, at.col + d.col}) {
          if (!points(at).allFinite()) continue;
          if (shell.contains(points({i, j}), points(at))) wanted = at;
          if (wanted.row >= 0 || (points(at) - points({i, j})).norm() > 0.4F) break;
        }
        const GridIndex got = shell.firstAlong(points, {i, j}, d);
        ASSERT_EQ(got, wanted) << i << ", " << j << " along " << d.row << ", " << d.col;
        (got.row >= 0 ? found : none) += 1;
      }
    }
  EXPECT_GT(found, 200);
  EXPECT_GT(none, 200);
}

TEST(LatticeDirections, AreTheEightNeighboursInTurn) {
  for (size_t d = 0; d < 8; ++d) {
    const GridIndex a = kLatticeDirections[d], b = kLatticeDirections[(d + 1) % 8];
    EXPECT_EQ(std::max(std::abs(a.row), std::abs(a.col)), 1);
    EXPECT_GT(a.col * b.row - a.row * b.col, 0);  // each a turn the same way from the one before
    EXPECT_EQ(kLatticeDirections[(d + 4) % 8], (GridIndex{-a.row, -a.col}));
  }
}

}  // namespace
}  // namespace stratascope
