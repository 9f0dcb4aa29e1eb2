// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/units.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

using Labels = std::vector<std::uint32_t>;

// Label images as runs: {{label, pixels}, …}
Labels runs(std::initializer_list<std::pair<std::uint32_t, size_t>> list) {
  Labels labels;
  for (const auto& [label, count] : list) labels.insert(labels.end(), count, label);
  return labels;
}

SegmentationScore score(const Labels& truth, const Labels& found, ScoreOptions options = {}) {
  ScoreInput input;
  input.truthLabels = truth;
  input.foundLabels = found;
  return scoreSegmentation(input, options);
}

void expectCounts(const SegmentationScore& s, size_t correct, size_t over, size_t under, size_t missed,
                  size_t noise) {
  EXPECT_EQ(s.correct, correct) << "correct";
  EXPECT_EQ(s.over, over) << "over";
  EXPECT_EQ(s.under, under) << "under";
  EXPECT_EQ(s.missed, missed) << "missed";
  EXPECT_EQ(s.noise, noise) << "noise";
}

TEST(Score, SameRegionsUnderOtherNamesAreAllCorrect) {
  const auto s =
      score(runs({{10, 200}, {0, 50}, {11, 300}, {12, 100}}), runs({{7, 200}, {0, 50}, {1, 300}, {99, 100}}));
  expectCounts(s, 3, 0, 0, 0, 0);
  EXPECT_DOUBLE_EQ(s.share, 1);
  ASSERT_EQ(s.pairs.size(), 3u);
  EXPECT_EQ(s.pairs[0].truth, 10u);
  EXPECT_EQ(s.pairs[0].found, 7u);
  EXPECT_EQ(s.pairs[0].overlap, 200u);
}

TEST(Score, CorrectNeedsTheToleranceOnBothSidesAndReachingItExactlyIsEnough) {
  // 80 of 100 true pixels, all of the found region
  expectCounts(score(runs({{10, 100}, {0, 100}}), runs({{1, 80}, {0, 120}})), 1, 0, 0, 0, 0);
  expectCounts(score(runs({{10, 100}, {0, 100}}), runs({{1, 79}, {0, 121}})), 0, 0, 0, 1, 1);
  // all true pixels, 100 of 125 and of 126 found ones: pixels outside any true region count in |M|
  expectCounts(score(runs({{10, 100}, {0, 100}}), runs({{1, 125}, {0, 75}})), 1, 0, 0, 0, 0);
  expectCounts(score(runs({{10, 100}, {0, 100}}), runs({{1, 126}, {0, 74}})), 0, 0, 0, 1, 1);
  expectCounts(score(runs({{10, 100}, {0, 100}}), runs({{1, 60}, {0, 140}}), {.overlap = 0.6}), 1, 0, 0, 0,
               0);
}

TEST(Score, OneTrueRegionInPiecesIsOverSegmented) {
  const auto s = score(runs({{10, 300}}), runs({{1, 100}, {2, 100}, {3, 60}, {0, 40}}));
  expectCounts(s, 0, 1, 0, 0, 0);
  EXPECT_DOUBLE_EQ(s.share, 0);
  EXPECT_EQ(s.ofFound.at(3), RegionVerdict::Over);
  // one piece only, or pieces that cover too little: missed and noise
  expectCounts(score(runs({{10, 300}}), runs({{1, 200}, {0, 100}})), 0, 0, 0, 1, 1);
  expectCounts(score(runs({{10, 300}}), runs({{1, 119}, {2, 120}, {0, 61}})), 0, 0, 0, 1, 2);
  expectCounts(score(runs({{10, 300}}), runs({{1, 120}, {2, 120}, {0, 60}})), 0, 1, 0, 0, 0);
}

TEST(Score, APieceThatLeansOutOfTheRegionIsNoPiece) {
  // region 3 has 50 of its 100 pixels outside
  const auto s = score(runs({{10, 300}, {0, 100}}), runs({{1, 130}, {2, 120}, {3, 100}, {0, 50}}));
  expectCounts(s, 0, 1, 0, 0, 1);
  EXPECT_EQ(s.ofFound.at(3), RegionVerdict::Noise);
}

