// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace stratascope {

/// Why no picture could be drawn here, in one line; empty if OpenGL 3.2 is there. Needs a QApplication.
QString openGlProblem();
/// Whether OpenGL runs on the processor, as without a graphics card. Needs a QApplication.
bool openGlOnProcessor();
/// Call before the QApplication is made: Qt's and VTK's surface must agree.
void prepareOpenGl();

}  // namespace stratascope
