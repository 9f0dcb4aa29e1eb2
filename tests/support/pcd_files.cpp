// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/pcd_files.h"

namespace stratascope::test {

std::string header(int width, int height, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F "
         "F\nCOUNT 1 1 1\nWIDTH " +
         std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(width * height) + "\nDATA " + data + "\n";
}

/// LZF that stores everything as literal runs.
std::string packLiterally(const std::string& bytes) {
  std::string packed;
  for (size_t i = 0; i < bytes.size(); i += 32) {
    const std::string run = bytes.substr(i, 32);
    packed += static_cast<char>(run.size() - 1) + run;
  }
  return packed;
}

std::string compressedBody(const std::string& packed, size_t size) {
  return bytesOf(static_cast<std::uint32_t>(packed.size())) + bytesOf(static_cast<std::uint32_t>(size)) +
         packed;
}

const std::vector<Eigen::Vector3f> kPoints = {{1.5F, 2.25F, -0.5F}, {1.5F, 1, -0.5F}, {1.5F, 0, -0.5F},
                                              {1.5F, 2, 0.125F},    {1.5F, 1, 0.25F}, {1.5F, 0, 0.75F}};

std::string asciiFile() {
  return header(3, 2, "ascii") +
         "1.5 2.25 -0.5\n1.5 1 -0.5\n1.5 0 -0.5\n1.5 2 0.125\n1.5 1 0.25\n1.5 0 0.75\n";
}
std::string binaryFile() {
  std::string bytes = header(3, 2, "binary");
  for (const Eigen::Vector3f& p : kPoints) bytes += bytesOf(p.x()) + bytesOf(p.y()) + bytesOf(p.z());
  return bytes;
}
std::string planesOf(const std::vector<Eigen::Vector3f>& points) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& p : points) bytes += bytesOf(p[axis]);
  return bytes;
}
std::string compressedFile() {
  const std::string planes = planesOf(kPoints);
  return header(3, 2, "binary_compressed") + compressedBody(packLiterally(planes), planes.size());
}

