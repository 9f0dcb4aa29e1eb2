// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/bench_goals.h"

namespace stratascope {
namespace {

constexpr double kPeakBytesPerPoint = 160, kProportional = 1.15;
constexpr double kMapsByEndPoints = 10, kMapsByRays = 250;

class Goals {
public:
  explicit Goals(const BenchResult& result) : result_(result) {}

  void atLeast(std::string key, std::string text, double value, double goal, std::string unit = "x",
               int decimals = 1) {
    list.push_back({std::move(key), std::move(text), value, goal, true, decimals, std::move(unit)});
  }
  void atMost(std::string key, std::string text, double value, double goal, std::string unit = "x",
              int decimals = 1) {
    list.push_back({std::move(key), std::move(text), value, goal, false, decimals, std::move(unit)});
  }

  void againstPcl() {
    const BenchPeer *radius = result_.peer("pcl_radius_normals"),
                    *radiusPlanes = result_.peer("pcl_radius_planes"),
                    *integral = result_.peer("pcl_integral_normals"),
                    *integralPlanes = result_.peer("pcl_integral_planes");
    if (!radius || !radiusPlanes || !integral || !integralPlanes) return;
    atLeast("pipeline_against_pcl_radius", "whole pipeline faster than PCL normals at 0.10 m + multi-plane",
            (radius->seconds + radiusPlanes->seconds) / result_.pipeline, 30);
    atLeast("normals_against_pcl_radius", "normals faster than PCL's at 0.10 m",
            radius->seconds / result_.normalSeconds(), 50);
    if (result_.normals && radius->normals) {
      atMost("normal_median", "median normal error, PCL's at 0.10 m being the goal",
             result_.normals->medianDeg, radius->normals->medianDeg, "°", 3);
      atLeast("normal_within_10", "normals within 10°, PCL's at 0.10 m being the goal",
              100 * result_.normals->within10, 100 * radius->normals->within10, "%", 2);
    }
    atMost("pipeline_against_pcl_integral",
           "whole pipeline's time by PCL's integral-image normals + multi-plane",
           result_.pipeline / (integral->seconds + integralPlanes->seconds), 1.5, "x", 2);
  }

  void againstOctomap() {
    const BenchPeer *ends = result_.peer("octomap_end_points"), *rays = result_.peer("octomap_rays");
    if (!ends || !rays) return;
    const auto mapBytes = static_cast<double>(result_.heightMapBytes + result_.intervalMapBytes);
    atLeast("maps_against_octomap_end_points", "both maps faster than OctoMap's end points",
            ends->seconds / result_.mapSeconds(), kMapsByEndPoints);
    atLeast("maps_smaller_than_octomap", "both maps smaller than OctoMap with rays",
            static_cast<double>(*rays->bytes) / mapBytes, 10);
    atLeast("maps_against_octomap_rays", "both maps faster than OctoMap with rays",
            rays->seconds / result_.mapSeconds(), kMapsByRays);
  }

  void againstSingleCallsOfOctomap() {
    const BenchPeer *ends = result_.peer("octomap_end_points_singly"),
                    *rays = result_.peer("octomap_rays_singly");
    if (!ends || !rays) return;
    atLeast("maps_against_octomap_end_points_singly",
            "both maps faster than OctoMap's end points, each by itself",
            ends->seconds / result_.mapSeconds(), kMapsByEndPoints);
    atLeast("maps_against_octomap_rays_singly", "both maps faster than OctoMap with rays, each by itself",
            rays->seconds / result_.mapSeconds(), kMapsByRays);
  }

  std::vector<BenchGoal> list;

private:
  const BenchResult& result_;
};

}  // namespace

std::vector<BenchGoal> benchGoals(const BenchResult& result, const std::vector<ProcessCost>& costs) {
  Goals goals(result);
  goals.againstPcl();
  goals.againstOctomap();
  goals.againstSingleCallsOfOctomap();
  if (result.threads > 1)
    goals.atLeast(
        "thread_efficiency",
        "gain of " + std::to_string(result.threads) + " threads by that of as many busy threads now",
        100 * (result.oneThread / result.pipeline) / result.busyGain, 85, "%", 0);
  for (const ProcessCost& cost : costs) {
    const std::string size = std::to_string(cost.lines) + " x " + std::to_string(cost.beams);
    goals.atMost(
        "peak_bytes_" + std::to_string(cost.neurons), "peak memory a neuron from file to result, " + size,
        static_cast<double>(cost.peakBytes) / static_cast<double>(cost.neurons), kPeakBytesPerPoint, " B", 0);
    if (&cost == &costs.front()) continue;
    const ProcessCost& small = costs.front();
    const double times = static_cast<double>(cost.neurons) / static_cast<double>(small.neurons);
    goals.atMost("time_growth_" + std::to_string(cost.neurons),
                 "processor time a neuron by that of the small lattice, " + size,
                 cost.processorSeconds / small.processorSeconds / times, kProportional, "x", 2);
    goals.atMost("memory_growth_" + std::to_string(cost.neurons),
                 "memory a neuron by that of the small lattice, " + size,
                 static_cast<double>(cost.peakBytes) / static_cast<double>(small.peakBytes) / times,
                 kProportional, "x", 2);
  }
  return std::move(goals.list);
}

}  // namespace stratascope
