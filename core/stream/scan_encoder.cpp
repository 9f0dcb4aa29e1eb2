// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/scan_encoder.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/units.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"

namespace stratascope {
namespace {

constexpr int kStartEvery = 32;
constexpr double kNone = 0;  // rounded range of a missing return

Eigen::Vector3d sensorOf(const Scan& scan) {
  return scan.pose.scan_T_sensor.translation();
}

/// Range in whole units of the format; kNone if it cannot be told.
double roundedUnits(const Scan& scan, const RangeFormat& format, const Eigen::Vector3f& point) {
  const double range = (point.cast<double>() - sensorOf(scan)).norm();
  if (!std::isfinite(range)) return kNone;
  const double units = std::round(range * format.unitsPerMetre());
  return units < format.tooFar() ? units : kNone;
}

/// The narrowest format that holds every return, else the one that reaches farthest.
RangeFormat formatFor(const Scan& scan) {
  double longest = 0;
  for (const Eigen::Vector3f& p : scan.lattice->points().values())
    if (p.allFinite()) longest = std::max(longest, (p.cast<double>() - sensorOf(scan)).norm());
  for (const int bits : {13, 14, 15}) {
    const RangeFormat format{bits, RangeUnit::Millimetre};
    if (std::round(longest * format.unitsPerMetre()) < format.tooFar()) return format;
  }
  return {13, RangeUnit::Centimetre};
}

Eigen::Vector3f quantised(const Scan& scan, const RangeFormat& format, const Eigen::Vector3f& point) {
  const double units = roundedUnits(scan, format, point);
  if (units == kNone) return Eigen::Vector3f::Constant(kNaNf);
  return pointTowards(point, sensorOf(scan), units / format.unitsPerMetre());
}

/// Least squares of v over u.
class Regression {
public:
  void add(double u, double v) { n_ += 1, u_ += u, v_ += v, uu_ += u * u, uv_ += u * v; }
  /// Value at u, to the ten-thousandth: people set up scanners in round numbers. NaN if u never varied.
  double roundedAt(double u) const {
    const double slope = (n_ * uv_ - u_ * v_) / (n_ * uu_ - u_ * u_);
    return std::round(((v_ - slope * u_) / n_ + slope * u) * 1e4) / 1e4;
  }

private:
  double n_ = 0, u_ = 0, v_ = 0, uu_ = 0, uv_ = 0;
};

bool sameBits(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  for (int c = 0; c < 3; ++c)
    if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
  return true;
}

}  // namespace

Expected<ScanEncoder> ScanEncoder::make(ScanPtr scan) {
  require(scan && scan->lattice, "ScanEncoder: no scan");
  const ScanLattice& lattice = *scan->lattice;
  if (scan->unordered())
    return Error{scan->path, "", "the cloud has no scan lines, so no scanner could have sent it",
                 "give a scan with a lattice"};
  if (lattice.beams() > kMostBeams || lattice.lines() > kMostNeurons / std::max(1, lattice.beams()))
    return Error{scan->path, "",
                 "a lattice of " + std::to_string(lattice.lines()) + " lines x " +
                     std::to_string(lattice.beams()) + " beams does not fit into the telegrams",
                 "give one of at most " + std::to_string(kMostBeams) + " beams"};
  ScanEncoder e;
  e.scan_ = scan;
  e.start_.header = {.lines = lattice.lines(),
                     .beams = lattice.beams(),
                     .name = scan->name,
                     .pose = scan->pose,
                     .ownBodyRange = scan->ownBodyRange};
  e.start_.range = formatFor(*scan);

  // The angles as a regular fan on a regular head would have them, from the points.
  const Eigen::Isometry3d sensor_T_scan = scan->pose.scan_T_sensor.inverse();
  const auto polarAt = [&](GridIndex i) {
    return polarFromPoint(sensor_T_scan * lattice.points()(i).cast<double>());
  };
  constexpr double kNearAxis = 0.1;  // there the head angle is hardly seen
  Regression fan;
  for (GridIndex i; i.row < lattice.lines(); ++i.row)
    for (i.col = 0; i.col < lattice.beams(); ++i.col)
      if (lattice.points()(i).allFinite()) fan.add(i.col, radToDeg(polarAt(i).beamAngle));
  e.start_.beamFirstDeg = fan.roundedAt(0);
  e.start_.beamLastDeg = fan.roundedAt(lattice.beams() - 1);

  const auto isFan = [&](bool headTurns) {
    if (!std::isfinite(e.start_.beamFirstDeg) || !std::isfinite(e.start_.beamLastDeg)) return false;
    e.headTurns_ = headTurns;
    std::vector<double> turns(static_cast<size_t>(lattice.beams()), 0.0);
    if (headTurns)
      for (int j = 0; j < lattice.beams(); ++j) turns[static_cast<size_t>(j)] = turnsBefore(e.start_, j);
    Regression head;
    for (GridIndex i; i.row < lattice.lines(); ++i.row)
      for (i.col = 0; i.col < lattice.beams(); ++i.col) {
        if (!lattice.points()(i).allFinite()) continue;
        const PolarReading at = polarAt(i);
        if (std::sin(at.beamAngle) > kNearAxis)
          head.add(i.row + turns[static_cast<size_t>(i.col)] / 2,
                   radToDeg(elevationFromHeadAngle(at.headAngle)));
      }
    e.elevationFirstDeg_ = head.roundedAt(0);
    e.elevationLastDeg_ = head.roundedAt(lattice.lines() - 1);
    if (!std::isfinite(e.elevationFirstDeg_) || !std::isfinite(e.elevationLastDeg_)) return false;
    const Eigen::Vector3d sensor = sensorOf(*scan);
    for (GridIndex i; i.row < lattice.lines(); ++i.row) {
      const HeadLine line = e.headOf(i.row);
      for (i.col = 0; i.col < lattice.beams(); ++i.col) {
        const Eigen::Vector3f wanted = quantised(*scan, e.start_.range, lattice.points()(i));
        if (!wanted.allFinite()) continue;
        const double range =
            roundedUnits(*scan, e.start_.range, lattice.points()(i)) / e.start_.range.unitsPerMetre();
        const Eigen::Vector3d ray = scan->pose.scan_T_sensor.linear() * fanDirection(e.start_, line, i.col);
        if (!sameBits((sensor + range * ray).cast<float>(), wanted)) return false;
      }
    }
    return true;
  };
  if (!isFan(false) && !isFan(true)) {
    e.start_.rays = RayKind::Rays;
    e.headTurns_ = false;
    e.elevationFirstDeg_ = e.elevationLastDeg_ = 0;
    e.start_.beamFirstDeg = e.start_.beamLastDeg = 0;
  }
  return e;
}

HeadLine ScanEncoder::headOf(int line) const {
  const int lines = start_.header.lines;
  const double span = elevationLastDeg_ - elevationFirstDeg_;
  return {.scan = start_.header.number,
          .line = static_cast<std::uint32_t>(line),
          .elevationDeg = lines > 1 ? elevationFirstDeg_ + span * line / (lines - 1) : elevationFirstDeg_,
          .turnDeg = headTurns_ && lines > 1 ? span / (lines - 1) / 2 : 0};
}

std::uint16_t ScanEncoder::valueAt(GridIndex neuron) const {
  const double units = roundedUnits(*scan_, start_.range, scan_->lattice->points()(neuron));
  return units == kNone ? start_.range.tooFar() : static_cast<std::uint16_t>(units);
}

Bytes ScanEncoder::startBytes() const {
  Bytes bytes;
  appendTelegram(bytes, kFromDevice | kHeadAddress, headPayload(start_));
  return bytes;
}

Bytes ScanEncoder::lineBytes(int line) {
  Bytes bytes;
  if (line % kStartEvery == 0) bytes = startBytes();
  const auto fromHead = [&](const HeadTelegram& t) {
    appendTelegram(bytes, kFromDevice | kHeadAddress, headPayload(t));
  };
  const HeadLine head = headOf(line);
  fromHead(head);
  const int beams = start_.header.beams;
  if (start_.rays == RayKind::Rays) {
    const auto row = scan_->lattice->points().row(line);
    for (int first = 0; first < beams; first += kMostAims) {
      const int count = std::min(kMostAims, beams - first);
      fromHead(HeadRays{head.scan,
                        head.line,
                        static_cast<std::uint16_t>(first),
                        {row.begin() + first, row.begin() + first + count}});
    }
  }
  const int parts = partsOfLine(beams);
  for (int part = 0; part < parts; ++part) {
    RangeTelegram ranges;
    ranges.unit = start_.range.unit;
    if (parts > 1) ranges.part = part * (4 / parts);
    for (int i = 0; i < valuesInPart(beams, part); ++i)
      ranges.values.push_back(valueAt({line, columnOfValue(beams, part, i)}));
    ranges.indices = {static_cast<std::uint8_t>(line), telegram_++};
    appendTelegram(bytes, kFromDevice | kScannerAddress, rangePayload(ranges));
  }
  return bytes;
}

Bytes ScanEncoder::endBytes() const {
  Bytes bytes;
  appendTelegram(bytes, kFromDevice | kHeadAddress, headPayload(HeadScanEnd{start_.header.number}));
  return bytes;
}

Expected<Scan> quantisedAsTelegrams(const Scan& scan) {
  const auto encoder = ScanEncoder::make(std::make_shared<const Scan>(scan));
  if (!encoder) return encoder.error();
  Scan result = scan;
  ScanBuilder builder(scan.lattice->beams());
  for (int line = 0; line < scan.lattice->lines(); ++line) {
    std::vector<Eigen::Vector3f> points;
    for (const Eigen::Vector3f& p : scan.lattice->points().row(line))
      points.push_back(quantised(scan, encoder->start().range, p));
    builder.appendLine(points);
  }
  result.lattice = builder.freeze();
  return result;
}

}  // namespace stratascope
