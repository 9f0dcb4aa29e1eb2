// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "sim/scene.h"

namespace stratascope {

/// Furnished: tables on four legs and open shelves, whose narrow faces show some three neurons across. Plain:
/// cabinets and chests in their stead.
enum class RoomKind : unsigned char { Furnished, Plain };

/// A room, different for every seed and the same for equal seeds: walls turned against the robot, tables,
/// cabinets, shelves, perhaps a pillar, a beam under the ceiling, a crate, pipes. Ten to twenty or so flat
/// faces show 100 neurons or more. The scanner is at x = y = 0, 0.8 to 1.2 m above the floor z = 0; full
/// size, 515 lines of 361 beams, unless changed afterwards. Metres, map frame. Whatever segmentation is tuned
/// on some seeds can be checked on others.
Scene randomRoom(std::uint64_t seed, RoomKind kind = RoomKind::Furnished);

}  // namespace stratascope
