// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// All maps of the pipeline: points in cells, 2.5D, extended 2.5D, raster-object.
#include "map/cell_assignment.h"
#include "map/height_map.h"
#include "map/interval_map.h"
#include "map/object_map.h"
