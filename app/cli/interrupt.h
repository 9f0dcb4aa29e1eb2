// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace stratascope::cli {

/// From now on Ctrl+C (SIGINT) and SIGTERM ask for an end instead of making one; a second one ends at once.
void catchInterrupts();
bool interrupted();

}  // namespace stratascope::cli
