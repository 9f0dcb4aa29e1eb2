// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stream/lms2xx_telegram.h"
#include "stream/row_source.h"

namespace stratascope {

/// Telegrams of the head that turns the scanner, framed as the scanner's own, address 81h. The scanner's
/// protocol knows nothing of a head, so these are this project's; resources/help/telegrams.md documents them
/// byte by byte.

/// How the receiver finds the direction of a beam.
enum class RayKind : std::uint8_t {
  Head = 0,  ///< from the head elevation of its line and the beam's place on the fan
  Rays = 1,  ///< told beam by beam, for lattices that are no fans
};

/// 53h: a scan begins, or goes on (sent again every few lines for those who missed it).
struct HeadScanStart {
  ScanHeader header;  ///< name at most 255 bytes; format is not sent
  RayKind rays = RayKind::Head;
  RangeFormat range;
  double beamFirstDeg = 0, beamLastDeg = 180;  ///< φ of the first and last column
};

/// 4Ch: the B0h telegrams whose scan index is the low byte of `line` are this line.
struct HeadLine {
  std::uint32_t scan = 0;
  std::uint32_t line = 0;
  double elevationDeg = 0;  ///< of the head as the mirror passes φ = 180° for the first time
  double turnDeg = 0;       ///< change of the elevation in one turn of the mirror; 0 = the head stands
};

/// 52h: points that beams `first`… of a line aim at, scan frame; NaN where a beam has no return.
struct HeadRays {
  std::uint32_t scan = 0;
  std::uint32_t line = 0;
  std::uint16_t first = 0;
  std::vector<Eigen::Vector3f> aims;  ///< at most kMostAims
};
inline constexpr int kMostAims = 66;

/// 45h: no more lines of this scan.
struct HeadScanEnd {
  std::uint32_t scan = 0;
};
/// 4Bh: nothing to send at present, but still there.
struct HeadKeepAlive {};
/// 43h, from the host to the head (address 01h): go on with this scan after a lost connection.
struct HeadContinue {
  std::uint32_t scan = 0;
};

using HeadTelegram =
    std::variant<HeadScanStart, HeadLine, HeadRays, HeadScanEnd, HeadKeepAlive, HeadContinue>;

Bytes headPayload(const HeadTelegram& telegram);
/// None if the payload is none of these, or holds what cannot be (sizes, numbers that are not finite).
std::optional<HeadTelegram> parseHead(std::span<const std::uint8_t> payload);

/// In how many B0h telegrams a line comes: 1, or 2 or 4 interlaced ones if it is longer than one can be.
int partsOfLine(int beams);
inline constexpr int kMostBeams = 4 * kMostValues;
/// More than any scanner has; bounds what a telegram can make a receiver allocate.
inline constexpr int kMostNeurons = 1 << 24;
/// Number of values in a part, and the column of one of them.
int valuesInPart(int beams, int part);
int columnOfValue(int beams, int part, int value);

/// Turns the mirror has made when it comes to a column, of the line's two.
double turnsBefore(const HeadScanStart& scan, int column);
/// Direction of a column for RayKind::Head, unit, sensor frame.
Eigen::Vector3d fanDirection(const HeadScanStart& scan, const HeadLine& line, int column);
/// Where a beam of RayKind::Rays ends: `aim` itself if its range is `range` already (as near as single
/// precision tells), else the point of that range on the way there. All in the scan frame.
Eigen::Vector3f pointTowards(const Eigen::Vector3f& aim, const Eigen::Vector3d& sensor, double range);

}  // namespace stratascope
