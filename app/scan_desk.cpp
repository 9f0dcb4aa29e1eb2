// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/scan_desk.h"

#include <QFile>
#include <algorithm>
#include <filesystem>

#include "io/file_util.h"
#include "io/scan_paths.h"

namespace stratascope {
namespace {

bool samePose(const std::optional<Eigen::Isometry3d>& a, const std::optional<Eigen::Isometry3d>& b) {
  return a.has_value() == b.has_value() && (!a || a->matrix() == b->matrix());
}

}  // namespace

Expected<std::vector<DeskFile>> deskFiles(const QStringList& paths,
                                          const std::vector<Eigen::Isometry3d>& poses,
                                          const FileFrame& frame) {
  std::vector<std::string> native;
  for (const QString& path : paths) native.push_back(QFile::encodeName(path).toStdString());
  const auto found = scanFiles(native);
  if (!found) return found.error();
  require(poses.empty() || poses.size() == found->size(), "deskFiles: one pose a file, or none");
  std::vector<DeskFile> files(found->size());
  for (size_t i = 0; i < files.size(); ++i) {
    files[i].path = QFile::decodeName((*found)[i].c_str());
    files[i].frame = frame;
    if (!poses.empty()) files[i].pose = poses[i];
  }
  return files;
}

std::vector<DeskFile> deskFiles(const SessionFile& session) {
  std::vector<DeskFile> files;
  for (const SessionInput& input : session.inputs)
    files.push_back(
        {QFile::decodeName(input.path.c_str()), input.frame, sessionPose(input), input.hidden, input.sha256});
  return files;
}

bool DeskFile::sameReading(const DeskFile& other) const {
  return path == other.path && frame == other.frame && samePose(pose, other.pose);
}

bool DeskFile::operator==(const DeskFile& other) const {
  return sameReading(other) && hidden == other.hidden;
}

ScanDesk::Result ScanDesk::readAll(const Request& request, const std::vector<ReadFile>& before) {
  Result result;
  std::optional<Eigen::Vector3d> origin;
  for (size_t i = 0; i < request.files.size(); ++i) {
    const DeskFile& file = request.files[i];
    const std::string path = QFile::encodeName(file.path).toStdString();
    const bool known = request.change != Change::Opened && i < before.size();
    if (known && !request.anew && before[i].asked.sameReading(file) && before[i].origin == origin) {
      result.read.push_back(before[i]);
      result.read.back().asked.hidden = file.hidden;
    } else {
      ReadFile& read = result.read.emplace_back();
      read.asked = file;
      read.origin = origin;
      if (known) read.guess = before[i].guess;
      try {
        const ReadOptions options{file.pose, file.frame, origin};
        std::error_code failed;
        // readAllScans() says what a directory is.
        auto bytes = std::filesystem::is_directory(path, failed) ? Expected<std::string>(std::string())
                                                                 : readFile(path);
        if (!bytes) {
          result.error = QString::fromStdString(bytes.error().message());
          return result;
        }
        read.asked.sha256 = sha256Hex(*bytes);
        if (!file.sha256.empty() && file.sha256 != read.asked.sha256 && request.change == Change::Opened)
          result.other << file.path;
        auto scans =
            bytes->empty() ? readAllScans(path, options) : readAllScanBytes(path, std::move(*bytes), options);
        if (!scans) {
          result.error = QString::fromStdString(scans.error().message());
          return result;
        }
        const Scan& first = scans->front();
        if (file.frame == FileFrame{} && !file.pose)
          read.guess = Guess{{lengthUnitFromText(first.fileUnit).value_or(LengthUnit::Metre),
                              fileAxesFromText(first.fileAxes).value_or(FileAxes::ZUp)},
                             first.notes};
        for (Scan& scan : *scans) {
          read.summaries.push_back(summarize(scan));
          read.scans.push_back(std::make_shared<const Scan>(std::move(scan)));
        }
      } catch (const std::bad_alloc&) {
        result.error = tr("%1: not enough memory to read it; thin the cloud or split it").arg(file.path);
        return result;
      } catch (const std::exception& e) {
        result.error = tr("%1: could not be read: %2").arg(file.path, QString::fromUtf8(e.what()));
        return result;
      }
    }
    if (!origin) origin = result.read.front().scans.front()->localOrigin;
  }
  return result;
}

void ScanDesk::open(std::vector<DeskFile> files) {
  begin({std::move(files), Change::Opened, true});
}

void ScanDesk::change(std::vector<DeskFile> files) {
  for (const auto* request : {&running_, &next_})
    if (*request && (*request)->change == Change::Opened) return;
  const bool anew = next_ && next_->anew;
  bool reading = anew || files.size() != files_.size();
  for (size_t i = 0; !reading && i < files.size(); ++i) reading = !files[i].sameReading(files_[i]);
  begin({std::move(files), reading ? Change::Frame : Change::Shown, anew});
}

void ScanDesk::clear() {
  next_.reset();
  discard_ = running_.has_value();
  files_.clear();
  read_.clear();
  entries_.clear();
}

void ScanDesk::reload() {
  if (!files_.empty()) begin({files_, Change::Frame, true});
}

void ScanDesk::begin(Request request) {
  if (running_) {
    next_ = std::move(request);
    return;
  }
  running_ = std::move(request);
  emit readingChanged();
  background_.run(
      this, [request = *running_, before = read_] { return readAll(request, before); },
      [this](Result result) { take(std::move(result)); });
}

void ScanDesk::take(Result result) {
  const Request request = *std::exchange(running_, std::nullopt);
  const bool discarded = std::exchange(discard_, false);
  if (discarded && !next_) return emit readingChanged();
  if (next_ && (discarded || next_->change == Change::Opened || !result.error.isEmpty())) {
    // What has just been read is no longer asked for.
    begin(*std::exchange(next_, std::nullopt));
    return;
  }
  if (!result.error.isEmpty()) {
    emit failed(result.error);
  } else {
    read_ = std::move(result.read);
    files_.clear();
    entries_.clear();
    for (size_t i = 0; i < read_.size(); ++i) {
      files_.push_back(read_[i].asked);
      const std::vector<int>& hidden = read_[i].asked.hidden;
      for (size_t k = 0; k < read_[i].scans.size(); ++k)
        entries_.push_back({static_cast<int>(i), static_cast<int>(k), read_[i].scans[k],
                            read_[i].summaries[k],
                            std::binary_search(hidden.begin(), hidden.end(), static_cast<int>(k))});
    }
    emit scansChanged(request.change);
    if (!result.other.isEmpty()) emit otherContent(result.other);
  }
  if (next_) begin(*std::exchange(next_, std::nullopt));
  emit readingChanged();
}

const std::vector<DeskFile>& ScanDesk::asked() const {
  return next_ ? next_->files : running_ ? running_->files : files_;
}

std::vector<ScanPtr> ScanDesk::shown() const {
  std::vector<ScanPtr> scans;
  for (const Entry& entry : entries_)
    if (!entry.hidden) scans.push_back(entry.data);
  return scans;
}

}  // namespace stratascope
