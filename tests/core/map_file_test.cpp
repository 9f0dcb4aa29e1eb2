// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The two forms of a stored map, .strata and intervals.csv: round trips and hostile files.
#include "io/map_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "io/map_csv.h"
#include "support/hostile_files.h"
#include "support/stored_maps.h"

namespace stratascope {
namespace {

using test::randomStoredMap;
using test::replaced;
using test::sealed;

constexpr size_t kJsonAt = 18 + 4;

std::uint32_t jsonBytes(const std::string& file) {
  std::uint32_t size = 0;
  std::memcpy(&size, file.data() + 18, 4);
  return size;
}

/// `file` with another header, of any length, and the right checksum.
std::string withHeader(const std::string& file, const std::string& json) {
  const auto size = static_cast<std::uint32_t>(json.size());
  std::string length(4, '\0');
  std::memcpy(length.data(), &size, 4);
  return sealed(file.substr(0, 18) + length + json + file.substr(kJsonAt + jsonBytes(file)));
}
std::string headerOf(const std::string& file) {
  return file.substr(kJsonAt, jsonBytes(file));
}

/// `file` with other cells and the right checksum.
std::string withBody(const std::string& file, const std::string& body) {
  return sealed(file.substr(0, kJsonAt + jsonBytes(file)) + body + std::string(32, '\0'));
}
std::string bodyOf(const std::string& file) {
  const size_t at = kJsonAt + jsonBytes(file);
  return file.substr(at, file.size() - 32 - at);
}

void expectRefused(const std::string& bytes, const std::string& name) {
  const auto map = mapFromFileBytes("hostile.strata", bytes);
  EXPECT_FALSE(map) << "accepted: " << name;
  if (map) return;
  const std::string message = map.error().message();
  EXPECT_EQ(message.find('\n'), std::string::npos) << name;
  EXPECT_EQ(message.rfind("hostile.strata", 0), 0u) << name << ": " << message;
  EXPECT_LT(message.size(), 400u) << name;
  EXPECT_FALSE(map.error().remedy.empty()) << name;
}

TEST(MapFile, ComesBackAsItWas) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    StoredMap stored = randomStoredMap("scan \"a\" \xC3\xB6", seed, 1 + 37 * seed, seed % 2 ? 0.05 : 1.7);
    stored.sources[0].json = R"({"name":"s","points":5,"version":"1","parameters":{"cell":0.1}})";
    stored.sources[0].name = "s", stored.sources[0].points = 5;
    if (seed % 3 == 0) stored.map.intervals.rule = IntervalRule::Paper;
    const std::string bytes = mapFileBytes(stored);
    EXPECT_EQ(bytes, mapFileBytes(stored));
    const auto back = mapFromFileBytes("map.strata", bytes);
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_TRUE(back->map == stored.map);
    ASSERT_EQ(back->sources.size(), 1u);
    EXPECT_EQ(back->sources[0].json, stored.sources[0].json);
    EXPECT_EQ(mapFileBytes(*back), bytes);
  }
}

TEST(MapFile, FarCellsComeBack) {
  StoredMap stored = randomStoredMap("s", 1, 1);
  stored.map.objects.clear();
  stored.map.records = {{{-2147483647 - 1, 2147483647}, {-1, 1, 4294967295u}},
                        {{-2147483647 - 1, 2147483647}, {2, 2, 1}},
                        {{2147483647, -2147483647 - 1}, {-1e30f, 1e-30f, 1}}};
  stored.map.firstObject = {0, 0, 0, 0};
  const auto back = mapFromFileBytes("map.strata", mapFileBytes(stored));
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_TRUE(back->map == stored.map);
}

TEST(MapFile, EveryPrefixAndEveryChangedByteIsAnError) {
  const std::string bytes = mapFileBytes(randomStoredMap("s", 3, 25));
  test::forEveryPrefix(bytes, [](size_t n, const std::string& prefix) {
    EXPECT_FALSE(mapFromFileBytes("m.strata", prefix)) << n;
  });
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
    EXPECT_FALSE(mapFromFileBytes("m.strata", changed)) << i;
  }
  EXPECT_FALSE(mapFromFileBytes("m.strata", bytes + "x"));
}

