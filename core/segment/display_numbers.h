// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/ids.h"

namespace stratascope {

/// The numbers people see for planes: 1, 2, 3 … A label says which neuron is a plane's first and so changes
/// whenever a plane gains or loses a corner; a number stays with its plane from result to result.
struct DisplayNumbers {
  std::vector<std::pair<PlaneLabel, std::uint32_t>> numbers;  ///< ascending label; each number once

  /// 0 for kNoPlane and for labels without a number.
  std::uint32_t of(PlaneLabel label) const;
  /// kNoPlane if no plane has that number.
  PlaneLabel labelOf(std::uint32_t number) const;
  bool operator==(const DisplayNumbers&) const = default;
};

/// 1, 2, 3 … in the order of `labels`, which are distinct and not kNoPlane.
DisplayNumbers firstNumbers(std::span<const PlaneLabel> labels);

/// Numbers of the planes of a new result, after an older one of the same points: `before` and `now` hold the
/// label of each point, one span a scan, equally long. A number goes to the new plane that shares most points
/// with its old one; pairs with the larger overlap choose first (then the smaller number, then the smaller
/// label). A new plane nobody claims takes the smallest number that neither an old nor a new plane has, in
/// the order of `labels`, the new result's planes. Deterministic; linear in points but for the sorting of
/// pairs.
DisplayNumbers followNumbers(std::span<const std::span<const PlaneLabel>> before, const DisplayNumbers& old,
                             std::span<const std::span<const PlaneLabel>> now,
                             std::span<const PlaneLabel> labels);

}  // namespace stratascope
