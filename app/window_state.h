// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QString>
#include <array>
#include <map>
#include <optional>
#include <string>

#include "widgets/camera.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"

namespace stratascope {

inline constexpr const char* kSessionEnding = ".stratascope";  ///< of a session file's name
/// In small or capital letters.
bool isSessionName(const QString& path);

/// What a session keeps of the window: how things are looked at, nothing that is computed. What a file does
/// not say stays as it is.
struct WindowState {
  ViewOptions options;
  std::optional<std::array<CameraState, 3>> cameras;  ///< cloud, columns, boxes
  std::map<std::string, bool> marks;                  ///< checkable entries of the View menu by name
  Selected selection;
  int width = 0, height = 0;  ///< 0 = not known
  QByteArray docks;
  std::vector<QByteArray> splitters;
  int maximised = -1;  ///< which view fills the area; −1 = none
};

/// One JSON object as text, for SessionFile::window.
std::string windowJson(const WindowState& state);
/// Reads what it knows; strange values count as not given.
WindowState windowFromJson(const std::string& text);

}  // namespace stratascope