TEST(MapFile, HostileHeadersWithARightChecksumAreRefused) {
  const std::string file = mapFileBytes(randomStoredMap("s", 3, 25)), json = headerOf(file);
  ASSERT_TRUE(mapFromFileBytes("m.strata", withHeader(file, json)));
  const auto with = [&](const std::string& from, const std::string& to) {
    expectRefused(withHeader(file, replaced(json, from, to)), from + " -> " + to);
  };
  for (const char* text :
       {"", "x", "[]", "{}", "null", "\"\"", "{\"program\":", "{\"program\":\"stratascope\"}"})
    expectRefused(withHeader(file, text), text);
  expectRefused(withHeader(file, std::string(100000, '[')), "nested lists");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
  expectRefused(withHeader(file, deep), "nested objects");
  std::string keys = "{";
  for (int i = 0; i < 20000; ++i) keys += "\"" + std::to_string(i) + "\":0,";
  expectRefused(withHeader(file, keys + "\"x\":0}"), "many keys");
  with("\"program\":\"stratascope\"", "\"program\":\"other\"");
  with("\"program\":\"stratascope\"", "\"program\":\"stratascope\",\"program\":\"stratascope\"");
  with("\"cell\":0.25", "\"cell\":0");
  with("\"cell\":0.25", "\"cell\":-0.25");
  with("\"cell\":0.25", "\"cell\":1e999");
  with("\"cell\":0.25", "\"cell\":\"0.25\"");
  with("\"cell\":0.25", "\"cell\":null");
  with("\"cell\":0.25", "\"sell\":0.25");
  with("\"epsilon\":0.1", "\"epsilon\":0");
  with("\"epsilon\":0.1", "\"epsilon\":[0.1]");
  with("\"epsilon\":0.1", "\"epsilon\":1.5");  // records nearer than that
  with("\"linked\"", "\"joined\"");
  with("\"linked\"", "1");
  with("\"inputs\":[", "\"inputs\":0,\"others\":[");
  with("\"label_base\":0", "\"label_base\":-1");
  with("\"label_base\":0", "\"label_base\":4294967290");
  with("\"label_base\":0", "\"label_base\":9");  // labels of no scan
  with("\"label_count\":25", "\"label_count\":1");
  with("\"label_count\":25", "\"label_count\":0.5");
  with("\"name\":\"s\"", "\"name\":7");
  with("\"name\":\"s\"", "\"name\":\"s\",\"local_origin\":[1,2]");
  with("\"name\":\"s\"", "\"name\":\"s\",\"local_origin\":[1,2,null]");
  with("\"k_min\":", "\"k_min\":1");
  with("\"k_min\":", "\"k_max\":");
  with("\"l_min\":", "\"l_min\":9");
  with("\"l_min\":", "\"l_min\":99999999999999999999");
  with("\"cells\":", "\"cells\":1");
  with("\"cells\":", "\"cells\":-");
  with("\"records\":", "\"records\":9999999");
  with("\"records\":", "\"records\":\"\",\"r\":");
  with("\"objects\":", "\"objects\":1");
  with("\"objects\":", "\"objects\":18446744073709551615,\"o\":");
  std::string longer = file;
  longer[18 + 3] = '\x7f';
  expectRefused(sealed(longer), "header of 2 GiB");
  expectRefused(sealed(replaced(file, "map 1\n", "map 2\n")), "version 2");
  expectRefused(sealed(replaced(file, "map 1\n", "map 1\r")), "line end");
}

