// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the main window does with the scans that are open: how they are read, and which are shown.
#include <QCryptographicHash>
#include <QDateTime>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QUndoCommand>
#include <QVBoxLayout>
#include <algorithm>

#include "app/autosave.h"
#include "app/live_control.h"
#include "app/main_window.h"
#include "app/scan_desk.h"
#include "app/session.h"
#include "app/window_state.h"
#include "widgets/frame_panel.h"
#include "widgets/log_panel.h"
#include "widgets/message_bar.h"
#include "widgets/offer_bar.h"
#include "widgets/param_history.h"
#include "widgets/scan_panel.h"
#include "widgets/text_format.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

QString number(double value) {
  return QString::number(value, 'g', 12);
}

QString shownPose(const std::array<double, 6>& pose) {
  QStringList words;
  for (const double v : pose) words << number(v);
  return words.join(QStringLiteral(", "));
}

/// How files were read before, kept by place, size and time of change.
QString memoryKey(const QString& path) {
  const QByteArray name = QFileInfo(path).absoluteFilePath().toUtf8();
  return QStringLiteral("frames/") +
         QString::fromLatin1(QCryptographicHash::hash(name, QCryptographicHash::Sha1).toHex());
}

QStringList stampOf(const QString& path) {
  const QFileInfo info(path);
  return {QString::number(info.size()), QString::number(info.lastModified().toMSecsSinceEpoch())};
}

void remember(const DeskFile& file) {
  QSettings settings;
  if (file.frame == FileFrame{} && !file.pose) return settings.remove(memoryKey(file.path));
  settings.setValue(memoryKey(file.path),
                    stampOf(file.path) +
                        QStringList{lengthUnitName(file.frame.unit), fileAxesName(file.frame.axes),
                                    file.pose ? shownPose(poseNumbers(*file.pose)).remove(' ') : QString()});
}

bool recall(DeskFile& file) {
  const QStringList kept = QSettings().value(memoryKey(file.path)).toStringList();
  if (kept.size() != 5 || kept.mid(0, 2) != stampOf(file.path)) return false;
  const auto unit = lengthUnitFromText(kept[2].toStdString());
  const auto axes = fileAxesFromText(kept[3].toStdString());
  if (!unit || !axes) return false;
  file.frame = {*unit, *axes};
  if (!kept[4].isEmpty())
    if (const auto pose = poseFromText(kept[4].toStdString())) file.pose = *pose;
  return true;
}

/// A step of the desk that can be undone; of no use once other files are open.
class DeskCommand : public QUndoCommand {
public:
  /// Poses change by many small steps, which are undone together.
  DeskCommand(ScanDesk& desk, std::vector<DeskFile> before, std::vector<DeskFile> after, const QString& what)
      : QUndoCommand(what), desk_(desk), before_(std::move(before)), after_(std::move(after)) {
    for (size_t i = 0; i < after_.size(); ++i)
      pose_ |= before_[i].frame == after_[i].frame && before_[i].pose && after_[i].pose;
  }
  void undo() override { go(before_); }
  void redo() override { go(after_); }
  int id() const override { return pose_ ? 2 : -1; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const DeskCommand&>(*next);
    if (other.text() != text() || other.before_ != after_) return false;
    after_ = other.after_;
    return true;
  }

private:
  void go(const std::vector<DeskFile>& files) {
    const auto& now = desk_.files();
    setObsolete(!std::ranges::equal(now, files, {}, &DeskFile::path, &DeskFile::path));
    if (!isObsolete()) desk_.change(files);
  }
  ScanDesk& desk_;
  std::vector<DeskFile> before_, after_;
  bool pose_ = false;
};

Eigen::AlignedBox3d boundsOf(const ScanDesk& desk, int file) {
  Eigen::AlignedBox3d box;
  for (const ScanDesk::Entry& entry : desk.entries())
    if (entry.file == file && entry.summary.bounds) box.extend(*entry.summary.bounds);
  return box;
}

QStringList texts(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const std::string& sentence : sentences) list << QString::fromStdString(sentence);
  return list;
}

/// What core's notes say of guesses; the rest of them is not news.
QString guessText(const std::vector<std::string>& notes) {
  QStringList found;
  for (const std::string& note : notes)
    for (const char* begin : {"Unit guessed", "Axes guessed", "Far for metres", "This looks like a camera",
                              "The file does not say its unit"})
      if (note.starts_with(begin)) found << QString::fromStdString(note);
  return found.join(' ');
}

}  // namespace

