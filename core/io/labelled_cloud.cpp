// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/labelled_cloud.h"

#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"
#include "io/file_util.h"
#include "io/pcd_header.h"
#include "io/pcd_reader.h"
#include "io/text_lines.h"

namespace stratascope {
namespace {

using Columns = std::vector<std::vector<double>>;

/// Index of a field that holds one number a point.
std::optional<size_t> numberField(const PcdHeader& header, std::string_view name) {
  const auto index = header.fieldNamed(name);
  return index && header.fields[*index].count == 1 ? index : std::nullopt;
}

/// Three columns from `first` as vectors; NaN in all three where one is not finite.
std::vector<Eigen::Vector3f> vectors(const Columns& columns, size_t first) {
  std::vector<Eigen::Vector3f> result(columns[first].size());
  for (size_t i = 0; i < result.size(); ++i) {
    const Eigen::Vector3d v(columns[first][i], columns[first + 1][i], columns[first + 2][i]);
    result[i] = v.allFinite() ? Eigen::Vector3f(v.cast<float>()) : Eigen::Vector3f::Constant(kNaNf);
  }
  return result;
}

}  // namespace

Expected<LabelledCloud> readLabelledPcd(const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  const auto header = parsePcdHeader(path, *bytes);
  if (!header) return header.error();

  const char* labelName = numberField(*header, "label") ? "label" : "intensity";
  std::vector<size_t> wanted;
  for (const char* name : {labelName, "x", "y", "z"}) {
    const auto index = numberField(*header, name);
    if (!index && name == labelName)
      return Error{path, "FIELDS", "neither label nor intensity", "labels must be in one of them"};
    if (!index)
      return Error{path, std::string("field ") + name, "missing", "a labelled cloud needs x, y, z and label"};
    wanted.push_back(*index);
  }
  const size_t firstNormal = wanted.size();
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (const auto index = numberField(*header, name)) wanted.push_back(*index);
  const bool hasNormals = wanted.size() == firstNormal + 3;
  if (!hasNormals) wanted.resize(firstNormal);

  std::vector<std::string> notes;
  const auto columns = readPcdColumns(path, *bytes, *header, wanted, notes);
  if (!columns) return columns.error();

  LabelledCloud cloud;
  cloud.lines = static_cast<int>(header->height);
  cloud.beams = static_cast<int>(header->width);
  cloud.labels.resize(header->points);
  for (size_t i = 0; i < cloud.labels.size(); ++i) {
    const double label = (*columns)[0][i];
    if (!(label >= 0 && label <= std::numeric_limits<std::uint32_t>::max() && label == std::floor(label)))
      return Error{path, "point " + std::to_string(i) + ", field " + labelName,
                   shortestText(label) + " is no label", "labels are whole numbers from 0"};
    cloud.labels[i] = static_cast<std::uint32_t>(label);
  }
  cloud.points = vectors(*columns, 1);
  if (hasNormals) cloud.normals = vectors(*columns, firstNormal);
  return cloud;
}

}  // namespace stratascope