std::vector<HostileFile> hostilePcds() {
  const std::string a = asciiFile();
  const std::string b = binaryFile();
  const std::string c = compressedFile();
  const std::string planes = planesOf(kPoints);
  const std::string ch = header(3, 2, "binary_compressed");
  std::vector<HostileFile> files = {
      {"empty", ""},
      {"one NUL", std::string(1, '\0')},
      {"only NULs", std::string(100000, '\0')},
      {"byte-order mark", "\xEF\xBB\xBF" + a},
      {"UTF-16", "\xFF\xFE#\0 \0"},
      {"COUNT -1", replaced(b, "COUNT 1 1 1", "COUNT -1 1 1")},
      {"COUNT 0", replaced(b, "COUNT 1 1 1", "COUNT 1 0 1")},
      {"COUNT overflow", replaced(b, "COUNT 1 1 1", "COUNT 1 1 4611686018427387905")},
      {"COUNT 2147483647", replaced(b, "COUNT 1 1 1", "COUNT 1 1 2147483647")},
      {"COUNT of z 2", replaced(b, "COUNT 1 1 1", "COUNT 1 1 2")},
      {"too few COUNTs", replaced(b, "COUNT 1 1 1", "COUNT 1 1")},
      {"too many SIZEs", replaced(b, "SIZE 4 4 4", "SIZE 4 4 4 4")},
      {"SIZE -4", replaced(b, "SIZE 4 4 4", "SIZE 4 -4 4")},
      {"SIZE 0", replaced(b, "SIZE 4 4 4", "SIZE 4 0 4")},
      {"SIZE 3", replaced(b, "SIZE 4 4 4", "SIZE 4 3 4")},
      {"SIZE 2 of F", replaced(b, "SIZE 4 4 4", "SIZE 4 2 4")},
      {"SIZE 8 of floats", replaced(b, "SIZE 4 4 4", "SIZE 8 8 8")},
      {"TYPE X", replaced(b, "TYPE F F F", "TYPE F X F")},
      {"TYPE I coordinates", replaced(b, "TYPE F F F", "TYPE I I I")},
      {"WIDTH x HEIGHT wraps 32 bits", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 65536"), "HEIGHT 2", "HEIGHT 65537"), "POINTS 6", "POINTS 65536")},
      {"WIDTH x HEIGHT beyond 2^31", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 65536"), "HEIGHT 2", "HEIGHT 65536"), "POINTS 6\n", "")},
      {"WIDTH wraps 64 bits", replaced(b, "WIDTH 3", "WIDTH 18446744073709551619")},
      {"WIDTH -3", replaced(b, "WIDTH 3", "WIDTH -3")},
      {"WIDTH 0", replaced(b, "WIDTH 3", "WIDTH 0")},
      {"HEIGHT 0", replaced(b, "HEIGHT 2", "HEIGHT 0")},
      {"WIDTH 3.0", replaced(b, "WIDTH 3", "WIDTH 3.0")},
      {"WIDTH of two numbers", replaced(b, "WIDTH 3", "WIDTH 3 3")},
      {"POINTS disagree", replaced(b, "POINTS 6", "POINTS 7")},
      {"POINTS 0", replaced(b, "POINTS 6", "POINTS 0")},
      {"huge POINTS binary", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 2147483647"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 2147483647")},
      {"huge POINTS ascii", replaced(replaced(replaced(a, "WIDTH 3", "WIDTH 2147483647"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 2147483647")},
      {"FIELDS twice", replaced(b, "SIZE", "FIELDS x y z\nSIZE")},
      {"FIELDS after POINTS again", replaced(b, "DATA", "FIELDS x y z w\nDATA")},
      {"COUNT after POINTS again", replaced(b, "DATA", "COUNT 1 1 9\nDATA")},
      {"SIZE after POINTS again", replaced(b, "DATA", "SIZE 8 8 8\nDATA")},
      {"FIELDS and COLUMNS", replaced(b, "SIZE", "COLUMNS x y z\nSIZE")},
      {"x twice", replaced(b, "FIELDS x y z", "FIELDS x y x")},
      {"no z", replaced(b, "FIELDS x y z", "FIELDS x y w")},
      {"upper-case fields", replaced(b, "FIELDS x y z", "FIELDS X Y Z")},
      {"no FIELDS", replaced(b, "FIELDS x y z\n", "")},
      {"FIELDS empty", replaced(b, "FIELDS x y z\n", "FIELDS\n")},
      {"no SIZE", replaced(b, "SIZE 4 4 4\n", "")},
      {"no TYPE", replaced(b, "TYPE F F F\n", "")},
      {"no WIDTH", replaced(b, "WIDTH 3\n", "")},
      {"no DATA", replaced(a, "DATA ascii\n", "")},
      {"no VERSION", replaced(b, "VERSION 0.7\n", "")},
      {"VERSION 9", replaced(b, "VERSION 0.7", "VERSION 9")},
      {"VERSION twice", replaced(b, "FIELDS", "VERSION 0.7\nFIELDS")},
      {"unknown keyword", replaced(b, "HEIGHT", "DEPTH 7\nHEIGHT")},
      {"DATA zip", replaced(b, "DATA binary", "DATA zip")},
      {"DATA of two", replaced(b, "DATA binary", "DATA binary ascii")},
      {"VIEWPOINT of six", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 1 0 0")},
      {"VIEWPOINT nan", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT nan 0 0 1 0 0 0")},
      {"VIEWPOINT zero quaternion", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 0 0 0 0")},
      {"VIEWPOINT huge", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1e300 0 0 1 0 0 0")},
      {"binary, a byte short", b.substr(0, b.size() - 1)},
      {"binary, a byte long", b + "x"},
      {"binary, a point long", b + std::string(12, '\0')},
      {"binary through text mode", replaced(b, std::string_view("\0\0", 2), std::string_view("\0\r\0", 3))},
      {"ascii said, binary there", replaced(b, "DATA binary", "DATA ascii")},
      {"binary said, ascii there", replaced(a, "DATA ascii", "DATA binary")},
      {"short row", replaced(a, "1.5 2 0.125", "1.5 2")},
      {"long row", replaced(a, "1.5 2 0.125", "1.5 2 0.125 9")},
      {"row missing", replaced(a, "1.5 2 0.125\n", "")},
      {"row too many", a + "1 2 3\n"},
      {"abc", replaced(a, "2.25", "abc")},
      {"1.5abc", replaced(a, "2.25", "1.5abc")},
      {"decimal comma", replaced(a, "2.25", "2,25")},
      {"hexadecimal", replaced(a, "2.25", "0x10")},
      {"1e999", replaced(a, "2.25", "1e999")},
      {"1e30 m", replaced(a, "2.25", "1e30")},
      {"++1", replaced(a, "2.25", "++1")},
      {"+-1", replaced(a, "2.25", "+-1")},
      {"NUL in a row", replaced(a, "2.25", std::string_view("2\0.25", 5))},
      {"NUL in the header", replaced(a, "HEIGHT", std::string_view("HEI\0GHT", 7))},
      {"vertical tab as blank", replaced(a, "1.5 2.25", "1.5\v2.25")},
      {"no valid point", header(2, 1, "ascii") + "nan nan nan\nnan nan nan\n"},
      {"all zero", header(2, 2, "ascii") + "0 0 0\n0 0 0\n0 0 0\n0 0 0\n"},
      {"endless header line", "# .PCD v0.7\n" + std::string(1 << 20, 'F')},
      {"endless comments", [] { std::string s = "# .PCD v0.7\n"; for (int i = 0; i < 50000; ++i) s += "# more\n"; return s; }()},
      {"10^6 fields", [] { std::string s = "VERSION 0.7\nFIELDS"; for (int i = 0; i < 1000000; ++i) s += " x"; return s + "\nDATA ascii\n"; }()},
      {"10000 fields x 10000 COUNT", [] {
         std::string f = "FIELDS x y z", s = "SIZE 4 4 4", t = "TYPE F F F", n = "COUNT 1 1 1";
         for (int i = 0; i < 2000; ++i) f += " f", s += " 8", t += " F", n += " 2147483647";
         return "VERSION 0.7\n" + f + "\n" + s + "\n" + t + "\n" + n + "\nWIDTH 2147483647\nHEIGHT 1\nPOINTS 2147483647\nDATA binary\n" + std::string(64, 'x');
       }()},
      {"compressed, no sizes", ch + "1234"},
      {"compressed, wrong unpacked size", ch + compressedBody(packLiterally(planes), planes.size() + 12)},
      {"compressed, huge unpacked size", ch + bytesOf(std::uint32_t(4)) + bytesOf(std::uint32_t(0xFFFFFFFF)) + "abcd"},
      {"compressed, huge POINTS", replaced(replaced(replaced(ch, "WIDTH 3", "WIDTH 300000000"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 300000000") +
                                      compressedBody("abcd", 3600000000u)},
      {"compressed, wrong packed size", ch + bytesOf(std::uint32_t(9999)) + bytesOf(std::uint32_t(72)) + packLiterally(planes)},
      {"compressed, a byte long", c + "x"},
      {"compressed, a byte short", c.substr(0, c.size() - 1)},
      {"LZF repeats before its start", ch + compressedBody(std::string("\x20\x00", 2) + packLiterally(planes.substr(3)), planes.size())},
      {"LZF repeats far before its start", ch + compressedBody(packLiterally(planes.substr(0, 69)) + std::string("\x3F\xFF", 2), planes.size())},
      {"LZF ends inside a run", ch + compressedBody(packLiterally(planes.substr(0, 64)) + "\x1F" "abc", planes.size())},
      {"LZF ends inside a repetition", ch + compressedBody(packLiterally(planes.substr(0, 64)) + "\xE0", planes.size())},
      {"LZF unpacks to more", ch + compressedBody(packLiterally(planes + "more"), planes.size())},
      {"LZF unpacks to less", ch + compressedBody(packLiterally(planes.substr(0, 60)), planes.size())},
      {"LZF empty", ch + compressedBody("", planes.size())},
  };
  return files;
}

}  // namespace stratascope::test