void MainWindow::buildScanParts() {
  desk_ = new ScanDesk(this);
  scanPanel_ = new ScanPanel;
  framePanel_ = new FramePanel;
  const auto dock = [this](const QString& title, const char* name, QWidget* widget, const char* beside) {
    auto* d = new QDockWidget(title, this);
    d->setObjectName(QLatin1String(name));
    d->setWidget(widget);
    addDockWidget(Qt::RightDockWidgetArea, d);
    if (auto* other = findChild<QDockWidget*>(QLatin1String(beside))) tabifyDockWidget(other, d);
    d->hide();
    return d;
  };
  dock(tr("Scans"), "scansDock", scanPanel_, "planesDock");
  frameDock_ = dock(tr("Units and axes"), "frameDock", framePanel_, "inspectorDock");

  connect(desk_, &ScanDesk::readingChanged, this, [this] {
    if (std::exchange(deskReads_, desk_->reading()) != desk_->reading())
      reading_ += desk_->reading() ? 1 : -1;
    showProgress();
  });
  connect(desk_, &ScanDesk::failed, this, [this](const QString& message) {
    opening_.reset();
    showError(message);
    showScans();
  });
  connect(desk_, &ScanDesk::otherContent, this, [this](const QStringList& paths) {
    showError(tr("Not the same as when the session was saved: %1").arg(paths.join(QStringLiteral(", "))));
  });
  connect(desk_, &ScanDesk::scansChanged, this, &MainWindow::takeScans);
  connect(framePanel_, &FramePanel::edited, this,
          [this](int file, const FileFrame& frame, const std::optional<std::array<double, 6>>& pose) {
            std::vector<DeskFile> files = desk_->asked();
            if (static_cast<size_t>(file) >= files.size()) return;
            DeskFile& changed = files[static_cast<size_t>(file)];
            changed.frame = frame;
            SessionInput input;
            input.pose = pose;
            changed.pose = sessionPose(input);
            changeDesk(files, tr("Units and axes of %1").arg(QFileInfo(changed.path).fileName()));
          });
  connect(scanPanel_, &ScanPanel::shownChanged, this, &MainWindow::showScan);
  connect(scanPanel_, &ScanPanel::poseTyped, this, [this](int row, const QString& text) {
    const auto pose = poseFromText(text.toStdString());
    if (!pose) {
      showError(QString::fromStdString(pose.error().message()));
      QMetaObject::invokeMethod(
          this, [this] { showScans(); }, Qt::QueuedConnection);
      return;
    }
    std::vector<DeskFile> files = desk_->asked();
    DeskFile& changed = files[static_cast<size_t>(desk_->entries()[static_cast<size_t>(row)].file)];
    changed.pose = *pose;
    changeDesk(files, tr("Pose of %1").arg(QFileInfo(changed.path).fileName()));
  });
  connect(scanPanel_, &ScanPanel::chosen, this,
          [this](int row) { framePanel_->choose(desk_->entries()[static_cast<size_t>(row)].file); });

  offer_ = new OfferBar;
  guessed_ = new OfferBar;
  auto* column = static_cast<QVBoxLayout*>(centralWidget()->layout());
  column->insertWidget(1, offer_);
  column->insertWidget(2, guessed_);
  connect(guessed_, &OfferBar::taken, this, &MainWindow::showFrames);
  const QString folder = session_->keeps()
                             ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave"
                             : QString();
  autosave_ = new Autosave(
      folder, [this] { return desk_->files().empty() ? std::nullopt : std::optional(session()); }, this);
  const auto touch = [this] { autosave_->touch(); };
  connect(desk_, &ScanDesk::scansChanged, autosave_, touch);
  connect(bridge_, &PipelineBridge::geometryChanged, autosave_, touch);
  connect(&selection_, &Selection::changed, autosave_, touch);
  for (VtkView* view : views_->all()) connect(view, &VtkView::cameraMoved, autosave_, touch);
  connect(offer_, &OfferBar::taken, this, [this] { openSession(offered_, true); });
  connect(offer_, &OfferBar::left, autosave_, &Autosave::forgetLeftBehind);
}

void MainWindow::openFiles(const QStringList& paths, const std::vector<Eigen::Isometry3d>& poses,
                           const FileFrame& frame) {
  if (paths.isEmpty()) return;
  if (isSessionName(paths.front())) return openSession(paths.front());
  auto files = deskFiles(paths, poses, frame);
  if (!files) return showError(QString::fromStdString(files.error().message()));
  if (poses.empty() && frame == FileFrame{} && session_->keeps())
    for (DeskFile& file : *files)
      if (recall(file))
        log_->add(tr("%1: units and axes as set before").arg(QFileInfo(file.path).fileName()));
  opening_.reset();
  ++requested_;
  desk_->open(std::move(*files));
}

void MainWindow::reload() {
  if (live_->isOpen()) return openStream(live_->request(), live_->pose());
  desk_->reload();
}

void MainWindow::leaveFiles() {
  desk_->clear();
  opening_.reset();
  arriving_.reset();
  keepView_ = false;
  guessed_->hide();
  showScans();
}

