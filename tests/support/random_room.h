// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/random_room.h"

namespace stratascope::test {
using stratascope::randomRoom;
}  // namespace stratascope::test
