// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/chart_files.h"

#include <QObject>
#include <QPixmap>

#include "io/file_util.h"
#include "widgets/chart_view.h"
#include "widgets/text_format.h"

namespace stratascope {

QString writeChartPicture(ChartView& view, const QString& path) {
  const QPixmap picture = view.picture();
  if (picture.save(path, path.endsWith(".png", Qt::CaseInsensitive) ? nullptr : "PNG")) return {};
  return QObject::tr("%1: cannot be written; choose another folder").arg(path);
}

void writeTextFile(Background& background, QObject* receiver, const QString& path,
                   std::function<Expected<std::string>()> text,
                   std::function<void(const QString& error)> done) {
  background.run(
      receiver,
      [text = std::move(text), file = nativePath(path)]() -> QString {
        try {
          const auto made = text();
          if (!made) return QString::fromStdString(made.error().message());
          const Status written = writeFileAtomically(file, *made);
          return written ? QString() : QString::fromStdString(written.error().message());
        } catch (const std::exception& e) {
          return QString::fromUtf8(e.what());
        }
      },
      std::move(done));
}

}  // namespace stratascope
