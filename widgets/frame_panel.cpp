// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/frame_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

namespace stratascope {

QString unitText(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Auto:
      break;
    case LengthUnit::Metre:
      return FramePanel::tr("metres");
    case LengthUnit::Centimetre:
      return FramePanel::tr("centimetres");
    case LengthUnit::Millimetre:
      return FramePanel::tr("millimetres");
    case LengthUnit::Foot:
      return FramePanel::tr("feet");
    case LengthUnit::SurveyFoot:
      return FramePanel::tr("US survey feet");
  }
  return FramePanel::tr("automatic");
}

QString axesText(FileAxes axes) {
  switch (axes) {
    case FileAxes::Auto:
      break;
    case FileAxes::ZUp:
      return FramePanel::tr("z up, x forward, y left");
    case FileAxes::YUp:
      return FramePanel::tr("y up, x right, z backward");
    case FileAxes::YUpForward:
      return FramePanel::tr("y up, x right, z forward (left-handed)");
    case FileAxes::YDown:
      return FramePanel::tr("y down, x right, z forward (camera)");
    case FileAxes::ZDown:
      return FramePanel::tr("z down, x forward, y right");
  }
  return FramePanel::tr("automatic");
}

namespace {

constexpr int kUnits = static_cast<int>(LengthUnit::SurveyFoot) + 1;
constexpr int kAxes = static_cast<int>(FileAxes::ZDown) + 1;

QDoubleSpinBox* spinBox(double limit, double step, int decimals, const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setLocale(QLocale::c());
  box->setRange(-limit, limit);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(70);
  return box;
}

}  // namespace

FramePanel::FramePanel(QWidget* parent) : QWidget(parent) {
  file_ = new QComboBox;
  file_->setObjectName("frameFile");
  unit_ = new QComboBox;
  unit_->setObjectName("frameUnit");
  for (int i = 0; i < kUnits; ++i) unit_->addItem(unitText(static_cast<LengthUnit>(i)));
  axes_ = new QComboBox;
  axes_->setObjectName("frameAxes");
  for (int i = 0; i < kAxes; ++i) axes_->addItem(axesText(static_cast<FileAxes>(i)));
  for (QComboBox* box : {file_, unit_, axes_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
  }
  size_ = new QLabel;
  size_->setObjectName("frameSize");
  size_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  hasPose_ = new QCheckBox(tr("Give the sensor's pose"));
  hasPose_->setObjectName("frameHasPose");
  hasPose_->setToolTip(
      tr("The points are in the sensor's own frame, and are moved by this pose into the map"));

  auto* poses = new QGridLayout;
  poses->setContentsMargins(0, 0, 0, 0);
  poses->setHorizontalSpacing(6);
  const QString names[6] = {tr("x"), tr("y"), tr("z"), tr("Roll"), tr("Pitch"), tr("Yaw")};
  for (int i = 0; i < 6; ++i) {
    QDoubleSpinBox* box = i < 3 ? spinBox(1e7, 0.05, 3, tr(" m")) : spinBox(360, 1, 2, tr("°"));
    box->setObjectName(QStringLiteral("framePose%1").arg(i));
    pose_[static_cast<size_t>(i)] = box;
    auto* label = new QLabel(names[i]);
    label->setBuddy(box);
    poses->addWidget(label, i % 3, 2 * (i / 3));
    poses->addWidget(box, i % 3, 2 * (i / 3) + 1);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &FramePanel::send);
  }
  poses->setColumnStretch(1, 1);
  poses->setColumnStretch(3, 1);
  back_ = new QPushButton(tr("Back to the guess"));
  back_->setObjectName("frameBack");
  back_->setToolTip(tr("Unit, axes and pose as the file says, or as they are guessed from its points"));
  notes_ = new QLabel;
  notes_->setObjectName("frameNotes");
  notes_->setWordWrap(true);
  notes_->setTextFormat(Qt::PlainText);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  notes_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  empty_ = new QLabel(tr("Open a scan first."));
  empty_->setObjectName("muted");

  form_ = new QWidget;
  auto* form = new QFormLayout(form_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  fileLabel_ = new QLabel(tr("File"));
  form->addRow(fileLabel_, file_);
  form->addRow(tr("Unit"), unit_);
  form->addRow(tr("Axes"), axes_);
  form->addRow(tr("Size"), size_);
  form->addRow(hasPose_);
  form->addRow(poses);
  form->addRow(back_);
  form->addRow(notes_);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 10, 12, 10);
  column->addWidget(empty_);
  column->addWidget(form_);
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  form_->hide();

  connect(file_, qOverload<int>(&QComboBox::activated), this, &FramePanel::showFile);
  for (QComboBox* box : {unit_, axes_})
    connect(box, qOverload<int>(&QComboBox::activated), this, &FramePanel::send);
  connect(hasPose_, &QCheckBox::toggled, this, &FramePanel::send);
  connect(back_, &QPushButton::clicked, this, [this] {
    if (const int file = file_->currentIndex(); file >= 0) emit edited(file, {}, std::nullopt);
  });
}

