// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/preset_bar.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "io/file_util.h"
#include "params/param_table.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

QString nameOf(const QString& file) {
  QString name = QFileInfo(file).completeBaseName().replace('_', ' ');
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

}  // namespace

std::vector<Preset> findPresets(const QString& ownFolder, QStringList& problems) {
  std::vector<Preset> out{{QObject::tr("Defaults"), {}, false, {}}};
  const auto read = [&](const QString& folder, bool own) {
    for (const QFileInfo& info :
         QDir(folder).entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
      QFile file(info.filePath());
      if (!file.open(QIODevice::ReadOnly)) {
        problems << QObject::tr("%1: cannot be read").arg(info.filePath());
        continue;
      }
      const QByteArray bytes = file.read(1 << 20);
      const auto params = paramsFromJson({bytes.constData(), static_cast<size_t>(bytes.size())},
                                         info.filePath().toStdString());
      if (!params) {
        problems << QString::fromStdString(params.error().message());
        continue;
      }
      const QString name =
          own ? nameOf(info.filePath()) : tableText(nameOf(info.filePath()).toUtf8().constData());
      out.push_back({name, info.filePath(), own, *params});
    }
  };
  read(QStringLiteral(":/presets"), false);
  if (!ownFolder.isEmpty()) read(ownFolder, true);
  return out;
}

PresetBar::PresetBar(QString ownFolder, QWidget* parent) : QWidget(parent), folder_(std::move(ownFolder)) {
  list_ = new QComboBox;
  list_->setObjectName("presets");
  list_->setToolTip(tr("Presets: all parameters at once"));
  list_->setAccessibleName(tr("Preset"));
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* more = new QToolButton;
  more->setObjectName("presetMenu");
  setThemedIcon(more, "menu");
  more->setToolTip(tr("Keep, remove, copy"));
  more->setAutoRaise(true);
  more->setPopupMode(QToolButton::InstantPopup);
  menu_ = new QMenu(more);
  QAction* save = menu_->addAction(tr("Keep as own preset…"));
  remove_ = menu_->addMenu(tr("Remove own preset"));
  more->setMenu(menu_);

  naming_ = new QWidget;
  name_ = new QLineEdit;
  name_->setObjectName("presetName");
  name_->setPlaceholderText(tr("Name of the preset"));
  auto* keep = new QPushButton(tr("Keep"));
  auto* naming = new QHBoxLayout(naming_);
  naming->setContentsMargins(0, 4, 0, 0);
  naming->addWidget(name_, 1);
  naming->addWidget(keep);
  naming_->hide();

  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(list_, 1);
  row->addWidget(more);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 8, 8, 4);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(naming_);

  save->setEnabled(!folder_.isEmpty());
  connect(save, &QAction::triggered, this, [this] {
    naming_->show();
    name_->clear();
    name_->setFocus();
  });
  const auto done = [this] {
    if (saveOwn(name_->text())) naming_->hide();
  };
  connect(keep, &QPushButton::clicked, this, done);
  connect(name_, &QLineEdit::returnPressed, this, done);
  connect(remove_, &QMenu::aboutToShow, this, &PresetBar::fillRemove);
  connect(list_, qOverload<int>(&QComboBox::activated), this, [this](int i) {
    if (i >= 0 && i < static_cast<int>(presets_.size()))
      emit chosen(presets_[static_cast<size_t>(i)].params, presets_[static_cast<size_t>(i)].name);
  });
  reload();
}

void PresetBar::setParams(const PipelineParams& params) {
  params_ = params;
  showCurrent();
}

void PresetBar::reload() {
  QStringList problems;
  presets_ = findPresets(folder_, problems);
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const Preset& preset : presets_) list_->addItem(preset.name);
  showCurrent();
  for (const QString& problem : problems) emit failed(problem);
}

void PresetBar::showCurrent() {
  int current = -1;
  for (size_t i = presets_.size(); i-- > 0;)
    if (presets_[i].params == params_) current = static_cast<int>(i);
  const int extra = list_->count() - static_cast<int>(presets_.size());
  if (current == list_->currentIndex() && (current >= 0) == (extra == 0)) return;
  const QSignalBlocker quiet(list_);
  while (list_->count() > static_cast<int>(presets_.size())) list_->removeItem(list_->count() - 1);
  if (current < 0) {
    list_->addItem(tr("Own values"));
    current = list_->count() - 1;
  }
  list_->setCurrentIndex(current);
}

void PresetBar::fillRemove() {
  remove_->clear();
  for (const Preset& preset : presets_)
    if (preset.own)
      connect(remove_->addAction(preset.name), &QAction::triggered, this,
              [this, name = preset.name] { removeOwn(name); });
  if (remove_->isEmpty()) remove_->addAction(tr("None yet"))->setEnabled(false);
}

bool PresetBar::saveOwn(const QString& name) {
  QString file = name.simplified().toLower().replace(' ', '_');
  file.remove('/');
  if (file.isEmpty() || file.startsWith('.')) {
    emit failed(tr("A preset needs a name of letters or digits"));
    return false;
  }
  if (folder_.isEmpty() || !QDir().mkpath(folder_)) {
    emit failed(tr("%1: cannot be made; presets cannot be kept").arg(folder_));
    return false;
  }
  const QString path = folder_ + '/' + file + QStringLiteral(".json");
  const Status written = writeFileAtomically(QFile::encodeName(path).toStdString(), paramsToJson(params_));
  if (!written) {
    emit failed(QString::fromStdString(written.error().message()));
    return false;
  }
  reload();
  return true;
}

void PresetBar::removeOwn(const QString& name) {
  for (const Preset& preset : presets_)
    if (preset.own && preset.name == name && !QFile::remove(preset.file))
      emit failed(tr("%1: cannot be removed").arg(preset.file));
  reload();
}

}  // namespace stratascope
