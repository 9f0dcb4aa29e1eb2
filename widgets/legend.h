// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QPixmap>
#include <QWidget>
#include <vector>

#include "widgets/colour_maps.h"

namespace stratascope {

struct ColourKey;

/// A card over a 3D picture that says what its colours mean: a list of swatches, or a scalar bar. Lets the
/// mouse through.
class Legend : public QWidget {
  Q_OBJECT
public:
  struct Entry {
    QColor colour;
    QString name;
    QString value;
    bool operator==(const Entry&) const = default;
  };
  explicit Legend(QWidget* parent = nullptr);

  void showList(const QString& title, std::vector<Entry> entries);
  void showKey(const ColourKey& key);
  void showScale(const QString& title, const ColourScale& scale);

  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void paint(QPainter& painter) const;
  void change();

  QString title_;
  std::vector<Entry> entries_;
  ColourScale scale_;
  bool bar_ = false;
  QPixmap picture_;  ///< for each picture behind it, the same
};

/// Round numbers between low and high, at most `most` of them.
std::vector<double> niceTicks(double low, double high, int most);

}  // namespace stratascope
