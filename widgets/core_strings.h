// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace stratascope {

/// Every word of core's tables that the window shows through tableText().
std::span<const char* const> coreStrings();

}  // namespace stratascope