TEST(Score, OneFoundRegionOverSeveralTrueOnesIsUnderSegmented) {
  const auto s = score(runs({{10, 150}, {11, 150}, {12, 200}}), runs({{1, 300}, {2, 200}}));
  expectCounts(s, 1, 0, 1, 0, 0);
  EXPECT_EQ(s.ofTruth.at(10), RegionVerdict::Under);
  EXPECT_EQ(s.ofTruth.at(11), RegionVerdict::Under);
  EXPECT_DOUBLE_EQ(s.share, 200.0 / 500.0);
  // the sum must fill the found region
  expectCounts(score(runs({{10, 150}, {11, 150}, {0, 80}}), runs({{1, 380}})), 0, 0, 0, 2, 1);
}

TEST(Score, MissedAndNoise) {
  expectCounts(score(runs({{10, 200}, {0, 200}}), runs({{0, 200}, {5, 200}})), 0, 0, 0, 1, 1);
  expectCounts(score(runs({{10, 200}}), runs({{0, 200}})), 0, 0, 0, 1, 0);
  expectCounts(score(runs({{0, 200}}), runs({{4, 200}})), 0, 0, 0, 0, 1);
}

TEST(Score, DoubleClassificationGoesToTheHigherScore) {
  // Correct with piece 1 (0.8 and 1: mean 0.90) or over-segmented in 1 and 2 (pieces 1, cover 1: mean 1.00).
  const auto over = score(runs({{10, 100}}), runs({{1, 80}, {2, 20}}));
  expectCounts(over, 0, 1, 0, 0, 0);
  // Piece 2 leans out: pieces 1 and 0.8 (mean 0.9), cover 0.96 → 0.93; correct 0.8 and 1 → 0.90.
  expectCounts(score(runs({{10, 100}, {0, 50}}), runs({{1, 80}, {2, 20}, {0, 50}})), 0, 1, 0, 0, 0);
  // Correct 0.96 and 1 → 0.98; pieces 1 and 0.8 → 0.9, cover 1 → 0.95.
  const auto correct = score(runs({{10, 100}, {0, 50}}), runs({{1, 96}, {2, 5}, {0, 49}}));
  expectCounts(correct, 1, 0, 0, 0, 1);
  EXPECT_EQ(correct.ofFound.at(2), RegionVerdict::Noise);
  EXPECT_EQ(correct.noiseOutside, 0u);
}

TEST(Score, EqualScoresPreferCorrect) {
  // Correct with 1: 144/192 and 1 → 0.875. In two: pieces 1 and 24/32 → 0.875, cover 168/192 = 0.875.
  const auto s =
      score(runs({{10, 192}, {0, 50}}), runs({{1, 144}, {0, 24}, {2, 32}, {0, 42}}), {.overlap = 0.75});
  expectCounts(s, 1, 0, 0, 0, 1);
  // one pixel more inside makes the pieces better
  const auto over =
      score(runs({{10, 192}, {0, 50}}), runs({{1, 144}, {0, 23}, {2, 32}, {0, 43}}), {.overlap = 0.75});
  expectCounts(over, 0, 1, 0, 0, 0);
}

TEST(Score, UnderAgainstCorrect) {
  // 1 covers all of 10 (90) and all of 11 (10): under 1.00 beats correct 0.95 — both truths stand in it
  const auto s = score(runs({{10, 90}, {11, 10}}), runs({{1, 100}}), {.minTruthPixels = 1});
  expectCounts(s, 0, 0, 1, 0, 0);
  // with the default minimum, 11 and 10 are not counted at all
  const auto none = score(runs({{10, 90}, {11, 10}}), runs({{1, 100}}));
  EXPECT_EQ(none.truthRegions, 0u);
  expectCounts(none, 0, 0, 0, 0, 1);
  EXPECT_EQ(none.noiseOutside, 1u);
}

