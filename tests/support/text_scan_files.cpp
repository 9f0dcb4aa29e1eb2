// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/text_scan_files.h"

#include <cmath>

#include "base/units.h"
#include "io/text_lines.h"

namespace stratascope::test {

std::string uosRow(double range, double thetaDeg, double tiltDeg) {
  const double theta = degToRad(thetaDeg), tilt = degToRad(tiltDeg);
  return shortestText(range * std::cos(theta)) + " " +
         shortestText(range * std::sin(theta) * std::sin(tilt)) + " " +
         shortestText(range * std::sin(theta) * std::cos(tilt));
}

std::string uosFile(int lines, int beams, const std::string& end, const std::string& extra) {
  std::string text;
  for (int i = 0; i < lines; ++i)
    for (int j = 0; j < beams; ++j)
      text += uosRow(100 + 10 * i + j, 180.0 * j / beams, -20 + 10 * i) + extra + end;
  return text;
}

std::vector<HostileFile> hostileUosScans() {
  const std::string good = uosFile(3, 4);
  const std::string row = uosRow(101, 45, -20);
  std::vector<HostileFile> files = {
      {"empty", ""},
      {"blank lines", "\n\n\n"},
      {"blanks", "    "},
      {"only a size line", "360 x 225\n"},
      {"size line twice", "4 x 3\n4 x 3\n" + good},
      {"size line later", good + "4 x 3\n"},
      {"byte-order mark", "\xEF\xBB\xBF" + good},
      {"UTF-16", "\xFE\xFF" + good},
      {"NULs", std::string(10000, '\0')},
      {"NUL after number", replaced(good, row, row + std::string(1, '\0'))},
      {"random bytes", "\x81\x13\xF0\x9A\n\x07"},
      {"abc", replaced(good, row, "abc 1 2")},
      {"trailing letters", replaced(good, row, "1 2 3x")},
      {"hexadecimal", replaced(good, row, "0x10 1 2")},
      {"decimal comma", replaced(good, row, "1,5 2,5 3,5")},
      {"commas", replaced(good, row, "1,2,3")},
      {"semicolons", replaced(good, row, "1;2;3")},
      {"1e999", replaced(good, row, "1e999 2 3")},
      {"-1e999", replaced(good, row, "1 2 -1e999")},
      {"1e-999", replaced(good, row, "1e-999 1 2")},
      {"absurd", replaced(good, row, "1e12 2 3")},
      {"absurd negative", replaced(good, row, "1 -3e200 3")},
      {"two numbers", replaced(good, row, "1 2")},
      {"one number", replaced(good, row, "1")},
      {"four numbers once", replaced(good, row, "1 2 3 4")},
      {"five numbers first", "1 2 3 4 5\n" + good},
      {"++1", replaced(good, row, "++1 2 3")},
      {"+-1", replaced(good, row, "+-1 2 3")},
      {"1..2", replaced(good, row, "1..2 2 3")},
      {"1e", replaced(good, row, "1e 2 3")},
      {"e5", replaced(good, row, "e5 2 3")},
      {"lone minus", replaced(good, row, "- 2 3")},
      {"10^6 columns",
       [] {
         std::string s;
         for (int i = 0; i < 1000000; ++i) s += "1 ";
         return s + "\n";
       }()},
      {"a million digits", "1 2 " + std::string(1000000, '9') + "\n"},
      {"one endless word", std::string(1 << 20, 'a')},
      {"only nan", "nan nan nan\nnan nan nan\n"},
      {"only inf", "inf inf inf\n"},
      {"only zeros", "0 0 0\n0 0 0\n"},
      {"only status codes", uosRow(3275.9, 0, 0) + "\n" + uosRow(3276.7, 90, 0) + "\n"},
      {"old Mac line ends", "1 2 3\r4 5 6\r7 8 9\r"},
      {"vertical tabs", "1\v2\v3\n"},
      {"comment", "# x y z\n" + good},
      {"column names", "x y z\n" + good},
      {"XML", "<scan><p>1 2 3</p></scan>\n"},
      {"reflectance is text", replaced(uosFile(3, 4, "\n", " 7"), row + " 7", row + " seven")},
      {"PLY", "ply\nformat ascii 1.0\n"},
      {"E57", "ASTM-E57" + good},
      {"LAS", "LASF\1\2"},
  };
  return files;
}

std::vector<HostileFile> hostileXyzFiles() {
  const std::string good = "1 2 3\n4 5 6\n7 8 9\n";
  std::vector<HostileFile> files = {
      {"empty", ""},
      {"blank lines", "\n\r\n\n"},
      {"only comments", "# a\n// b\n"},
      {"only names", "x y z\n"},
      {"names twice", "x y z\nx y z\n1 2 3\n"},
      {"names later", good + "x y z\n"},
      {"names of another count", "x y z i\n" + good},
      {"two names", "x y\n1 2\n"},
      {"prose", "this is not a point cloud\n"},
      {"byte-order mark", "\xEF\xBB\xBF" + good},
      {"UTF-16 LE", "\xFF\xFE" + good},
      {"NULs", std::string(5000, '\0')},
      {"NUL", std::string("1 2 3\0\n", 7)},
      {"NUL in number", std::string("1 2\0 3\n", 7)},
      {"random bytes", "\x81\x13\xF0\x9A\n\x07"},
      {"abc", "1 2 3\n4 abc 6\n"},
      {"trailing letters", "1 2 3m\n"},
      {"hexadecimal", "0x1 2 3\n"},
      {"decimal comma", "1,5 2,5 3,5\n"},
      {"decimal comma, semicolons", "1,5;2,5;3,5\n"},
      {"mixed separators", "1 2,3\n"},
      {"empty column", "1,,3\n"},
      {"leading comma", ",1,2,3\n"},
      {"trailing comma", "1,2,3,\n"},
      {"1e999", "1 2 1e999\n"},
      {"-1e999", "-1e999 2 1\n"},
      {"1e-999", "1 2 1e-999\n"},
      {"absurd", "1 2 2e9\n"},
      {"point count first", "3\n" + good},
      {"two columns", "1 2\n3 4\n"},
      {"short row", "1 2 3\n4 5\n"},
      {"long row", "1 2 3\n4 5 6 7\n"},
      {"text column", "1 2 3 chair\n"},
      {"colour as #", "1 2 3 #ff0000\n"},
      {"++1", "++1 2 3\n"},
      {"+-1", "+-1 2 3\n"},
      {"1..2", "1..2 2 3\n"},
      {"lone minus", "- 2 3\n"},
      {"10^6 columns",
       [] {
         std::string s;
         for (int i = 0; i < 1000000; ++i) s += "1 ";
         return s + "\n";
       }()},
      {"10^6 commas", std::string(1000000, ',')},
      {"a million digits", "1 2 " + std::string(1000000, '9') + "\n"},
      {"one endless word", std::string(1 << 20, 'a')},
      {"only nan", "nan nan nan\n"},
      {"only zeros", "0 0 0\n"},
      {"old Mac line ends", "1 2 3\r4 5 6\r"},
      {"XML", "<p>1 2 3</p>\n"},
      {"brackets", "[1 2 3]\n"},
      {"ESRI grid", "ncols 3\nnrows 2\n"},
      {"E57", "ASTM-E57abc"},
      {"LAS", "LASF\1\2"},
      {"PLY", "ply\nformat ascii 1.0\n"},
      {"PCD cut off", "# .PCD v0.7\nVERSION 0.7\n"},
  };
  return files;
}

}  // namespace stratascope::test
