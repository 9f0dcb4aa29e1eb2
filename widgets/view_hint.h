// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

namespace stratascope {

class VtkView;

/// One line over a view that says what to do with it; goes when something is done with it.
class ViewHint : public QLabel {
  Q_OBJECT
public:
  /// Belongs to the view's picture.
  ViewHint(VtkView& view, const QString& text);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void place();
};

}  // namespace stratascope
