// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

class QAbstractButton;
class QAction;

namespace stratascope {

enum class Theme { System, Light, Dark };

/// Fusion style, our palette and style sheet for the whole program. System follows the palette the desktop
/// gave at the start.
void applyTheme(Theme theme);
bool isDark(const QPalette& palette);

/// Behind the 3D pictures.
QColor canvasColour(const QPalette& palette);
/// Text that matters less.
QColor mutedText(const QPalette& palette);
/// Hair lines between parts.
QColor lineColour(const QPalette& palette);

/// The SVG of that name from resources/icons in the palette's colour. Icons set through setThemedIcon follow
/// a change of theme.
QIcon themedIcon(const QString& name);
void setThemedIcon(QAction* action, const QString& name);
void setThemedIcon(QAbstractButton* button, const QString& name);

}  // namespace stratascope
