// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "base/grid.h"

namespace stratascope {

/// True planes cut into the pieces a scanner sees: a wall that stands on both sides of a pillar is two. Two
/// neurons of one label belong to one piece if a chain of its neurons joins them whose steps are at most
/// gap + 1 lines and at most gap + 1 beams, so that what hides up to `gap` neurons in a row parts nothing.
/// Pieces are numbered from 10 by their first neuron in lattice order; labels below 10, no planes, are kept.
/// gap >= 0, else std::logic_error.
Grid<std::uint32_t> splitIntoVisiblePieces(const Grid<std::uint32_t>& truthLabels, int gap = 2);

/// The same pieces as a truth to score `found` labels (0 = none; lattice order) against. Whether the pieces
/// of one plane, seen apart, should be found apart or as one has no right answer (a wall between two shelf
/// boards), so both count: pieces of one true plane of which one found region holds at least `overlap` each
/// are one.
Grid<std::uint32_t> piecesAsFound(const Grid<std::uint32_t>& truthLabels,
                                  std::span<const std::uint32_t> found, double overlap);

}  // namespace stratascope
