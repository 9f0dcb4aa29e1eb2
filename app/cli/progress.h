// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stratascope::cli {

/// One line on stderr that the next call overwrites. Only on a terminal: in a script an error stays the only
/// line there.
void showProgress(const std::string& text);
/// Wipes that line.
void endProgress();

/// "note: …" on stderr, for what a user should know of a result that is good.
void note(const std::string& text);

}  // namespace stratascope::cli
