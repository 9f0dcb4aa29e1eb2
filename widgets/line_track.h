// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QSlider>

namespace stratascope {

/// How far a scan has come, in lines.
struct LineMarks {
  int lines = 0;  ///< of the whole scan; 0 = not known
  int arrived = 0, computed = 0, final = 0;
  bool operator==(const LineMarks&) const = default;
};

/// The lines of a scan from left to right, arrived, computed and final ones in shades of their own; a handle
/// at the next line to come where one can go to another.
class LineTrack : public QSlider {
  Q_OBJECT
public:
  explicit LineTrack(QWidget* parent = nullptr);
  void setMarks(const LineMarks& marks);
  const LineMarks& marks() const { return marks_; }
  /// Without it this is a progress bar.
  void setSeekable(bool seekable);

  enum class Shade { Arrived, Computed, Final };
  static QColor colour(const QPalette& palette, Shade shade);

signals:
  /// A person wants this to be the next line.
  void sought(int line);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  QSize sizeHint() const override;

private:
  QRect groove() const;
  int lineAt(int x) const;
  void seek(int line);

  LineMarks marks_;
  bool seekable_ = true;
};

}  // namespace stratascope