TEST(MapFile, HostileCellsWithARightChecksumAreRefused) {
  const std::string file = mapFileBytes(randomStoredMap("s", 3, 25)), body = bodyOf(file);
  ASSERT_TRUE(mapFromFileBytes("m.strata", withBody(file, body)));
  const auto changed = [&](size_t at, const std::string& to) {
    std::string other = body;
    return withBody(file, other.replace(at, to.size(), to));
  };
  const auto floatText = [](float value) {
    std::string raw(4, '\0');
    std::memcpy(raw.data(), &value, 4);
    return raw;
  };
  // the first cell: columns, rows, records, then min, max, points of the first record
  expectRefused(changed(0, "\x01"), "first cell in another column");
  expectRefused(changed(0, "\x80"), "number goes on");
  expectRefused(changed(2, std::string(1, '\0')), "a cell without records");
  expectRefused(changed(2, "\x7f"), "more records than there are");
  for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1e9f})
    expectRefused(changed(3, floatText(bad)), "minimum");
  for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, -1e9f})
    expectRefused(changed(7, floatText(bad)), "maximum");
  expectRefused(changed(11, std::string(1, '\0')), "no points");
  expectRefused(withBody(file, ""), "no cells");
  expectRefused(withBody(file, body + body), "twice");
  expectRefused(withBody(file, std::string(1000, '\xff')), "ones");
  expectRefused(withBody(file, std::string(1000, '\0')), "zeros");
  expectRefused(withBody(file, "\x80" + std::string(1, '\0') + body), "a long zero");
  for (size_t n = 0; n < body.size(); ++n)
    expectRefused(withBody(file, body.substr(0, n)), "prefix of the cells");

  // whatever the cells are changed to, it is an error or a map that is whole in itself
  std::mt19937 random(5);
  int refused = 0;
  for (int copy = 0; copy < 3000; ++copy) {
    std::string other = body;
    for (int change = 0; change < 2; ++change) other[random() % other.size()] = static_cast<char>(random());
    const auto map = mapFromFileBytes("m.strata", withBody(file, other));
    refused += !map;
    if (map) {
      EXPECT_TRUE(mapFromFileBytes("again", mapFileBytes(*map)));
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(IntervalsCsv, ReadsBackToTheSameBits) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const double cells[] = {0.05, 0.1, 1.0 / 3, 0.07, 2.5e-3};
    RecordMap map = randomStoredMap("s", seed, 60 * (seed + 1), cells[seed % 5]).map;
    for (CellRecord& r : map.records) r.interval.max = std::nextafter(r.interval.max, 1e9f);
    const auto back = intervalsFromCsv("m.csv", intervalsCsv(map));
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_TRUE(*back == map);
  }
}

TEST(IntervalsCsv, HostileTablesAreRefused) {
  const std::string good =
      "k,l,x,y,min,max,points,objects\n-1,1,-0.25,0.75,-0.5,-0.5,1,1\n2,-2,1.25,-0.75,0.1,0.1,1,1;7\n"
      "2,-2,1.25,-0.75,2.25,2.25,1,\n";
  ASSERT_TRUE(intervalsFromCsv("m.csv", good));
  const auto refused = [&](const std::string& text, const std::string& where) {
    const auto map = intervalsFromCsv("m.csv", text);
    ASSERT_FALSE(map) << "accepted: " << text;
    EXPECT_EQ(map.error().file, "m.csv");
    EXPECT_EQ(map.error().where, where) << map.error().message();
    EXPECT_FALSE(map.error().remedy.empty());
  };
  refused("", "line 1");
  refused("k,l,x,y,min,max,points\n", "line 1");
  refused("k,l,x,y,min,max,points,objects\n", "");
  refused("\xEF\xBB\xBF" + good, "line 1");
  refused(good.substr(0, good.size() - 1), "line 4");
  refused(good + "\n", "line 5");
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"-1,1,", "-1,1,1,"},
                                                        {"-1,1,", "1,"},
                                                        {"-1,1,", "-1.5,1,"},
                                                        {"-1,1,", " -1,1,"},
                                                        {"-1,1,", "x,1,"},
                                                        {"-1,1,", "99999999999,1,"},
                                                        {"-1,1,", ",1,"},
                                                        {"-0.25", "nan"},
                                                        {"0.75", "inf"},
                                                        {"-0.5,-0.5", "-0,5,-0.5"},
                                                        {"-0.5,-0.5", "a,-0.5"},
                                                        {"-0.5,-0.5", "-0.5,nan"},
                                                        {"-0.5,-0.5", "1e99,-0.5"},
                                                        {"-0.5,1,1", "-0.5,-1,1"},
                                                        {"-0.5,1,1", "-0.5,1.5,1"},
                                                        {"-0.5,1,1", "-0.5,4294967296,1"},
                                                        {"-0.5,1,1", "-0.5,1,a"},
                                                        {"-0.5,1,1", "-0.5,1,1;"},
                                                        {"-0.5,1,1", "-0.5,1,;1"},
                                                        {"-0.5,1,1", "-0.5,1,1,1"},
                                                        {"-0.5,1,1", "-0.5,1,-1"}})
    refused(replaced(good, from, to), "line 2");
  refused(replaced(good, "-0.25,0.75", "-0.25,0.7500001"), "");  // no cell size gives these centres
  refused(replaced(good, "-0.25,0.75", "0.25,0.75"), "");
}

}  // namespace
}  // namespace stratascope
