// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "params/pipeline_params.h"

class QAction;
class QComboBox;
class QLineEdit;
class QMenu;

namespace stratascope {

struct Preset {
  QString name;
  QString file;  ///< empty for the defaults
  bool own = false;
  PipelineParams params;
};

/// The defaults, the presets that come with the program, then those of the folder. Files that cannot be read
/// are left out and named in problems.
std::vector<Preset> findPresets(const QString& ownFolder, QStringList& problems);

/// A list of presets over the parameters: shows which one stands, lets one be chosen, keeps present values as
/// one's own.
class PresetBar : public QWidget {
  Q_OBJECT
public:
  /// Without a folder there are no own presets.
  explicit PresetBar(QString ownFolder, QWidget* parent = nullptr);

  void setParams(const PipelineParams& params);
  /// Writes the present values under that name; emits failed() if that cannot be.
  bool saveOwn(const QString& name);
  void removeOwn(const QString& name);
  /// For more entries of the menu.
  QMenu* menu() const { return menu_; }

signals:
  void chosen(const PipelineParams& params, const QString& name);
  void failed(const QString& message);

private:
  void reload();
  void showCurrent();
  void fillRemove();

  QString folder_;
  PipelineParams params_;
  std::vector<Preset> presets_;
  QComboBox* list_;
  QWidget* naming_;
  QLineEdit* name_;
  QMenu *menu_, *remove_;
};

}  // namespace stratascope
