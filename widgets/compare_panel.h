// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "widgets/comparer.h"

class QComboBox;
class QScrollArea;
class QToolButton;
class QUrl;

namespace stratascope {

class ClassMatrix;
class FittedText;

/// A beside B in numbers: figures, parameters that differ, what became of points, cells and planes, times of
/// the stages, and the classes as a matrix.
class ComparePanel : public QWidget {
  Q_OBJECT
public:
  explicit ComparePanel(QWidget* parent = nullptr);

  void setResult(const Comparer::Result& result);
  void setMode(CompareMode mode);
  QString plainText() const;
  const ClassMatrix& matrix() const { return *matrix_; }

signals:
  void modeChosen(CompareMode mode);
  void keepRequested();
  void backRequested();
  void swapRequested();
  void dropRequested();
  void planeChosen(PlaneLabel label);
  void copied(const QString& what);

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();

  QComboBox* modes_;
  std::vector<QToolButton*> needA_;
  QScrollArea* scroll_;
  FittedText *above_, *below_;  ///< the matrix
  ClassMatrix* matrix_;
  Comparer::Result result_;
};

}  // namespace stratascope
