// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/picture_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>

#include "app/main_window.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {
constexpr int kSmallestPicture = 200;
}

QSize pictureSizeFromText(const QString& text) {
  static const QRegularExpression form(QStringLiteral("^(\\d{1,5})[x×](\\d{1,5})$"));
  const auto match = form.match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  const auto fits = [](int n) { return n >= kSmallestPicture && n <= kLargestPicture; };
  return fits(size.width()) && fits(size.height()) ? size : QSize();
}

PictureDialog::PictureDialog(MainWindow& window) : QDialog(&window), window_(window) {
  setWindowTitle(tr("Save picture with size"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QSize now = window.views().size() * window.devicePixelRatioF();
  const auto spin = [&](const char* name, int value) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(kSmallestPicture, kLargestPicture);
    box->setValue(value);
    box->setSuffix(tr(" pixels"));
    return box;
  };
  width_ = spin("pictureWidth", now.width());
  height_ = spin("pictureHeight", now.height());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* save = buttons->addButton(tr("Save…"), QDialogButtonBox::AcceptRole);
  save->setDefault(true);
  connect(save, &QPushButton::clicked, this, &PictureDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Width"), width_);
  form->addRow(tr("Height"), height_);
  form->addRow(buttons);
}

void PictureDialog::save() {
  if (!window_.snapshot()) return;
  window_.savePicture(window_.pictureOf({width_->value(), height_->value()}));
}

}  // namespace stratascope
