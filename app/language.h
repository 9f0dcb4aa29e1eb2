// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace stratascope {

/// Speaks the user's language from now on, if there is a translation: that of the locale ("pl_PL"), or of the
/// one given. False if there is none; English stays. Call before any widget is made.
bool speak(const QString& locale = {});

}  // namespace stratascope