TEST(Score, SmallAndCurvedTruthIsNotCounted) {
  const auto s =
      score(runs({{10, 99}, {11, 100}, {3, 500}, {9, 500}}), runs({{0, 99}, {2, 100}, {5, 500}, {0, 500}}));
  EXPECT_EQ(s.truthRegions, 1u);
  expectCounts(s, 1, 0, 0, 0, 1);
  EXPECT_EQ(s.noiseOutside, 1u);  // the region on the curved surface
  EXPECT_FALSE(s.ofTruth.contains(10));
}

TEST(Score, EveryRegionIsClassifiedOnceWhateverTheLabels) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    Labels truth, found;
    while (truth.size() < 2000) truth.insert(truth.end(), 1 + random() % 150, 8 + random() % 12);
    while (found.size() < truth.size()) found.insert(found.end(), 1 + random() % 150, random() % 12);
    found.resize(truth.size());
    if (trial % 2 == 0)  // mostly right, so that all verdicts occur
      for (size_t i = 0; i < truth.size(); ++i)
        if (random() % 10 != 0)
          found[i] = truth[i] / (trial % 4 == 0 ? 2 : 1) * 3 + (trial % 3 == 0 ? i % 2 : 0);
    const auto s = score(truth, found, {.overlap = 0.51 + 0.1 * (trial % 5), .minTruthPixels = 20});
    std::map<RegionVerdict, size_t> truths, founds;
    for (const auto& [label, verdict] : s.ofTruth) ++truths[verdict];
    for (const auto& [label, verdict] : s.ofFound) ++founds[verdict];
    ASSERT_EQ(s.ofTruth.size(), s.truthRegions);
    ASSERT_EQ(s.ofFound.size(), s.foundRegions);
    ASSERT_EQ(truths[RegionVerdict::Correct], s.correct);
    ASSERT_EQ(founds[RegionVerdict::Correct], s.correct);
    ASSERT_EQ(truths[RegionVerdict::Over], s.over);
    ASSERT_GE(founds[RegionVerdict::Over], 2 * s.over);
    ASSERT_EQ(founds[RegionVerdict::Under], s.under);
    ASSERT_GE(truths[RegionVerdict::Under], 2 * s.under);
    ASSERT_EQ(truths[RegionVerdict::Missed], s.missed);
    ASSERT_EQ(founds[RegionVerdict::Noise], s.noise);
    ASSERT_EQ(truths[RegionVerdict::Noise] + founds[RegionVerdict::Missed], 0u);
  }
}

class ScoreAngles : public ::testing::Test {
protected:
  // A 20 × 20 patch at z = 0, label 10, found as 1, with normals tilted by `tilt` degrees about y.
  void fill(double tilt) {
    const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
    const Eigen::Vector3f tilted(static_cast<float>(std::sin(degToRad(tilt))), 0,
                                 static_cast<float>(std::cos(degToRad(tilt))));
    for (int i = 0; i < 400; ++i) {
      const float x = static_cast<float>(i % 20), y = static_cast<float>(i / 20);
      truthPoints.emplace_back(x, y, 0.f);
      foundPoints.emplace_back(x, y, -x * static_cast<float>(std::tan(degToRad(tilt))));
      truthNormals.push_back(up);
      foundNormals.push_back(tilted);
    }
    input.truthLabels = truth;
    input.foundLabels = found;
  }
  Labels truth = Labels(400, 10), found = Labels(400, 1);
  std::vector<Eigen::Vector3f> truthPoints, foundPoints, truthNormals, foundNormals;
  ScoreInput input;
};

TEST_F(ScoreAngles, PlaneAngleFromEachSource) {
  fill(3);
  EXPECT_FALSE(scoreSegmentation(input).planeAngleMeanDeg.has_value());
  input.truthNormals = truthNormals;
  input.foundNormals = foundNormals;
  EXPECT_NEAR(*scoreSegmentation(input).planeAngleMeanDeg, 3, 1e-4);
  input.foundNormals = {};
  input.foundPoints = foundPoints;
  EXPECT_NEAR(*scoreSegmentation(input).planeAngleMeanDeg, 3, 1e-4);
  input.truthNormals = {};
  input.truthPoints = truthPoints;
  EXPECT_NEAR(*scoreSegmentation(input).planeAngleMaxDeg, 3, 1e-4);
  input.foundPlaneNormals[1] = {0, std::sin(degToRad(7)),
                                -std::cos(degToRad(7))};  // signs do not matter for planes
  EXPECT_NEAR(*scoreSegmentation(input).pairs.at(0).angleErrorDeg, 7, 1e-4);
}

