// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/file_frame.h"
#include "scan/scan_lattice.h"

namespace stratascope {

struct ReadOptions {
  /// The sensor's pose in the map, `--pose`: the file's points are in the sensor's own frame and are moved by
  /// it. Replaces a pose the file brings along. Without it a file's coordinates are the map frame (a UOS
  /// .pose file moves its scan).
  std::optional<Eigen::Isometry3d> pose;
  /// Unit and axes of the file's coordinates; Auto = what the format or the file says, else metres with z up
  /// unless the data speak clearly for something else (io/frame_guess.h). A note says what was guessed.
  FileFrame frame = {};
  /// The local origin to count map coordinates from, so that several scans share one; none = the scan's own
  /// (Scan::localOrigin).
  std::optional<Eigen::Vector3d> localOrigin = {};
};

/// Every scan of a file, in the file's order (PTX, E57 and scan graphs hold several), all with the first
/// one's local origin.
Expected<std::vector<Scan>> readAllScans(const std::string& path, const ReadOptions& options = {});
Expected<std::vector<Scan>> readAllScanBytes(const std::string& path, std::string bytes,
                                             const ReadOptions& options = {});

/// Reads one scan of any supported format, told by content first, then by extension. Regular files only;
/// memory bounded by the file's size. Locale-independent. A cloud without a lattice comes back Projected,
/// with a note; of a file of several scans the first comes back, with a note.
Expected<Scan> readScan(const std::string& path, const ReadOptions& options = {});
/// The same for a file's bytes already at hand; `path` gives name and extension (and where a .pose file may
/// lie).
Expected<Scan> readScanBytes(const std::string& path, std::string bytes, const ReadOptions& options = {});

/// Of formats that have both.
enum class ScanEncoding : std::uint8_t { Binary, Ascii };

/// Writes a scan's points in the map frame (bit for bit as they stand where map_T_scan is the identity), so
/// that the file read back lies where the scan lay; a local origin is added again, in doubles. By the
/// extension: .pcd (lattice, or the unordered cloud in its order, and map_T_sensor as VIEWPOINT), .ply (the
/// same, with num_cols and num_rows and the sensor as PCL's camera), .xyz/.txt (x y z a line), .csv (x,y,z a
/// line); text leaves missing returns out and has no lattice. The file is replaced only when the new one is
/// complete.
Status writeScan(const Scan& scan, const std::string& path, ScanEncoding encoding = ScanEncoding::Binary);
/// What writeScan would write to `path`.
Expected<std::string> scanBytes(const Scan& scan, const std::string& path,
                                ScanEncoding encoding = ScanEncoding::Binary);

/// "PCD (*.pcd)", … for file dialogs and help.
struct FormatInfo {
  const char* name;
  std::vector<const char*> extensions;  ///< with the dot
  bool canWrite;
};
const std::vector<FormatInfo>& scanFormats();

/// Pose from "x,y,z,roll,pitch,yaw" (metres, degrees; R = Rz(yaw) Ry(pitch) Rx(roll)).
Expected<Eigen::Isometry3d> poseFromText(const std::string& text);

}  // namespace stratascope
