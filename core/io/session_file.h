// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/file_frame.h"
#include "params/pipeline_params.h"

namespace stratascope {

struct SessionInput {
  std::string path;  ///< as a program opens it: absolute, or relative to where it runs
  std::string
      sha256;  ///< of the file when the session was saved; "" = not known, any file of that name will do
  /// x, y, z, roll, pitch, yaw as --pose takes them (m, degrees); none = what the file says.
  std::optional<std::array<double, 6>> pose;
  FileFrame frame = {};
  /// Which of its scans, from 0, are left out of the map.
  std::vector<int> hidden = {};
};

/// What was being done: enough to compute it again, and to show it as it was.
///
/// A `.stratascope` file is a JSON object:
///   program     "stratascope"
///   version     of the program that wrote it
///   session     1, the version of this format
///   inputs      list of {path, sha256 (or null), pose (six numbers, or null), units, axes (the words
///               of --units and --axes), hidden (numbers of scans, rising)}; all but path can be left out. A
///               path below the session's folder is relative to it, so that both can be moved together
///   parameters  as in --params
///   window      anything: see below
/// Other keys are errors, as is a key given twice.
///
/// The window stores its part (camera, layout, selections, colours) in `window`: one JSON object as text,
/// which core checks to be one, keeps and never looks into. It should carry a version number of its own, be
/// read with a default for what is missing, and never change what is computed: the command line leaves it
/// unread. To save: fill a SessionFile (sessionInput() for each scan), set `window`, call writeSession(). To
/// open: readSession(), checkInputs() to say what has changed, open the inputs with their poses, apply
/// params, then `window`.
struct SessionFile {
  std::vector<SessionInput> inputs;
  PipelineParams params;
  std::string window = "{}";
};

/// The input with the SHA-256 of its file. Errors: it cannot be read.
Expected<SessionInput> sessionInput(const std::string& path,
                                    const std::optional<std::array<double, 6>>& pose = {});
/// The six numbers of a pose, to 1e-9: those it was made from, if they had no more digits and pitch is within
/// 90°.
std::array<double, 6> poseNumbers(const Eigen::Isometry3d& pose);
/// Six numbers as --pose and poseFromText() take them.
std::string poseText(const std::array<double, 6>& numbers);
/// As ReadOptions takes it; nothing for an input without a pose.
std::optional<Eigen::Isometry3d> sessionPose(const SessionInput& input);

/// What is written to `path`. Errors: an input's name that is no UTF-8, `window` that is no JSON object, a
/// pose that cannot be.
Expected<std::string> sessionJson(const SessionFile& session, const std::string& path);
/// Strict; errors name `path`, key and remedy.
Expected<SessionFile> sessionFromJson(const std::string& text, const std::string& path);

/// Replaces the file only when the new one is complete.
Status writeSession(const SessionFile& session, const std::string& path);
Expected<SessionFile> readSession(const std::string& path);
/// An error for the first input that is gone, or another file than when the session was saved.
Status checkInputs(const SessionFile& session);

}  // namespace stratascope