void MainWindow::takeScans(ScanDesk::Change change) {
  message_->hide();
  if (change == ScanDesk::Change::Opened) {
    QStringList paths;
    for (const DeskFile& file : desk_->files()) paths << file.path;
    if (opening_) {
      if (!opening_->recovered) session_->addRecent({opening_->path});
      history_->clear();
      setParams(opening_->params);
      bridge_->setViewOptions(opening_->window.options);
      arriving_ = opening_->window;
      if (opening_->recovered) autosave_->forgetLeftBehind();
      opening_.reset();
    } else {
      session_->addRecent(paths);
      arriving_.reset();
    }
    QStringList guesses;
    for (size_t i = 0; i < desk_->files().size(); ++i)
      if (const auto& guess = desk_->guess(static_cast<int>(i)))
        if (const QString text = guessText(guess->notes); !text.isEmpty() && !guesses.contains(text))
          guesses << text;
    if (guesses.isEmpty())
      guessed_->hide();
    else
      guessed_->offer(guesses.join('\n'), tr("Change…"), tr("Close"));
    for (const QString& guess : guesses) log_->add(guess);
  } else if (session_->keeps() && change == ScanDesk::Change::Frame) {
    for (const DeskFile& file : desk_->files()) remember(file);
  }
  keepView_ = change == ScanDesk::Change::Shown;
  showScans();
  bridge_->setScans(desk_->shown());
  emit opened();
}

void MainWindow::changeDesk(const std::vector<DeskFile>& files, const QString& what) {
  if (!(files == desk_->asked())) history_->push(new DeskCommand(*desk_, desk_->asked(), files, what));
}

void MainWindow::showScan(int row, bool shown) {
  const auto& entries = desk_->entries();
  const ScanDesk::Entry& entry = entries[static_cast<size_t>(row)];
  std::vector<DeskFile> files = desk_->asked();
  std::vector<int>& hidden = files[static_cast<size_t>(entry.file)].hidden;
  std::erase(hidden, entry.scan);
  if (!shown) hidden.insert(std::ranges::upper_bound(hidden, entry.scan), entry.scan);
  size_t out = 0;
  for (const DeskFile& file : files) out += file.hidden.size();
  if (out >= entries.size()) {
    note(tr("One scan must stay."));
    QMetaObject::invokeMethod(
        this, [this] { showScans(); }, Qt::QueuedConnection);
    return;
  }
  changeDesk(files, (shown ? tr("Show %1") : tr("Hide %1")).arg(QString::fromStdString(entry.data->name)));
}

void MainWindow::showScans() {
  std::vector<ScanRow> rows;
  for (const ScanDesk::Entry& entry : desk_->entries()) {
    const Scan& scan = *entry.data;
    ScanRow& row = rows.emplace_back();
    row.name = QString::fromStdString(scan.name);
    row.lattice = scan.unordered()
                      ? tr("none")
                      : QStringLiteral("%1 × %2").arg(scan.lattice->lines()).arg(scan.lattice->beams());
    row.points = countText(entry.summary.points);
    row.pose = shownPose(poseNumbers(scan.pose.map_T_scan));
    size_t siblings = 0;
    for (const auto& other : desk_->entries()) siblings += other.file == entry.file;
    row.poseCanChange = siblings == 1;
    row.tip = QString::fromStdString(scan.path) + '\n' + row.pose + '\n' +
              QString::fromStdString(scan.format) + '\n' + texts(scan.notes).join('\n');
    row.shown = !entry.hidden;
  }
  scanPanel_->setScans(rows);

  std::vector<FrameFacts> facts;
  for (size_t i = 0; i < desk_->files().size(); ++i) {
    const DeskFile& file = desk_->files()[i];
    FrameFacts& f = facts.emplace_back();
    f.name = QFileInfo(file.path).fileName();
    f.asked = file.frame;
    f.scans = 0;
    for (const ScanDesk::Entry& entry : desk_->entries()) {
      if (entry.file != static_cast<int>(i)) continue;
      if (f.scans++ > 0) continue;
      f.used = {lengthUnitFromText(entry.data->fileUnit).value_or(LengthUnit::Metre),
                fileAxesFromText(entry.data->fileAxes).value_or(FileAxes::ZUp)};
      f.ownPose = poseNumbers(entry.data->pose.map_T_scan);
      f.notes = texts(entry.data->notes);
    }
    if (file.pose) f.pose = poseNumbers(*file.pose);
    if (const auto& guess = desk_->guess(static_cast<int>(i))) {
      f.guess = guess->frame;
      for (const QString& note : texts(guess->notes))
        if (!f.notes.contains(note)) f.notes << note;
    }
    const Eigen::AlignedBox3d box = boundsOf(*desk_, static_cast<int>(i));
    if (!box.isEmpty()) {
      const Eigen::Vector3d size = box.sizes();
      f.size = tr("%1 × %2 × %3 m")
                   .arg(QString::number(size.x(), 'f', 2), QString::number(size.y(), 'f', 2),
                        QString::number(size.z(), 'f', 2));
    }
  }
  framePanel_->setFiles(std::move(facts));
  if (desk_->entries().size() > 1 && !scansShownOnce_) {
    scansShownOnce_ = true;
    findChild<QDockWidget*>(QStringLiteral("scansDock"))->show();
  }
}

void MainWindow::showFrames() {
  frameDock_->show();
  frameDock_->raise();
}

}  // namespace stratascope
