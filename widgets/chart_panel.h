// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/chart_data.h"
#include "widgets/newest_job.h"

class QCheckBox;
class QComboBox;

namespace stratascope {

/// One chart of the result on screen, to choose from a list. It follows the result and the selection while it
/// is visible; a click on a plane's bar selects the plane. Charts are made off the window's thread.
class ChartPanel : public QWidget {
  Q_OBJECT
public:
  explicit ChartPanel(Selection& selection, QWidget* parent = nullptr);

  void setGeometry(const ViewGeometryPtr& geometry);
  void setKind(ChartKind kind);
  ChartKind kind() const;

  /// What is shown; none before the first.
  const std::optional<ChartData>& chart() const { return chart_; }
  ChartView* view() const { return view_; }
  /// What is shown is of the newest result and selection.
  bool settled() const { return !job_.running() && !stale_; }

  /// Both in the background or at once; say by `noted` or `failed` how it went.
  void writeCsv(const QString& path);
  void writePicture(const QString& path);

signals:
  void noted(const QString& text);
  void failed(const QString& message);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void tellWritten(const QString& path, const QString& error);
  void refresh();
  void show(ChartData chart);
  void setLogarithmic(bool on);
  void askAndWrite(bool picture);

  Selection& selection_;
  ViewGeometryPtr geometry_;
  std::optional<ChartData> chart_;
  std::array<bool, kChartKinds> logarithmic_{};
  bool stale_ = false;
  QComboBox* kinds_;
  QCheckBox* log_;
  ChartView* view_;
  NewestJob job_;
  Background writing_;
};

}  // namespace stratascope
