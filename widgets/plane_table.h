// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMap>
#include <map>
#include <vector>

#include "widgets/row_table.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// All planes by their numbers: a click selects one, a double click shows it from near; a plane can be
/// hidden, and names and own colours can be given, which stay with the number while the scans are the same.
/// The list can be sorted, filtered, copied and written to a file.
class PlanePanel : public RowPanel {
  Q_OBJECT
public:
  explicit PlanePanel(Selection& selection, QWidget* parent = nullptr);
  void setGeometry(const ViewGeometryPtr& geometry);

  QString asCsv() const override;

  /// Numbers, ascending.
  std::vector<std::uint32_t> hiddenPlanes() const;
  std::map<std::uint32_t, Rgb> ownColours() const { return colours_; }
  void setHidden(std::uint32_t number, bool hidden);
  /// Without a colour: the one of its number again.
  void setColour(std::uint32_t number, std::optional<Rgb> colour);
  void showAll();

signals:
  void zoomRequested(PlaneLabel label);
  /// Which planes are hidden, or their colours.
  void lookChanged();

protected:
  QString fileTitle() const override { return tr("Write planes"); }
  QString fileName() const override { return QStringLiteral("planes.csv"); }
  void rowChosen(int row) override;
  void rowOpened(int row) override;
  void fillMenu(QMenu* menu, int row) override;

private:
  void setColumns();
  void follow();
  void chooseColour(std::uint32_t number);
  int rowOf(PlaneLabel label) const;
  const Plane& plane(int row) const { return *planes_[static_cast<size_t>(row)]; }
  std::uint32_t number(int row) const { return geometry_->numbers.of(plane(row).label); }
  Rgb colourOf(std::uint32_t number) const;

  Selection& selection_;
  ViewGeometryPtr geometry_;  ///< keeps the planes alive
  std::vector<const Plane*> planes_;
  QMap<std::uint32_t, QString> names_;
  std::map<std::uint32_t, bool> hidden_;
  std::map<std::uint32_t, Rgb> colours_;
};

}  // namespace stratascope
