// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/hostile_lists.h"

#include <limits>

#include "support/pcd_files.h"
#include "support/small_files.h"
#include "support/text_scan_files.h"

namespace stratascope::test {

namespace {

/// Attacks on any file: nothing, or bytes of something else.
void addForeignBytes(std::vector<HostileFile>& files, const std::string& valid) {
  files.insert(files.end(), {{"empty", ""},
                             {"one NUL", std::string(1, '\0')},
                             {"only NULs", std::string(100000, '\0')},
                             {"blank lines", "\n\n\n"},
                             {"random bytes", "\x81\x13\xF0\x9A\n\x07"},
                             {"byte-order mark", "\xEF\xBB\xBF" + valid},
                             {"UTF-16", "\xFF\xFE" + valid},
                             {"one endless word", std::string(1 << 20, 'a')},
                             {"XML", "<scan><p>1 2 3</p></scan>\n"}});
}

/// Attacks on one number of a text file.
void addWrongNumbers(std::vector<HostileFile>& files, const std::string& valid, const std::string& row,
                     const std::string& number) {
  for (const char* wrong : {"abc", "1.5abc", "0x10", "1,5", "1..2", "1e", "e5", "--1", "++1", "+-1", "1e999",
                            "-1e999", "1e12", "1;5", "1\v2", "'1'"})
    files.push_back({std::string("number ") + wrong, replaced(valid, row, replaced(row, number, wrong))});
  files.push_back(
      {"NUL in a number", replaced(valid, row, replaced(row, number, std::string_view("2\0.25", 5)))});
  files.push_back(
      {"a million digits", replaced(valid, row, replaced(row, number, std::string(1000000, '9')))});
}

FormatUnderAttack ply() {
  const std::string a = plyFile(PlyEncoding::Ascii);
  const std::string b = plyFile(PlyEncoding::BinaryLittleEndian);
  const std::string big = plyFile(PlyEncoding::BinaryBigEndian, true);
  const std::string grid = plyRangeGrid(PlyEncoding::Ascii);
  const std::string binaryGrid = plyRangeGrid(PlyEncoding::BinaryLittleEndian);
  FormatUnderAttack format{
      "PLY", ".ply", {a, b, big, plyFile(PlyEncoding::BinaryLittleEndian, true), grid, binaryGrid}, {}};
  auto& files = format.hostile;
  addForeignBytes(files, a);
  addWrongNumbers(files, a, "1.5 2.25 -0.5", "2.25");
  const auto with = [&](const char* name, const std::string& base, std::string_view from,
                        const std::string& to) {
    files.push_back({name, replaced(base, from, to)});
  };
  with("PLY of another version", a, "1.0", "2.0");
  with("no format", a, "format ascii 1.0\n", "");
  with("format twice", a, "comment small", "format ascii 1.0");
  with("format zip", a, "ascii", "zip");
  with("element before format", a, "format", "element vertex 1\nformat");
  with("no vertex", a, "element vertex", "element point");
  with("vertex twice", a, "element face", "element vertex");
  with("negative count", a, "vertex 6", "vertex -6");
  with("fractional count", a, "vertex 6", "vertex 6.0");
  with("count of 2^31", a, "vertex 6", "vertex 2147483648");
  with("huge count ascii", a, "vertex 6", "vertex 2147483647");
  with("huge count binary", b, "vertex 6", "vertex 2147483647");
  with("huge count of faces", b, "face 1", "face 2147483647");
  with("count wraps 64 bits", b, "vertex 6", "vertex 18446744073709551622");
  with("one vertex more", b, "vertex 6", "vertex 7");
  with("one vertex less", b, "vertex 6", "vertex 5");
  with("one vertex less, ascii", a, "vertex 6", "vertex 5");
  with("no count", a, "vertex 6", "vertex");
  with("vertex without property", a, "element face", "element empty 5\nelement face");
  with("property before element", a, "element vertex 6", "property float q\nelement vertex 6");
  with("property of unknown type", a, "property float nx", "property quad nx");
  with("property without name", a, "property float nx", "property float");
  with("property twice", a, "property float nx", "property float x");
  with("no z", a, "property float z", "property float w");
  with("upper-case x", a, "property float x", "property float X");
  with("integer coordinates", a, "property float x", "property int x");
  with("list coordinates", a, "property float x", "property list uchar float x");
  with("list counted by floats", a, "list uchar int", "list float int");
  with("unknown keyword", a, "comment small", "remark small");
  with("no end_header", a, "end_header\n", "");
  with("short row", a, " 0.5 200 ", " 0.5 ");
  with("long row", a, " 0.5 200 ", " 0.5 200 9 ");
  with("fraction in an integer", a, " 200 ", " 200.5 ");
  with("a list of minus one", replaced(a, "list uchar", "list char"), "3 0 1 3", "-1 0 1 3");
  with("a list longer than the file", b, std::string_view("\3\0\0\0", 4), std::string("\xFF\0\0\0", 4));
  with("a list of four billion", replaced(b, "list uchar", "list uint"), std::string_view("\3\0\0\0", 4),
       std::string(8, '\xFF'));
  with("absurd coordinate", b, rawBytes(2.25F), rawBytes(1e30F));
  with("only num_cols", grid, "obj_info num_rows 2\n", "");
  with("num_cols twice", grid, "num_rows 2", "num_cols 2");
  with("num_cols 0", grid, "num_cols 3", "num_cols 0");
  with("num_cols huge", grid, "num_cols 3", "num_cols 4000000000");
  with("grid of another size", grid, "num_cols 3", "num_cols 4");
  with("grid wraps 64 bits", replaced(grid, "num_cols 3", "num_cols 2147483647"), "num_rows 2",
       "num_rows 2147483647");
  with("vertex not there", grid, "1 4 ", "1 5 ");
  with("vertex -1", grid, "1 4 ", "1 -1 ");
  with("vertex twice in the grid", grid, "1 4 ", "1 3 ");
  with("two vertices at a place", grid, "1 4 ", "2 4 3 ");
  files.push_back({"binary, a byte long", b + "x"});
  files.push_back({"binary, a byte short", b.substr(0, b.size() - 1)});
  files.push_back({"ascii, a row long", a + "1 2 3\n"});
  files.push_back({"endless comments", [] {
                     std::string s = "ply\nformat ascii 1.0\n";
                     for (int i = 0; i < 50000; ++i) s += "comment more\n";
                     return s;
                   }()});
  files.push_back({"10^5 properties", [] {
                     std::string s = "ply\nformat ascii 1.0\nelement vertex 1\n";
                     for (int i = 0; i < 100000; ++i) s += "property float p" + std::to_string(i) + "\n";
                     return s + "end_header\n";
                   }()});
  files.push_back({"only zeros",
                   replaced(a, a.substr(a.find("end_header\n") + 11),
                            "0 0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n3 0 1 3\n")});
  return format;
}

FormatUnderAttack ptx() {
  const std::string good = ptxFile();
  FormatUnderAttack format{"PTX", ".ptx", {good}, {}};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  addWrongNumbers(files, good, "1 0.5 -0.5 1", "0.5");
  const auto with = [&](const char* name, std::string_view from, const std::string& to) {
    files.push_back({name, replaced(good, from, to)});
  };
  with("no columns", "2\n3\n", "0\n3\n");
  with("minus columns", "2\n3\n", "-2\n3\n");
  with("fractional rows", "2\n3\n", "2\n3.0\n");
  with("columns and rows in a line", "2\n3\n", "2 3\n");
  with("a column more", "2\n3\n", "3\n3\n");
  with("a column less", "2\n3\n", "1\n3\n");
  with("huge lattice", "2\n3\n", "2147483647\n2147483647\n");
  with("lattice wraps 64 bits", "2\n3\n", "4294967296\n4294967296\n");
  with("large lattice", "2\n3\n", "200000\n10000\n");
  with("place of two numbers", "0 0 0\n1 0 0", "0 0\n1 0 0");
  with("place missing", "0 0 0\n1 0 0", "1 0 0");
  with("place nan", "0 0 0\n1 0 0", "nan 0 0\n1 0 0");
  with("matrix of three columns", "1 0 0 0\n", "1 0 0\n");
  with("matrix scales", "1 0 0 0\n", "2 0 0 0\n");
  with("matrix mirrors", "1 0 0 0\n", "-1 0 0 0\n");
  with("matrix shears", "1 0 0 0\n", "1 1 0 0\n");
  with("matrix zero", "1 0 0 0\n", "0 0 0 0\n");
  with("matrix projective", "1 0 0 0\n", "1 0 0 1\n");
  with("matrix nan", "0 0 0 1\n", "nan 0 0 1\n");
  with("matrix far beyond", "0 0 0 1\n", "1e30 0 0 1\n");
  with("matrix row missing", "0 0 0 1\n", "");
  with("short row", "1 0 0 0.25", "1 0");
  with("five numbers", "1 0 0 0.25", "1 0 0 0.25 7");
  with("no intensity once", "1 0 0 0.25", "1 0 0");
  with("eight numbers", "1 0 0 0.25", "1 0 0 0.25 1 2 3 4");
  with("row missing", "1 0 0 0.25\n", "");
  with("row too many", "1 0 0 0.25\n", "1 0 0 0.25\n1 0 0 0.25\n");
  with("text behind", "1 0 0 0.25\n", "1 0 0 0.25 x\n");
  files.push_back({"a row after the end", good + "1 2 3 4\n"});
  files.push_back({"a head after the end", good + "2\n3\n0 0 0\n"});
  files.push_back({"only a head", good.substr(0, good.find("1 0 -0.5"))});
  files.push_back(
      {"all missing",
       "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n0 0 0 0.5\n0 0 0 0.5\n"});
  return format;
}

FormatUnderAttack pts() {
  const std::string good = ptsFile();
  FormatUnderAttack format{"PTS", ".pts", {good, good + "2\n1 1 1 0 0 0 0\n2 3 1 0 0 0 0\n"}, {}};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  addWrongNumbers(files, good, "-1 0 0.125", "0.125");
  const auto with = [&](const char* name, std::string_view from, const std::string& to) {
    files.push_back({name, replaced(good, from, to)});
  };
  with("no count", "3\n1.5", "1.5");
  with("count 0", "3\n1.5", "0\n1.5");
  with("count -3", "3\n1.5", "-3\n1.5");
  with("count 3.0", "3\n1.5", "3.0\n1.5");
  with("two counts", "3\n1.5", "3 3\n1.5");
  with("count 2", "3\n1.5", "2\n1.5");
  with("count 4", "3\n1.5", "4\n1.5");
  with("huge count", "3\n1.5", "18446744073709551615\n1.5");
  with("count beyond 64 bits", "3\n1.5", "18446744073709551619\n1.5");
  with("large count", "3\n1.5", "1000000000\n1.5");
  with("two numbers", "2 2 2 5 4 5 6", "2 2");
  with("five numbers", "2 2 2 5 4 5 6", "2 2 2 5 4");
  with("fewer columns", "2 2 2 5 4 5 6", "2 2 2 5");
  with("more columns", "2 2 2 5 4 5 6", "2 2 2 5 4 5 6 7");
  with("text behind", "2 2 2 5 4 5 6", "2 2 2 5 4 5 x");
  files.push_back({"a row after the end", good + "1 2 3 4 5 6 7\n"});
  files.push_back({"only a count", "3\n"});
  files.push_back({"only zero counts", "0\n0\n"});
  files.push_back({"all nan", "1\nnan nan nan\n"});
  return format;
}

FormatUnderAttack polar() {
  const std::string good = polarFile();
  FormatUnderAttack format{"polar text", ".csv", {good}, {}};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  // a decimal comma makes one column more
  addWrongNumbers(files, good, "1,2,2.5,7", "2.5");
  const auto with = [&](const char* name, std::string_view from, const std::string& to) {
    files.push_back({name, replaced(good, from, to)});
  };
  with("no column names", "line,beam,range,intensity\n", "");
  with("no range", "line,beam,range,", "line,beam,distance,");
  with("range twice", "range,intensity", "range,range");
  with("two separators", "line,beam,range,intensity", "line;beam;range,intensity");
  with("no first elevation", "# head_elevation_first 10\n", "");
  with("no beam step", "# beam_step 60\n", "");
  with("elevation twice", "# beam_first 0\n", "# head_elevation_first 10\n# beam_first 0\n");
  with("elevation abc", "first 10", "first abc");
  with("elevation nan", "first 10", "first nan");
  with("elevation 1000", "first 10", "first 1000");
  with("beams beyond 180", "beam_step 60", "beam_step 90");
  with("beams below 0", "beam_step 60", "beam_step -1");
  with("unknown unit", "# beam_first 0\n", "# range_unit ell\n# beam_first 0\n");
  with("one reading less said", "readings 11", "readings 10");
  with("one reading more said", "readings 11", "readings 12");
  with("readings -1", "readings 11", "readings -1");
  with("readings twice", "# beam_first 0\n", "# readings 11\n# beam_first 0\n");
  with("line -1", "1,2,2.5,7", "-1,2,2.5,7");
  with("line 1.5", "1,2,2.5,7", "1.5,2,2.5,7");
  with("line huge", "1,2,2.5,7", "2000000000,2,2.5,7");
  with("line and beam huge", "1,2,2.5,7", "2147483646,2147483646,2.5,7");
  with("line beyond 64 bits", "1,2,2.5,7", "18446744073709551617,2,2.5,7");
  with("line left out", "1,2,2.5,7", ",2,2.5,7");
  with("same place twice", "1,2,2.5,7", "1,1,2.5,7");
  with("fewer columns", "1,2,2.5,7", "1,2,2.5");
  with("more columns", "1,2,2.5,7", "1,2,2.5,7,8");
  with("intensity text", "1,2,2.5,7", "1,2,2.5,bright");
  files.push_back({"no readings", good.substr(0, good.find("0,0,2.5"))});
  files.push_back({"names only", "line,beam,range\n"});
  files.push_back({"all missing", replaced(good.substr(0, good.find("0,0,2.5")), "# readings 11\n", "") +
                                      "0,0,0,7\n0,1,nan,7\n"});
  return format;
}

FormatUnderAttack scanGraph() {
  const std::string good = scanGraphFile();
  FormatUnderAttack format{"scan graph", ".txt", {good}, {}, false};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  addWrongNumbers(files, good, "1.5 1 0", "1.5");
  const auto with = [&](const char* name, std::string_view from, const std::string& to) {
    files.push_back({name, replaced(good, from, to)});
  };
  with("pose of five", "NODE 1 2 3 0 0 0", "NODE 1 2 3 0 0");
  with("pose of seven", "NODE 1 2 3 0 0 0", "NODE 1 2 3 0 0 0 0");
  with("pose nan", "NODE 1 2 3 0 0 0", "NODE 1 2 3 0 nan 0");
  with("pose inf", "NODE 1 2 3 0 0 0", "NODE inf 2 3 0 0 0");
  with("pose text", "NODE 1 2 3 0 0 0", "NODE 1 2 x 0 0 0");
  with("pose far beyond", "NODE 1 2 3 0 0 0", "NODE 1e10 2 3 0 0 0");
  with("no pose", "NODE 1 2 3 0 0 0", "NODE");
  with("two numbers", "1.5 1 0", "1.5 1");
  with("four numbers", "1.5 1 0", "1.5 1 0 7");
  with("NODE within a row", "1.5 1 0", "1.5 1 NODE");
  with("lower-case node", "NODE 0 0 0", "node 0 0 0");
  with("node without points", "NODE 0 0 0", "NODE 1 1 1 0 0 0\nNODE 0 0 0");
  files.push_back({"node without points last", good + "NODE 1 1 1 0 0 0\n"});
  files.push_back({"only a node", "NODE 1 1 1 0 0 0\n"});
  files.push_back({"only comments", "# NODE 1 1 1 0 0 0\n# 1 2 3\n"});
  files.push_back({"all nan", "NODE 1 1 1 0 0 0\nnan nan nan\n"});
  files.push_back({"all zero", "NODE 1 1 1 0 0 0\n0 0 0\n0 0 0\n"});
  return format;
}

FormatUnderAttack las() {
  const std::string good = lasFile();
  const std::string four = lasFile({.minor = 4, .format = 7, .extendedRecord = true});
  FormatUnderAttack format{
      "LAS",
      ".las",
      {good, four, lasFile({.minor = 3, .format = 1}), lasFile({.minor = 4, .format = 6, .record = false})},
      {}};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  const auto with = [&](const char* name, const std::string& base, size_t at, const std::string& bytes) {
    std::string changed = base;
    changed.replace(at, bytes.size(), bytes);
    files.push_back({name, changed});
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  with("another mark", good, 0, "LASX");
  with("version 2.0", good, 24, "\2");
  with("version 1.5", good, 25, "\5");
  with("version 0", good, 24, std::string(1, '\0'));
  with("header of 226 bytes", good, 94, rawBytes(std::uint16_t{226}));
  with("header of 0 bytes", good, 94, rawBytes(std::uint16_t{0}));
  with("header beyond the file", good, 94, rawBytes(std::uint16_t{65535}));
  with("1.4 in a header of 1.2", good, 25, "\4");
  with("points inside the header", good, 96, rawBytes(std::uint32_t{100}));
  with("points beyond the file", good, 96, rawBytes(std::uint32_t{100000}));
  with("points at 2^32 - 1", good, 96, rawBytes(std::uint32_t{0xFFFFFFFF}));
  with("points a byte later", good, 96, rawBytes(std::uint32_t{298}));
  with("points inside the records", good, 96, rawBytes(std::uint32_t{230}));
  with("records without end", good, 100, rawBytes(std::uint32_t{0xFFFFFFFF}));
  with("two records said", good, 100, rawBytes(std::uint32_t{2}));
  with("a record beyond the points", good, 227 + 20, rawBytes(std::uint16_t{17}));
  with("a record of 65535 bytes", good, 227 + 20, rawBytes(std::uint16_t{65535}));
  with("compressed", good, 104, "\x83");
  with("compressed the old way", good, 104, "\x43");
  with("point format 11", good, 104, "\x0B");
  with("point format 63", good, 104, "\x3F");
  with("point format larger than its points", good, 104, "\x05");
  with("points of 0 bytes", good, 105, rawBytes(std::uint16_t{0}));
  with("points of 33 bytes", good, 105, rawBytes(std::uint16_t{33}));
  with("points of 35 bytes", good, 105, rawBytes(std::uint16_t{35}));
  with("points of 65535 bytes", good, 105, rawBytes(std::uint16_t{65535}));
  with("no points", good, 107, rawBytes(std::uint32_t{0}));
  with("a point more", good, 107, rawBytes(std::uint32_t{5}));
  with("four billion points", good, 107, rawBytes(std::uint32_t{0xFFFFFFFF}));
  with("scale 0", good, 131, rawBytes(0.0));
  with("scale nan", good, 139, rawBytes(nan));
  with("scale minus", good, 147, rawBytes(-0.01));
  with("scale huge", good, 131, rawBytes(1e300));
  with("scale far too large", good, 131, rawBytes(1e8));
  with("offset nan", good, 155, rawBytes(nan));
  with("offset inf", good, 163, rawBytes(std::numeric_limits<double>::infinity()));
  with("offset huge", good, 171, rawBytes(1e12));
  with("1.4: counts differ", four, 107, rawBytes(std::uint32_t{3}));
  with("1.4: 2^63 points", four, 247, rawBytes(std::uint64_t{1} << 63));
  with("1.4: 2^31 points", four, 247, rawBytes(std::uint64_t{1} << 31));
  with("1.4: a point more", four, 247, rawBytes(std::uint64_t{8}));
  with("1.4: no points", four, 247, rawBytes(std::uint64_t{0}));
  with("1.4: records inside the points", four, 235, rawBytes(std::uint64_t{460}));
  with("1.4: records beyond the file", four, 235, rawBytes(std::uint64_t{100000}));
  with("1.4: records at 2^64 - 1", four, 235, rawBytes(~std::uint64_t{0}));
  with("1.4: two records said", four, 243, rawBytes(std::uint32_t{2}));
  with("1.4: four billion records", four, 243, rawBytes(std::uint32_t{0xFFFFFFFF}));
  with("1.4: a record of 2^64 - 1 bytes", four, four.size() - 65 + 20, rawBytes(~std::uint64_t{0}));
  files.push_back({"only a mark", "LASF"});
  files.push_back({"a header alone", good.substr(0, 227)});
  std::string withheld = good;
  for (size_t i = 0; i < 4; ++i) withheld[297 + 34 * i + 15] = '\x80';
  files.push_back({"all withheld", withheld});
  return format;
}

FormatUnderAttack e57() {
  const std::string good = e57File();
  FormatUnderAttack format{"E57", ".e57", {good}, {}};
  auto& files = format.hostile;
  addForeignBytes(files, good);
  const auto with = [&](const char* name, size_t at, const std::string& bytes) {
    std::string changed = good;
    changed.replace(at, bytes.size(), bytes);
    files.push_back({name, changed});
  };
  with("another mark", 0, "ASTM-E58");
  with("version 2", 8, "\2");
  with("a byte less said", 16, rawBytes(std::uint64_t{good.size() - 1}));
  with("length 2^64 - 1", 16, rawBytes(~std::uint64_t{0}));
  with("a damaged byte", 500, "\x7F");
  with("a damaged checksum", 1020, "abcd");
  with("pages of 0 bytes", 40, rawBytes(std::uint64_t{0}));
  with("pages of 2^63 bytes", 40, rawBytes(std::uint64_t{1} << 63));
  with("pages of 512 bytes", 40, rawBytes(std::uint64_t{512}));
  files.push_back({"only a header", good.substr(0, 48)});
  files.push_back({"a page short", good.substr(0, good.size() - 1024)});
  files.push_back({"a byte long", good + "x"});
  files.push_back({"wrong checksum", e57File({.checksums = false})});
  // From here on the checksums are right: what they protect is wrong.
  const auto made = [&](const char* name, const E57Options& options) {
    files.push_back({name, e57File(options)});
  };
  const std::string z =
      R"(<cartesianX type="ScaledInteger" minimum="-8388608" maximum="8388607"/><cartesianY type="ScaledInteger" minimum="-8388608" maximum="8388607"/>)";
  const std::string rest =
      R"(<rowIndex type="Integer" minimum="0" maximum="3"/><columnIndex type="Integer" minimum="0" maximum="3"/><cartesianInvalidState type="Integer" minimum="0" maximum="2"/>)";
  const auto points = [](const char* at, const char* count) {
    return std::string("type=\"CompressedVector\" fileOffset=\"") + at + "\" recordCount=\"" + count + "\"";
  };
  made("XML that does not end", {.xmlPrefix = "<open>"});
  made("XML of two roots, the wrong one", {.xmlPrefix = "<e57Root/>"});
  made("XML entity bomb",
       {.xmlPrefix = "<!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;&b;\">]><e57Root>&c;</e57Root>"});
  made("no points", {.pointsAttributes = R"(type="Structure")"});
  made("no offset", {.pointsAttributes = R"(type="CompressedVector" recordCount="6")"});
  made("offset -1", {.pointsAttributes = points("-1", "6")});
  made("offset beyond the file", {.pointsAttributes = points("999999", "6")});
  made("offset 2^63 - 1", {.pointsAttributes = points("9223372036854775807", "6")});
  made("offset in the header", {.pointsAttributes = points("0", "6")});
  made("offset in a checksum", {.pointsAttributes = points("1022", "6")});
  made("no records", {.pointsAttributes = points("48", "0")});
  made("minus records", {.pointsAttributes = points("48", "-6")});
  made("records text", {.pointsAttributes = points("48", "six")});
  made("many more records", {.pointsAttributes = points("48", "60")});
  made("two billion records", {.pointsAttributes = points("48", "2147483647")});
  made("2^63 - 1 records", {.pointsAttributes = points("48", "9223372036854775807")});
  made("a codec", {.codecs = "<vectorChild><bitPackCodec/></vectorChild>"});
  made("no z", {.prototype = z + R"(<q type="Integer"/>)" + rest});
  made("x twice", {.prototype = z + R"(<cartesianX type="Float"/>)" + rest});
  made("unknown type", {.prototype = z + R"(<cartesianZ type="Complex"/>)" + rest});
  made("text coordinate", {.prototype = z + R"(<cartesianZ type="String"/>)" + rest});
  made("minimum above maximum",
       {.prototype = z + R"(<cartesianZ type="Integer" minimum="5" maximum="4"/>)" + rest});
  made("minimum text", {.prototype = z + R"(<cartesianZ type="Integer" minimum="low" maximum="4"/>)" + rest});
  made("scale 0",
       {.prototype =
            z + R"(<cartesianZ type="ScaledInteger" minimum="0" maximum="16777215" scale="0"/>)" + rest});
  made("scale nan",
       {.prototype =
            z + R"(<cartesianZ type="ScaledInteger" minimum="0" maximum="16777215" scale="nan"/>)" + rest});
  made("scale huge",
       {.prototype =
            z + R"(<cartesianZ type="ScaledInteger" minimum="1" maximum="16777216" scale="1e300"/>)" + rest});
  made("half precision", {.prototype = z + R"(<cartesianZ type="Float" precision="half"/>)" + rest});
  made("wider fields than streams",
       {.prototype = z + R"(<cartesianZ type="Float" precision="double"/>)" + rest});
  made(
      "a field more than streams",
      {.prototype =
           z +
           R"(<cartesianZ type="Integer" minimum="0" maximum="16777215"/><intensity type="Integer" minimum="0" maximum="1"/>)" +
           rest});
  made("a field less than streams",
       {.prototype = z + R"(<cartesianZ type="Integer" minimum="0" maximum="16777215"/>)"});
  made(
      "rows of floats",
      {.prototype =
           z +
           R"(<cartesianZ type="Integer" minimum="0" maximum="16777215"/><rowIndex type="Float"/><columnIndex type="Integer" minimum="0" maximum="3"/><cartesianInvalidState type="Integer" minimum="0" maximum="2"/>)"});
  made(
      "bounds too small",
      {.bounds = R"(<indexBounds><rowMaximum>1</rowMaximum><columnMaximum>2</columnMaximum></indexBounds>)"});
  made("bounds text", {.bounds = R"(<indexBounds><rowMaximum>many</rowMaximum></indexBounds>)"});
  made("bounds beyond 2^31",
       {.bounds = R"(<indexBounds><rowMaximum>99999999999</rowMaximum></indexBounds>)"});
  made("a pose of nan", {.pose = "<pose><translation><x>nan</x></translation></pose>"});
  made("a pose of text", {.pose = "<pose><translation><x>here</x></translation></pose>"});
  made("a zero quaternion", {.pose = "<pose><rotation><w>0</w></rotation></pose>"});
  made("a long quaternion", {.pose = "<pose><rotation><w>100</w></rotation></pose>"});
  made("5000 scans of the same bytes", {.times = 5000});
  const auto logicalChanged = [&](const char* name, size_t at, const std::string& bytes) {
    std::string changed = good;
    changed.replace(at, bytes.size(), bytes);
    files.push_back({name, withChecksums(changed)});
  };
  logicalChanged("a section of another type", 48, "\2");
  logicalChanged("a section beyond the file", 56, rawBytes(std::uint64_t{1} << 40));
  logicalChanged("a section of 0 bytes", 56, rawBytes(std::uint64_t{0}));
  logicalChanged("data outside the section", 64, rawBytes(std::uint64_t{900}));
  logicalChanged("data in the header", 64, rawBytes(std::uint64_t{8}));
  logicalChanged("a packet of unknown type", 80, "\x09");
  logicalChanged("a packet beyond the section", 82, rawBytes(std::uint16_t{65535}));
  logicalChanged("a packet of 1 byte", 82, rawBytes(std::uint16_t{0}));
  logicalChanged("a packet of 5 streams", 84, rawBytes(std::uint16_t{5}));
  logicalChanged("a stream beyond its packet", 86, rawBytes(std::uint16_t{65535}));
  logicalChanged("a stream too short", 86, rawBytes(std::uint16_t{10}));
  return format;
}

}  // namespace

std::vector<FormatUnderAttack> formatsUnderAttack() {
  return {{"PCD", ".pcd", {asciiFile(), binaryFile(), compressedFile()}, hostilePcds()},
          ply(),
          ptx(),
          pts(),
          {"UOS .3d", ".3d", {uosFile(3, 4), "4 x 3\n" + uosFile(3, 4)}, hostileUosScans(), false},
          {"XYZ text",
           ".xyz",
           {"1 2 3\n4 5 6\n7 8 9\n", "x,y,z,i\n1,2,3,4\n-1,0.5,2,3\n"},
           hostileXyzFiles(),
           false},
          polar(),
          scanGraph(),
          las(),
          e57()};
}

}  // namespace stratascope::test
