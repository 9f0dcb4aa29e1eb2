// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/ply_header.h"

namespace stratascope::test {

/// Small valid files of the formats the program reads, made byte by byte so that tests need no writer to
/// trust.

/// 2 × 3 vertices with a normal, a colour and a doubled precision if asked; then one face.
std::string plyFile(PlyEncoding encoding, bool doubles = false);
/// A range grid of 3 columns and 2 rows with one empty place.
std::string plyRangeGrid(PlyEncoding encoding);
/// Two scans of 2 columns × 3 rows, the second turned and moved; one missing return each.
std::string ptxFile();
std::string ptsFile();
/// 3 lines × 4 beams; one missing return, one place without a row.
std::string polarFile();
/// Two nodes of three and two points.
std::string scanGraphFile();

struct LasOptions {
  int minor = 2;
  int format = 3;
  double scale = 0.01;
  double offset = 0;
  bool record = true;           ///< a GeoTIFF record that says: metres
  bool extendedRecord = false;  ///< one after the points, 1.4 only
};
/// Four points, the third withheld.
std::string lasFile(const LasOptions& options = {});

/// The pieces of an E57 file, to be put together right or wrong.
struct E57Options {
  std::string xmlPrefix = {};  ///< goes before the root element
  std::string pointsAttributes = R"(type="CompressedVector" fileOffset="48" recordCount="6")";
  std::string prototype = {};  ///< empty = the usual one
  std::string codecs = {};
  std::string pose =
      R"(<pose type="Structure"><rotation type="Structure"><w type="Float">1</w></rotation><translation type="Structure"><x type="Float">1</x><y type="Float">2</y></translation></pose>)";
  std::string bounds =
      R"(<indexBounds type="Structure"><rowMaximum type="Integer">2</rowMaximum><columnMaximum type="Integer">2</columnMaximum></indexBounds>)";
  bool checksums = true;
  int times = 1;  ///< how often the scan is named
};
/// One scan of six points in a lattice of 3 columns × 3 rows, one marked invalid; scaled integers of 24 bits.
std::string e57File(const E57Options& options = {});
/// Pages and checksums around logical bytes whose header is in place; the header's sizes are set.
std::string e57FromLogical(std::string logical, std::uint64_t xmlAt, std::uint64_t xmlLength);

/// The file with every page's checksum made right.
std::string withChecksums(std::string file);

/// The bytes of a value, as they lie in memory.
template <class T>
std::string rawBytes(const T& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace stratascope::test
