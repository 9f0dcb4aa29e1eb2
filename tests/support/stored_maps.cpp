// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/stored_maps.h"

#include <random>
#include <stdexcept>

#include "io/file_util.h"

namespace stratascope::test {

StoredMap randomStoredMap(const std::string& scanName, std::uint32_t seed, size_t points, double cell,
                          double epsilon) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  std::vector<Eigen::Vector3f> xyz;
  std::vector<PlaneLabel> labels;
  for (size_t i = 0; i < points; ++i) {
    xyz.emplace_back(static_cast<float>(below(400) - 200) * 0.011f,
                     static_cast<float>(below(300) - 150) * 0.013f, static_cast<float>(below(300)) * 0.01f);
    labels.push_back(below(3) == 0 ? kNoPlane : static_cast<PlaneLabel>(1 + below(9)));
  }
  const MapInput in{xyz, labels};
  const CellAssignment cells = *assignCells({&in, 1}, {cell});
  const IntervalMap intervals = buildIntervalMap(cells, {epsilon});
  const ObjectMap objects = buildObjectMap(cells, intervals, {&in, 1});
  StoredMap stored;
  stored.map = recordMapOf(intervals, &objects, {epsilon});
  MapSource source;
  source.name = scanName;
  source.points = points;
  source.labelCount = static_cast<PlaneLabel>(points);
  source.json = R"({"name":")" + scanName + R"(","sha256":")" + std::to_string(seed) +
                R"(","lines":1,"beams":)" + std::to_string(points) + R"(,"points":)" +
                std::to_string(points) + R"(,"version":"1","parameters":{}})";
  stored.sources.push_back(source);
  return stored;
}

std::string sealed(const std::string& bytes) {
  const std::string content = bytes.substr(0, bytes.size() - 32);
  const std::string hex = sha256Hex(content);
  std::string raw;
  for (size_t i = 0; i < hex.size(); i += 2)
    raw += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return content + raw;
}

}  // namespace stratascope::test
