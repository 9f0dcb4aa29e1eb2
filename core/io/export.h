// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "io/file_set.h"
#include "io/provenance.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// The files of the command line's contract, as bytes. Each depends on the snapshot alone, so the window and
/// the command line write the same. Numbers in text read back to the same bits, C locale. JSON holds no NaN:
/// what is unknown is null.

/// PCD 0.7, binary, map frame: x y z normal_x normal_y normal_z (F 4), surface_class (U 1), label (U 4), 29
/// bytes a point. WIDTH = beams, HEIGHT = lines; an unordered scan has HEIGHT 1 and every point of its file,
/// in the file's order. VIEWPOINT is the sensor's pose in the map. `provenance`: lines that go into the
/// header as comments.
std::string cloudPcd(const ScanProducts& scan, const Provenance& provenance = {});
/// The same points as binary PLY: x y z nx ny nz (float), surface_class (uchar), label (uint). A scan with a
/// lattice has every neuron, NaN where nothing came back, and obj_info num_cols (beams) and num_rows (lines).
std::string cloudPly(const ScanProducts& scan, const Provenance& provenance = {});

/// A list, one plane a line, scan by scan: label, class (the word), surface_class (the number), role (if it
/// has one), normal, offset, sigma, rms, points, centroid, area, hull, scan (index of its scan).
std::string planesJson(const Snapshot& snapshot);
/// A list, one edge a line, scan by scan: kind, vertical, from, to, points, sigma, scan.
std::string edgesJson(const Snapshot& snapshot);
/// ESRI ASCII grid, northernmost row first.
std::string heightMapAsc(const HeightMap& map);
std::string intervalsCsv(const Snapshot& snapshot);

/// Where everything came from:
///   program, version
///   inputs       list of {name, path, bytes, sha256, format, lattice ("native"|"recovered"|"projected"),
///   lines, beams,
///                missing, points, pose [x, y, z, roll, pitch, yaw] as --pose takes it, sensor [x, y, z],
///                facing_deg (yaw in the map that counts as facing: the sensor's, or the walls' with
///                align_walls), unit and axes the file was read in, local_origin [x, y, z]
///                (Scan::localOrigin), fields, notes}; bytes and sha256 are null for a scan that is no file:
///                an empty path, or one with "://" or that begins with "serial:"
///   parameters   every one, as --params reads them
///   points       laid down in the map
///   counts       {scans, planes, edges, cells (occupied), records}
///   seconds      by stageName(), of each stage's last execution
///   notes        of the segmentation
///   peak_memory_bytes, libraries
///   stream       only if it came as one: `streamCounters`, a JSON object
/// Errors: an input file that can no longer be read.
Expected<std::string> runJson(const Snapshot& snapshot, std::string_view streamCounters = {});

/// The files of the contract and map.strata, by name: what exportResults writes before what is asked for
/// besides. One scan: cloud.pcd. Several: cloud.pcd for the first, cloud_1.pcd … for the others. `run` is
/// runJson().
std::vector<OutputFile> contractFiles(const Snapshot& snapshot, const std::string& run);

/// Writes contractFiles() into `directory` (made if missing), all or nothing: on an error the directory is as
/// it was. Returns the paths written.
Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory,
                                                 std::string_view streamCounters = {});

/// The program's version, "0.1.0".
const char* versionText();

}  // namespace stratascope
