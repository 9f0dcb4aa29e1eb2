// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QObject>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/scan_io.h"
#include "io/session_file.h"
#include "scan/scan_summary.h"
#include "widgets/background.h"

namespace stratascope {

/// A file and how it is to be taken.
struct DeskFile {
  QString path;
  FileFrame frame;                        ///< Auto = as the file says, else guessed
  std::optional<Eigen::Isometry3d> pose;  ///< as --pose; none = what the file says
  std::vector<int> hidden;                ///< which of its scans are left out, from 0, rising
  /// Of the bytes that were read. To open(): what they should be, or empty.
  std::string sha256;

  bool sameReading(const DeskFile& other) const;
  bool operator==(const DeskFile& other) const;
};

/// Files to open; a folder stands for its UOS scans. `poses`: one a file, or none. Errors: a folder without
/// scans.
Expected<std::vector<DeskFile>> deskFiles(const QStringList& paths,
                                          const std::vector<Eigen::Isometry3d>& poses,
                                          const FileFrame& frame);

std::vector<DeskFile> deskFiles(const SessionFile& session);

/// The scans on the table: reads them off the window's thread, keeps what need not be read again. The newest
/// request wins; while one is read the next waits, so that a dragged number costs one reading at a time.
class ScanDesk : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  struct Entry {
    int file = 0;
    int scan = 0;  ///< in the file
    ScanPtr data;
    ScanSummary summary;
    bool hidden = false;
  };
  /// What readers made of a file that nobody had said anything about.
  struct Guess {
    FileFrame frame;  ///< never Auto
    std::vector<std::string> notes;
  };
  enum class Change {
    Opened,  ///< other files
    Frame,   ///< the same files in other units, axes or poses
    Shown,   ///< some were hidden or came back
  };

  void open(std::vector<DeskFile> files);
  /// The same files, taken otherwise; as many, in the same order. Does nothing while others are being opened.
  void change(std::vector<DeskFile> files);
  /// Nothing is open any more, such as when a stream begins; what is being read is left.
  void clear();
  /// Reads all anew.
  void reload();

  bool reading() const { return running_.has_value(); }
  const std::vector<DeskFile>& files() const { return files_; }
  /// As files(), with what is being read or waits.
  const std::vector<DeskFile>& asked() const;
  const std::vector<Entry>& entries() const { return entries_; }
  /// Of a file; none if it was never read without being told.
  const std::optional<Guess>& guess(int file) const { return read_[static_cast<size_t>(file)].guess; }
  /// Those not hidden.
  std::vector<ScanPtr> shown() const;

signals:
  void readingChanged();
  void scansChanged(ScanDesk::Change change);
  /// What was there before stands.
  void failed(const QString& message);
  /// Files that are not what they were when a session was saved.
  void otherContent(const QStringList& paths);

private:
  struct ReadFile {
    DeskFile asked;
    std::vector<ScanPtr> scans;
    std::vector<ScanSummary> summaries;
    std::optional<Eigen::Vector3d> origin;  ///< that it was read with
    std::optional<Guess> guess;
  };
  struct Request {
    std::vector<DeskFile> files;
    Change change = Change::Opened;
    bool anew = false;
  };
  struct Result {
    std::vector<ReadFile> read;
    QStringList other;
    QString error;
  };
  void begin(Request request);
  void take(Result result);
  static Result readAll(const Request& request, const std::vector<ReadFile>& before);

  std::vector<DeskFile> files_;
  std::vector<ReadFile> read_;
  std::vector<Entry> entries_;
  std::optional<Request> running_, next_;
  bool discard_ = false;  ///< what is running is no longer wanted
  Background background_;
};

}  // namespace stratascope