void FramePanel::setFiles(std::vector<FrameFacts> files) {
  const int before = file_->currentIndex();
  files_ = std::move(files);
  {
    const QSignalBlocker quiet(file_);
    file_->clear();
    for (const FrameFacts& file : files_) file_->addItem(file.name);
    file_->setCurrentIndex(std::clamp(before, 0, std::max(0, file_->count() - 1)));
  }
  file_->setVisible(files_.size() > 1);
  fileLabel_->setVisible(files_.size() > 1);
  form_->setVisible(!files_.empty());
  empty_->setVisible(files_.empty());
  showFile();
}

void FramePanel::choose(int file) {
  file_->setCurrentIndex(file);
  showFile();
}

void FramePanel::showFile() {
  if (file_->currentIndex() < 0) return;
  const FrameFacts& facts = files_[static_cast<size_t>(file_->currentIndex())];
  filling_ = true;
  const FileFrame automatic = facts.guess.value_or(FileFrame{});
  unit_->setItemText(0, facts.guess ? tr("automatic: %1").arg(unitText(automatic.unit)) : tr("automatic"));
  axes_->setItemText(0, facts.guess ? tr("automatic: %1").arg(axesText(automatic.axes)) : tr("automatic"));
  unit_->setCurrentIndex(static_cast<int>(facts.asked.unit));
  axes_->setCurrentIndex(static_cast<int>(facts.asked.axes));
  unit_->setToolTip(unit_->currentText());
  axes_->setToolTip(axes_->currentText());
  size_->setText(facts.size);
  hasPose_->setChecked(facts.pose.has_value());
  hasPose_->setEnabled(facts.scans == 1);
  const std::array<double, 6>& pose = facts.pose ? *facts.pose : facts.ownPose;
  for (size_t i = 0; i < pose_.size(); ++i) {
    if (!pose_[i]->hasFocus() || pose_[i]->value() != pose[i]) pose_[i]->setValue(pose[i]);
    pose_[i]->setEnabled(facts.pose.has_value());
  }
  back_->setEnabled(facts.asked != FileFrame{} || facts.pose);
  QStringList notes = facts.notes;
  if (facts.scans > 1) notes << tr("The file holds %1 scans with poses of their own.").arg(facts.scans);
  if (notes.isEmpty()) notes << tr("Nothing had to be guessed.");
  for (QString& note : notes) note.prepend(QStringLiteral("•  "));
  notes_->setText(notes.join('\n'));
  filling_ = false;
}

void FramePanel::send() {
  const int file = file_->currentIndex();
  if (filling_ || file < 0) return;
  std::optional<std::array<double, 6>> pose;
  if (hasPose_->isChecked()) {
    pose.emplace();
    for (size_t i = 0; i < pose_.size(); ++i) (*pose)[i] = pose_[i]->value();
  }
  for (QDoubleSpinBox* box : pose_) box->setEnabled(pose.has_value());
  emit edited(file,
              {static_cast<LengthUnit>(unit_->currentIndex()), static_cast<FileAxes>(axes_->currentIndex())},
              pose);
}

}  // namespace stratascope
