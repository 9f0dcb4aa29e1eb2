// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/view_hint.h"

#include <QEvent>
#include <algorithm>

#include "widgets/vtk_view.h"

namespace stratascope {

ViewHint::ViewHint(VtkView& view, const QString& text) : QLabel(text, view.canvas()) {
  setObjectName("viewHint");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  setMargin(5);
  connect(&view, &VtkView::clicked, this, &QObject::deleteLater);
  connect(&view, &VtkView::cameraMoved, this, &QObject::deleteLater);
  parent()->installEventFilter(this);
  place();
  show();
}

void ViewHint::place() {
  const int room = parentWidget()->width() - 24;
  const int wanted = fontMetrics().horizontalAdvance(text()) + 2 * margin() + 12;
  const int width = std::max(80, std::min(room, wanted));
  setGeometry((parentWidget()->width() - width) / 2, 8, width, heightForWidth(width));
}

bool ViewHint::eventFilter(QObject* object, QEvent* event) {
  if (object == parent()) {
    if (event->type() == QEvent::Resize) place();
    if (event->type() == QEvent::Wheel) deleteLater();
  }
  return QLabel::eventFilter(object, event);
}

}  // namespace stratascope
