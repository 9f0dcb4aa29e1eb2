// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/welcome_page.h"

#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace stratascope {
namespace {
constexpr int kShown = 6;
}

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
  auto* logo = new QLabel;
  logo->setPixmap(QIcon(QStringLiteral(":/icons/stratascope.svg")).pixmap(72, 72));
  auto* title = new QLabel(tr("Drop a scan here"));
  QFont big = font();
  big.setPointSizeF(big.pointSizeF() * 1.7);
  title->setFont(big);
  auto* text =
      new QLabel(tr("3D scans become a cloud with surface classes, a 2.5D map and an extended 2.5D map.\n"
                    "Several files opened together go into one map."));
  text->setObjectName("muted");
  text->setAlignment(Qt::AlignHCenter);
  auto* open = new QPushButton(tr("Open a scan…"));
  open->setMinimumSize(150, 34);
  connect(open, &QPushButton::clicked, this, &WelcomePage::openRequested);

  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addStretch(2);
  for (QWidget* w : {static_cast<QWidget*>(logo), static_cast<QWidget*>(title), static_cast<QWidget*>(text),
                     static_cast<QWidget*>(open)})
    layout->addWidget(w, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  recent_ = new QVBoxLayout;
  recent_->setSpacing(2);
  layout->addLayout(recent_);
  layout->addStretch(3);
}

void WelcomePage::setRecent(const QStringList& recent) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (recent.isEmpty()) return;
  auto* title = new QLabel(tr("Recent"));
  title->setObjectName("muted");
  recent_->addWidget(title, 0, Qt::AlignHCenter);
  for (const QString& path : recent.mid(0, kShown)) {
    auto* link = new QLabel(QStringLiteral("<a href='f' style='text-decoration:none'>%1</a>")
                                .arg(QFileInfo(path).fileName().toHtmlEscaped()));
    link->setToolTip(path);
    connect(link, &QLabel::linkActivated, this, [this, path] { emit fileChosen(path); });
    recent_->addWidget(link, 0, Qt::AlignHCenter);
  }
}

}  // namespace stratascope
