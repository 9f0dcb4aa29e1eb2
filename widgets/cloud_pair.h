// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "widgets/cloud_view.h"

class QSplitter;

namespace stratascope {

/// The cloud alone, or beside it the cloud of a result that was kept, with one camera. In a wipe both make
/// one picture, left of the handle the kept result, right of it the present one.
class CloudPair : public QWidget {
  Q_OBJECT
public:
  enum class Mode { Single, SideBySide, Wipe };
  CloudPair(CloudView* view, Selection& selection, QWidget* parent = nullptr);

  /// The kept result.
  void setKept(const ViewGeometryPtr& geometry);
  void setMode(Mode mode);
  Mode mode() const { return mode_; }
  /// nullptr until both were shown once.
  CloudView* kept() const { return kept_; }
  QSplitter* splitter() const { return splitter_; }
  /// After the present view's camera, grid or marks changed.
  void sync();
  void renderNow();

signals:
  /// The camera of the kept view was moved by hand; the present view has followed.
  void cameraMoved();
  void hoverText(const QString& text);
  void maximiseToggled();

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void makeKept();
  void placeParts();
  void styleHandle();

  CloudView* view_;
  CloudView* kept_ = nullptr;
  Selection& selection_;
  QSplitter* splitter_;
  Mode mode_ = Mode::Single;
};

}  // namespace stratascope
