// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "pipeline/compare_snapshots.h"
#include "widgets/background.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// What is drawn when two results are looked at together.
enum class CompareMode { Present, SideBySide, Wipe, Differences };
inline constexpr int kCompareModes = 4;
QString compareModeName(CompareMode mode);

/// A result that was kept (A) against the present one (B): numbers and pictures, made off the window's
/// thread. One job at a time; of the requests that came meanwhile the newest wins.
class Comparer : public QObject {
  Q_OBJECT
public:
  struct Result {
    ViewGeometryPtr a;  ///< as B is shown: same cut, scales and colours
    ViewGeometryPtr b;
    ViewGeometryPtr difference;  ///< only in CompareMode::Differences
    std::shared_ptr<const SnapshotComparison> comparison;
  };
  using QObject::QObject;

  /// nullptr drops it.
  void setA(const ViewGeometryPtr& a);
  void setB(const ViewGeometryPtr& b);
  void setMode(CompareMode mode);

  const ViewGeometryPtr& a() const { return a_; }
  CompareMode mode() const { return mode_; }
  /// Of the newest job that ended; empty without A.
  const Result& result() const { return result_; }
  bool busy() const { return running_ || wanted_; }

signals:
  void changed();
  void failed(const QString& message);

private:
  void request();
  void start();

  ViewGeometryPtr a_, b_;
  CompareMode mode_ = CompareMode::Present;
  Result result_;
  bool running_ = false, wanted_ = false;
  Background background_;
};

}  // namespace stratascope
