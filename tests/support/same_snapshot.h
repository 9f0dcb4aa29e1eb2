// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/snapshot.h"

namespace stratascope::test {

/// Every product of two snapshots bit for bit: images, planes, edges, all maps. Not times and generations.
void expectSameProducts(const Snapshot& a, const Snapshot& b);

}  // namespace stratascope::test
