// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/visible_pieces.h"

#include <algorithm>
#include <map>
#include <vector>

#include "segment/score.h"

namespace stratascope {

Grid<std::uint32_t> splitIntoVisiblePieces(const Grid<std::uint32_t>& truthLabels, int gap) {
  require(gap >= 0, "splitIntoVisiblePieces: a negative gap");
  const int reach = gap + 1;
  Grid<std::uint32_t> pieces = truthLabels;
  Grid<std::uint8_t> seen(truthLabels.rows(), truthLabels.cols());
  std::uint32_t next = kFirstTruthPlane;
  std::vector<GridIndex> open;
  for (size_t first = 0; first < truthLabels.size(); ++first) {
    const std::uint32_t label = truthLabels[first];
    if (label < kFirstTruthPlane || seen[first]) continue;
    const std::uint32_t piece = next++;
    seen[first] = 1;
    open.push_back(truthLabels.index(first));
    while (!open.empty()) {
      const GridIndex at = open.back();
      open.pop_back();
      pieces(at) = piece;
      GridIndex near;
      const int lastRow = std::min(at.row + reach, truthLabels.rows() - 1);
      const int lastCol = std::min(at.col + reach, truthLabels.cols() - 1);
      for (near.row = std::max(at.row - reach, 0); near.row <= lastRow; ++near.row)
        for (near.col = std::max(at.col - reach, 0); near.col <= lastCol; ++near.col) {
          if (seen(near) || truthLabels(near) != label) continue;
          seen(near) = 1;
          open.push_back(near);
        }
    }
  }
  return pieces;
}

Grid<std::uint32_t> piecesAsFound(const Grid<std::uint32_t>& truthLabels,
                                  std::span<const std::uint32_t> found, double overlap) {
  require(found.size() == truthLabels.size(), "piecesAsFound: different numbers of pixels");
  Grid<std::uint32_t> pieces = splitIntoVisiblePieces(truthLabels);
  std::map<std::uint32_t, std::uint32_t> planeOf, standsFor;
  std::map<std::uint32_t, std::size_t> size;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;  // found region, piece
  for (size_t o = 0; o < pieces.size(); ++o) {
    if (truthLabels[o] < kFirstTruthPlane) continue;
    planeOf[pieces[o]] = truthLabels[o];
    standsFor[pieces[o]] = pieces[o];
    ++size[pieces[o]];
    if (found[o] != 0) ++shared[{found[o], pieces[o]}];
  }
  const auto rootOf = [&](std::uint32_t piece) {
    while (standsFor.at(piece) != piece) piece = standsFor.at(piece);
    return piece;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> firstOf;  // found region, true plane
  for (const auto& [pair, pixels] : shared) {
    const auto [region, piece] = pair;
    if (static_cast<double>(pixels) < overlap * static_cast<double>(size.at(piece))) continue;
    const auto [first, isFirst] = firstOf.try_emplace({region, planeOf.at(piece)}, piece);
    if (isFirst) continue;
    const std::uint32_t a = rootOf(first->second), b = rootOf(piece);
    standsFor[std::max(a, b)] = std::min(a, b);
  }
  for (std::uint32_t& piece : pieces.values())
    if (piece >= kFirstTruthPlane) piece = rootOf(piece);
  return pieces;
}

}  // namespace stratascope