TEST_F(ScoreAngles, NormalStatisticsCountWhatWasNotFound) {
  fill(5);
  for (size_t i = 0; i < 40; ++i) foundNormals[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  for (size_t i = 40; i < 100; ++i) foundNormals[i] = -truthNormals[i];  // turned the wrong way: 180°
  for (size_t i = 360; i < 400; ++i) truthNormals[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  for (size_t i = 350; i < 360; ++i) truth[i] = 3;
  input.truthNormals = truthNormals;
  input.foundNormals = foundNormals;
  const auto s = scoreSegmentation(input);
  EXPECT_EQ(s.normalPixels, 350u);
  EXPECT_EQ(s.normalPixelsFound, 310u);
  EXPECT_NEAR(*s.normalMedianDeg, 5, 1e-4);
  EXPECT_NEAR(*s.normal90Deg, 180, 1e-4);  // 60 of 310
  EXPECT_DOUBLE_EQ(*s.normalWithin10, 250.0 / 350.0);
}

TEST_F(ScoreAngles, WithoutAnyNormalOrRegionNothingIsMadeUp) {
  fill(1);
  std::vector<Eigen::Vector3f> none(400, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  input.truthNormals = truthNormals;
  input.foundNormals = none;
  const auto s = scoreSegmentation(input);
  EXPECT_DOUBLE_EQ(*s.normalWithin10, 0);
  EXPECT_FALSE(s.normalMedianDeg.has_value());
  EXPECT_FALSE(s.planeAngleMeanDeg.has_value());
  EXPECT_FALSE(scoreSegmentation({}).normalWithin10.has_value());
}

// The truth of a room scores as perfect, and planes fitted to its noisy points come close to the true ones.
TEST(Score, TruthOfASimulatedRoomIsPerfect) {
  Scene scene = randomRoom(3);
  scene.scanner.lines = 172;
  scene.scanner.beams = 181;
  const SimulatedScan simulated = simulateScan(scene, {.seed = 3});
  Labels found(simulated.truthLabels.values().begin(), simulated.truthLabels.values().end());
  for (std::uint32_t& label : found) label = label >= kTruthFirstPlane ? label + 1000 : 0;
  ScoreInput input;
  input.truthLabels = simulated.truthLabels.values();
  input.truthNormals = simulated.truthNormals.values();
  input.foundLabels = found;
  input.foundNormals = simulated.truthNormals.values();
  const auto perfect = scoreSegmentation(input);
  EXPECT_GE(perfect.truthRegions, 10u);
  EXPECT_EQ(perfect.correct, perfect.truthRegions);
  EXPECT_EQ(perfect.noise, perfect.foundRegions - perfect.truthRegions);  // regions below 100 pixels
  EXPECT_DOUBLE_EQ(perfect.share, 1);
  EXPECT_DOUBLE_EQ(*perfect.normalWithin10, 1);
  EXPECT_LT(*perfect.planeAngleMaxDeg, 1e-3);

  input.foundPoints = simulated.scan.lattice->points().values();
  const auto fitted = scoreSegmentation(input);
  EXPECT_EQ(fitted.correct, fitted.truthRegions);
  EXPECT_GT(*fitted.planeAngleMedianDeg, 1e-3);
  EXPECT_LT(*fitted.planeAngleMedianDeg, 1.5);
}

TEST(Score, BadCallsThrow) {
  EXPECT_THROW(score(Labels(3, 10), Labels(4, 1)), std::logic_error);
  EXPECT_THROW(score(Labels(3, 10), Labels(3, 1), {.overlap = 0.5}), std::logic_error);
  EXPECT_THROW(score(Labels(3, 10), Labels(3, 1), {.overlap = 1.01}), std::logic_error);
  EXPECT_THROW(score(Labels(3, 10), Labels(3, 1), {.overlap = kNaN}), std::logic_error);
}

}  // namespace
}  // namespace stratascope
