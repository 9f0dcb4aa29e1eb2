// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/head_telegram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "scan/scanner_geometry.h"

namespace stratascope {
namespace {

enum Command : std::uint8_t {
  kStart = 'S',
  kLine = 'L',
  kRays = 'R',
  kEnd = 'E',
  kAlive = 'K',
  kContinue = 'C'
};
constexpr std::uint8_t kVersion = 1;
constexpr size_t kLongestName = 255;

void putPose(ByteWriter& writer, const Eigen::Isometry3d& pose) {
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 4; ++col) writer.put(double{pose(row, col)});
}

bool getPose(ByteReader& reader, Eigen::Isometry3d& pose) {
  pose.setIdentity();
  bool finite = true;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 4; ++col) {
      pose(row, col) = reader.get<double>();
      finite = finite && std::isfinite(pose(row, col)) && std::abs(pose(row, col)) < 1e9;
    }
  constexpr double kOrthonormal = 1e-6;
  return finite &&
         (pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm() < kOrthonormal;
}

struct Writer {
  ByteWriter out;
  Bytes& bytes;

  void operator()(const HeadScanStart& t) {
    out.put(std::uint8_t{kStart});
    out.put(kVersion);
    out.put(t.header.number);
    out.put(static_cast<std::uint32_t>(t.header.lines));
    out.put(static_cast<std::uint16_t>(t.header.beams));
    out.put(static_cast<std::uint8_t>(t.rays));
    out.put(static_cast<std::uint8_t>(t.range.bits));
    out.put(static_cast<std::uint8_t>(t.range.unit));
    out.put(t.beamFirstDeg);
    out.put(t.beamLastDeg);
    out.put(t.header.ownBodyRange);
    putPose(out, t.header.pose.map_T_scan);
    putPose(out, t.header.pose.scan_T_sensor);
    const size_t length = std::min(t.header.name.size(), kLongestName);
    bytes.insert(bytes.end(), t.header.name.begin(),
                 t.header.name.begin() + static_cast<std::ptrdiff_t>(length));
  }
  void operator()(const HeadLine& t) {
    out.put(std::uint8_t{kLine});
    out.put(t.scan);
    out.put(t.line);
    out.put(t.elevationDeg);
    out.put(t.turnDeg);
  }
  void operator()(const HeadRays& t) {
    require(!t.aims.empty() && t.aims.size() <= static_cast<size_t>(kMostAims), "headPayload: 1 to 66 aims");
    out.put(std::uint8_t{kRays});
    out.put(t.scan);
    out.put(t.line);
    out.put(t.first);
    for (const Eigen::Vector3f& aim : t.aims)
      for (int c = 0; c < 3; ++c) out.put(float{aim[c]});
  }
  void operator()(const HeadScanEnd& t) {
    out.put(std::uint8_t{kEnd});
    out.put(t.scan);
  }
  void operator()(const HeadKeepAlive&) { out.put(std::uint8_t{kAlive}); }
  void operator()(const HeadContinue& t) {
    out.put(std::uint8_t{kContinue});
    out.put(t.scan);
  }
};

std::optional<HeadTelegram> parseStart(ByteReader& reader) {
  HeadScanStart t;
  const auto version = reader.get<std::uint8_t>();
  t.header.number = reader.get<std::uint32_t>();
  const auto lines = reader.get<std::uint32_t>();
  t.header.beams = reader.get<std::uint16_t>();
  const auto rays = reader.get<std::uint8_t>();
  t.range.bits = reader.get<std::uint8_t>();
  const auto unit = reader.get<std::uint8_t>();
  t.beamFirstDeg = reader.get<double>();
  t.beamLastDeg = reader.get<double>();
  t.header.ownBodyRange = reader.get<double>();
  const bool poses =
      getPose(reader, t.header.pose.map_T_scan) && getPose(reader, t.header.pose.scan_T_sensor);
  const bool sizes = t.header.beams > 0 && t.header.beams <= kMostBeams &&
                     lines <= static_cast<std::uint32_t>(kMostNeurons / t.header.beams);
  const bool numbers = std::isfinite(t.beamFirstDeg) && std::isfinite(t.beamLastDeg) &&
                       t.header.ownBodyRange >= 0 && std::isfinite(t.header.ownBodyRange);
  const bool kinds =
      version == kVersion && rays <= 1 && unit <= 1 && t.range.bits >= 13 && t.range.bits <= 15;
  if (!reader.ok() || !poses || !sizes || !numbers || !kinds || reader.left() > kLongestName)
    return std::nullopt;
  t.header.lines = static_cast<int>(lines);
  t.rays = static_cast<RayKind>(rays);
  t.range.unit = static_cast<RangeUnit>(unit);
  while (reader.left() > 0) t.header.name += static_cast<char>(reader.get<std::uint8_t>());
  return t;
}

std::optional<HeadTelegram> parseRays(ByteReader& reader) {
  HeadRays t;
  t.scan = reader.get<std::uint32_t>();
  t.line = reader.get<std::uint32_t>();
  t.first = reader.get<std::uint16_t>();
  constexpr size_t kAim = 3 * sizeof(float);
  if (!reader.ok() || reader.left() == 0 || reader.left() % kAim != 0) return std::nullopt;
  t.aims.resize(reader.left() / kAim);
  for (Eigen::Vector3f& aim : t.aims)
    for (int c = 0; c < 3; ++c) aim[c] = reader.get<float>();
  return t;
}

std::optional<HeadTelegram> parseLine(ByteReader& reader) {
  HeadLine t;
  t.scan = reader.get<std::uint32_t>();
  t.line = reader.get<std::uint32_t>();
  t.elevationDeg = reader.get<double>();
  t.turnDeg = reader.get<double>();
  const bool finite = std::isfinite(t.elevationDeg) && std::isfinite(t.turnDeg);
  if (!finite || !reader.ok() || reader.left() != 0) return std::nullopt;
  return t;
}

template <class T>
std::optional<HeadTelegram> parseNumber(ByteReader& reader) {
  const T t{reader.get<std::uint32_t>()};
  if (!reader.ok() || reader.left() != 0) return std::nullopt;
  return t;
}

double between(double first, double last, double steps, int count) {
  return count > 1 ? first + (last - first) * steps / (count - 1) : first;
}

double beamAngle(const HeadScanStart& scan, int column) {
  return degToRad(between(scan.beamFirstDeg, scan.beamLastDeg, column, scan.header.beams));
}

}  // namespace

