// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/small_files.h"

#include <algorithm>
#include <array>

#include "io/text_lines.h"

namespace stratascope::test {

namespace {

const std::array<std::array<double, 3>, 6> kVertices = {
    {{1.5, 2.25, -0.5}, {1.5, 1, -0.5}, {1.5, 0, -0.5}, {1.5, 2, 0.125}, {1.5, 1, 0.25}, {1.5, 0, 0.75}}};

/// A number in any of PLY's encodings.
class PlyWriter {
public:
  explicit PlyWriter(PlyEncoding encoding) : encoding_(encoding) {}
  std::string body;
  template <class T>
  void put(T value) {
    if (encoding_ == PlyEncoding::Ascii) {
      body += shortestText(static_cast<double>(value)) + " ";
      return;
    }
    std::string bytes = rawBytes(value);
    if (encoding_ == PlyEncoding::BinaryBigEndian) std::reverse(bytes.begin(), bytes.end());
    body += bytes;
  }
  void endRow() {
    if (encoding_ == PlyEncoding::Ascii) body += "\n";
  }
  std::string begin() const {
    const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    return std::string("ply\nformat ") + names[static_cast<int>(encoding_)] + " 1.0\ncomment small\n";
  }

private:
  PlyEncoding encoding_;
};

std::string ptxHead(const std::string& matrix) {
  return "2\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + matrix;
}

}  // namespace

std::string plyFile(PlyEncoding encoding, bool doubles) {
  PlyWriter writer(encoding);
  const std::string real = doubles ? "property double " : "property float ";
  const std::string header = writer.begin() + "element vertex 6\n" + real + "x\n" + real + "y\n" + real +
                             "z\nproperty float nx\nproperty uchar red\nelement face 1\nproperty list uchar "
                             "int vertex_indices\nend_header\n";
  for (const auto& v : kVertices) {
    for (const double c : v) doubles ? writer.put(c) : writer.put(static_cast<float>(c));
    writer.put(0.5F);
    writer.put(std::uint8_t{200});
    writer.endRow();
  }
  writer.put(std::uint8_t{3});
  for (const std::int32_t index : {0, 1, 3}) writer.put(index);
  writer.endRow();
  return header + writer.body;
}

std::string plyRangeGrid(PlyEncoding encoding) {
  PlyWriter writer(encoding);
  std::string header = writer.begin() +
                       "obj_info num_cols 3\nobj_info num_rows 2\nelement vertex 5\nproperty float "
                       "x\nproperty float y\nproperty float z\n" +
                       "element range_grid 6\nproperty list uchar int vertex_indices\nend_header\n";
  for (size_t i = 0; i < 5; ++i) {
    for (const double c : kVertices[i]) writer.put(static_cast<float>(c));
    writer.endRow();
  }
  for (const std::int32_t index : {4, 3, -1, 2, 1, 0}) {
    writer.put(static_cast<std::uint8_t>(index < 0 ? 0 : 1));
    if (index >= 0) writer.put(index);
    writer.endRow();
  }
  return header + writer.body;
}

std::string ptxFile() {
  return ptxHead("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") +
         "1 0 -0.5 0.5\n1 0 0 0.25\n0 0 0 0.5\n1 0.5 -0.5 1\n1 0.5 0 1\n1 0.5 0.5 1\n" +
         ptxHead("0 1 0 0\n-1 0 0 0\n0 0 1 0\n5 6 7 1\n") +
         "2 0 -0.5 0.5\n2 0 0 0.25\n2 0 0.5 0.5\n2 0.5 -0.5 1\n0 0 0 1\n2 0.5 0.5 1\n";
}

std::string ptsFile() {
  return "3\n1.5 2.5 3.5 100 1 2 3\n-1 0 0.125 5 4 5 6\n2 2 2 5 4 5 6\n";
}

std::string polarFile() {
  std::string text =
      "# polar scan\n# head_elevation_first 10\n# head_elevation_step -10\n# beam_first 0\n# beam_step 60\n# "
      "readings 11\nline,beam,range,intensity\n";
  for (int line = 0; line < 3; ++line)
    for (int beam = 0; beam < 4; ++beam) {
      if (line == 2 && beam == 1) continue;
      text += std::to_string(line) + "," + std::to_string(beam) + "," +
              (line == 0 && beam == 2 ? "0" : "2.5") + ",7\n";
    }
  return text;
}

std::string scanGraphFile() {
  return "# scans\nNODE 1 2 3 0 0 0\n1 0 0\n1.5 1 0\n1 -1 0.25\nNODE 0 0 0 0 0 1.5707963267948966\n2 0 0\n2 "
         "0.5 0\n";
}

std::string lasFile(const LasOptions& options) {
  constexpr std::array<unsigned, 11> kPointBytes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const unsigned pointBytes = kPointBytes[static_cast<size_t>(options.format)];
  const size_t headerBytes = options.minor == 4 ? 375 : options.minor == 3 ? 235 : 227;
  std::string header(headerBytes, '\0');
  const auto put = [&](size_t at, const std::string& bytes) { header.replace(at, bytes.size(), bytes); };
  std::string record;
  if (options.record) {
    record = std::string(54, '\0');
    record.replace(2, 15, "LASF_Projection");
    record.replace(18, 2, rawBytes(std::uint16_t{34735}));
    record.replace(20, 2, rawBytes(std::uint16_t{16}));
    for (const std::uint16_t v : {1, 1, 0, 1, 3076, 0, 1, 9001}) record += rawBytes(v);
  }
  put(0, "LASF");
  header[24] = 1;
  header[25] = static_cast<char>(options.minor);
  put(94, rawBytes(static_cast<std::uint16_t>(headerBytes)));
  put(96, rawBytes(static_cast<std::uint32_t>(headerBytes + record.size())));
  put(100, rawBytes(std::uint32_t{options.record}));
  header[104] = static_cast<char>(options.format);
  put(105, rawBytes(static_cast<std::uint16_t>(pointBytes)));
  put(107, rawBytes(std::uint32_t{options.minor == 4 ? 0u : 4u}));
  for (size_t axis = 0; axis < 3; ++axis)
    put(131 + 8 * axis, rawBytes(options.scale)), put(155 + 8 * axis, rawBytes(options.offset));
  std::string points;
  for (std::int32_t i = 0; i < 4; ++i) {
    std::string point(pointBytes, '\0');
    const std::array<std::int32_t, 3> xyz = {100 + i, 200 - 50 * i, -30 * i};
    for (size_t axis = 0; axis < 3; ++axis) point.replace(4 * axis, 4, rawBytes(xyz[axis]));
    if (i == 2) point[15] = static_cast<char>(options.format < 6 ? 0x80 : 0x04);
    points += point;
  }
  std::string extended;
  if (options.minor == 4) {
    put(247, rawBytes(std::uint64_t{4}));
    if (options.extendedRecord) {
      put(235, rawBytes(static_cast<std::uint64_t>(headerBytes + record.size() + points.size())));
      put(243, rawBytes(std::uint32_t{1}));
      extended = std::string(60, '\0');
      extended.replace(2, 4, "test");
      extended.replace(20, 8, rawBytes(std::uint64_t{5}));
      extended += "hello";
    }
  }
  return header + record + points + extended;
}

std::string e57File(const E57Options& options) {
  std::string logical =
      "ASTM-E57" + rawBytes(std::uint32_t{1}) + rawBytes(std::uint32_t{0}) + std::string(32, '\0');
  // column, row, x, y, z in mm and a state for each of six points
  constexpr std::array<std::array<std::int32_t, 6>, 6> kRecords = {{{0, 0, 2000, 100, -500, 0},
                                                                    {0, 2, 2000, 100, 500, 0},
                                                                    {1, 1, 2000, 0, 0, 0},
                                                                    {1, 2, 2000, 0, 500, 2},
                                                                    {2, 0, 2000, -100, -500, 0},
                                                                    {2, 1, 2000, -100, 0, 0}}};
  std::string x, y, z;
  std::uint32_t columns = 0, rows = 0, states = 0;
  for (size_t i = 0; i < kRecords.size(); ++i) {
    const auto& r = kRecords[i];
    constexpr std::int32_t kMinimum = -8388608;
    const auto three = [&](std::int32_t v) { return rawBytes(v - kMinimum).substr(0, 3); };
    x += three(r[2]), y += three(r[3]), z += three(r[4]);
    columns |= static_cast<std::uint32_t>(r[0]) << (2 * i);
    rows |= static_cast<std::uint32_t>(r[1]) << (2 * i);
    states |= static_cast<std::uint32_t>(r[5]) << (2 * i);
  }
  const std::array streams = {
      x, y, z, rawBytes(rows).substr(0, 2), rawBytes(columns).substr(0, 2), rawBytes(states).substr(0, 2)};
  std::string packet;
  for (const std::string& s : streams) packet += rawBytes(static_cast<std::uint16_t>(s.size()));
  for (const std::string& s : streams) packet += s;
  packet.resize((packet.size() + 6 + 3) / 4 * 4 - 6);
  packet = std::string("\1\0", 2) + rawBytes(static_cast<std::uint16_t>(packet.size() + 5)) +
           rawBytes(static_cast<std::uint16_t>(streams.size())) + packet;
  logical += std::string("\1\0\0\0\0\0\0\0", 8) + rawBytes(std::uint64_t{32 + packet.size()}) +
             rawBytes(std::uint64_t{80}) + rawBytes(std::uint64_t{0}) + packet;
  const std::string coordinate =
      R"( type="ScaledInteger" minimum="-8388608" maximum="8388607" scale="0.001"/>)";
  const std::string prototype =
      options.prototype.empty()
          ? "<cartesianX" + coordinate + "<cartesianY" + coordinate + "<cartesianZ" + coordinate +
                R"(<rowIndex type="Integer" minimum="0" maximum="3"/><columnIndex type="Integer" minimum="0" maximum="3"/>)" +
                R"(<cartesianInvalidState type="Integer" minimum="0" maximum="2"/>)"
          : options.prototype;
  std::string xml = R"(<?xml version="1.0" encoding="UTF-8"?>)" + options.xmlPrefix +
                    R"(<e57Root type="Structure"><data3D type="Vector">)";
  for (int i = 0; i < options.times; ++i)
    xml += R"(<vectorChild type="Structure">)" + options.pose + options.bounds + "<points " +
           options.pointsAttributes + R"(><prototype type="Structure">)" + prototype +
           R"(</prototype><codecs type="Vector">)" + options.codecs + "</codecs></points></vectorChild>";
  xml += "</data3D></e57Root>";
  const std::uint64_t xmlAt = logical.size();
  logical += xml;
  std::string file = e57FromLogical(logical, xmlAt, xml.size());
  if (!options.checksums) file[1020] = static_cast<char>(file[1020] ^ 1);
  return file;
}

}  // namespace stratascope::test
