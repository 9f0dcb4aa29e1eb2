// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/export.h"

namespace stratascope {

const char* versionText() {
  return STRATASCOPE_VERSION;
}

}  // namespace stratascope