Bytes headPayload(const HeadTelegram& telegram) {
  Bytes bytes;
  std::visit(Writer{ByteWriter(bytes), bytes}, telegram);
  return bytes;
}

std::optional<HeadTelegram> parseHead(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  switch (reader.get<std::uint8_t>()) {
    case kStart:
      return parseStart(reader);
    case kRays:
      return parseRays(reader);
    case kLine:
      return parseLine(reader);
    case kEnd:
      return parseNumber<HeadScanEnd>(reader);
    case kContinue:
      return parseNumber<HeadContinue>(reader);
    case kAlive:
      if (payload.size() == 1) return HeadKeepAlive{};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

int partsOfLine(int beams) {
  require(beams > 0 && beams <= kMostBeams, "partsOfLine: 1 to 1616 beams");
  return beams <= kMostValues ? 1 : beams <= 2 * kMostValues ? 2 : 4;
}

int valuesInPart(int beams, int part) {
  const int parts = partsOfLine(beams);
  return (beams - part + parts - 1) / parts;
}

int columnOfValue(int beams, int part, int value) {
  return beams - 1 - (value * partsOfLine(beams) + part);
}

double turnsBefore(const HeadScanStart& scan, int column) {
  // The mirror turns from right to left; odd beams, half a step aside, come with the second turn.
  const int fromRight = scan.header.beams - 1 - column;
  return (kPi - beamAngle(scan, column)) / (2 * kPi) + fromRight % 2;
}

Eigen::Vector3d fanDirection(const HeadScanStart& scan, const HeadLine& line, int column) {
  double elevation = line.elevationDeg;
  if (line.turnDeg != 0) elevation += line.turnDeg * turnsBefore(scan, column);
  return pointFromPolar({1, headAngleFromElevation(degToRad(elevation)), beamAngle(scan, column)});
}

Eigen::Vector3f pointTowards(const Eigen::Vector3f& aim, const Eigen::Vector3d& sensor, double range) {
  const Eigen::Vector3d ray = aim.cast<double>() - sensor;
  const double length = ray.norm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(range))
    return Eigen::Vector3f::Constant(kNaNf);
  const double largest = std::max<double>(aim.cwiseAbs().maxCoeff(), sensor.cwiseAbs().maxCoeff());
  constexpr double kRoundings = 4 * std::numeric_limits<float>::epsilon();
  if (std::abs(length - range) <= kRoundings * largest) return aim;
  return (sensor + ray * (range / length)).cast<float>();
}

}  // namespace stratascope
