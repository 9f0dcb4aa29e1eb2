// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

class QTableWidget;
class QTableWidgetItem;

namespace stratascope {

/// A scan as its line in the list shows it.
struct ScanRow {
  QString name;
  QString lattice;  ///< "226 × 360"
  QString points;
  QString pose;  ///< "x, y, z, roll, pitch, yaw" in m and degrees
  QString tip;
  bool poseCanChange = true;
  bool shown = true;
};

/// The open scans: a mark to hide each, and poses that can be typed over.
class ScanPanel : public QWidget {
  Q_OBJECT
public:
  explicit ScanPanel(QWidget* parent = nullptr);
  void setScans(const std::vector<ScanRow>& rows);

signals:
  void shownChanged(int row, bool shown);
  void poseTyped(int row, const QString& text);
  void chosen(int row);

private:
  void takeChange(QTableWidgetItem* item);

  QTableWidget* table_;
  bool filling_ = false;
};

}  // namespace stratascope
