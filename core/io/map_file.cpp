// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/file_util.h"
#include "io/map_rules.h"
#include "io/strict_json.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;
static_assert(std::endian::native == std::endian::little, "map files are little-endian");

constexpr std::string_view kMagic = "stratascope-map ";
constexpr std::string_view kFirstLine = "stratascope-map 1\n";
constexpr size_t kChecksumBytes = 32;
constexpr std::uint32_t kMaxJsonBytes = 16u << 20;
constexpr size_t kMinCellBytes = 2 + 1, kMinRecordBytes = 4 + 4 + 1 + 1;
constexpr const char* kRemedy = "copy the file again, or make the map again";

void appendCount(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>((value & 0x7f) | 0x80);
  bytes += static_cast<char>(value);
}

template <class T>
void appendRaw(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string checksumOf(std::string_view bytes) {
  const std::string hex = sha256Hex(bytes);
  std::string raw;
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  for (size_t i = 0; i < hex.size(); i += 2) raw += static_cast<char>(digit(hex[i]) << 4 | digit(hex[i + 1]));
  return raw;
}

/// Smallest l of all cells.
std::int32_t lowestRow(const RecordMap& map) {
  std::int32_t l = std::numeric_limits<std::int32_t>::max();
  for (const CellRecord& r : map.records) l = std::min(l, r.cell.l);
  return l;
}

/// Walks the cells; after the first problem every number is 0 and error() tells where.
class BodyReader {
public:
  BodyReader(std::string_view bytes, size_t firstByte) : bytes_(bytes), first_(firstByte) {}

  std::uint64_t count(std::uint64_t most) {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      if (at_ == bytes_.size()) return fail("ends in the middle of a cell"), 0;
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) {
        if (shift > 0 && byte == 0) return fail("a number is written longer than it is"), 0;
        break;
      }
      if (shift == 56) return fail("a number has more than 64 bits"), 0;
    }
    if (value > most) return fail("a number is too large"), 0;
    return value;
  }
  float height() {
    float value = 0;
    if (bytes_.size() - at_ < sizeof value) return fail("ends in the middle of a record"), 0.0f;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  bool atEnd() const { return at_ == bytes_.size(); }
  void fail(const std::string& what) {
    if (what_.empty()) what_ = what, where_ = first_ + at_;
  }
  bool failed() const { return !what_.empty(); }
  Error error(const std::string& path) const {
    return {path, "byte " + std::to_string(where_), what_, kRemedy};
  }

private:
  std::string_view bytes_;
  size_t first_, at_ = 0, where_ = 0;
  std::string what_;
};

/// What the JSON tells of the body.
struct Announced {
  std::int64_t kMin = 0, lMin = 0;
  std::uint64_t cells = 0, records = 0, objects = 0;
};

Expected<Announced> announcedIn(const Json& document, const std::string& path) {
  const auto whole = [&](const char* group, const char* key) -> std::optional<std::int64_t> {
    if (!document.contains(group) || !document[group].is_object() || !document[group].contains(key))
      return {};
    const Json& value = document[group][key];
    if (!value.is_number_integer()) return {};
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > (std::uint64_t{1} << 53)) return {};
    return value.get<std::int64_t>();
  };
  const auto kMin = whole("window", "k_min"), lMin = whole("window", "l_min");
  const auto cells = whole("counts", "cells"), records = whole("counts", "records"),
             objects = whole("counts", "objects");
  constexpr std::int64_t kLowest = std::numeric_limits<std::int32_t>::min();
  constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();
  if (!kMin || !lMin || *kMin < kLowest || *kMin > kHighest || *lMin < kLowest || *lMin > kHighest)
    return Error{path, "key window", "no usable k_min and l_min", kRemedy};
  if (!cells || !records || !objects || *cells < 1 || *records < *cells || *objects < 0)
    return Error{path, "key counts", "no usable cells, records and objects", kRemedy};
  return Announced{*kMin, *lMin, static_cast<std::uint64_t>(*cells), static_cast<std::uint64_t>(*records),
                   static_cast<std::uint64_t>(*objects)};
}

void readRecords(BodyReader& in, CellIndex cell, std::uint64_t count, RecordMap& map) {
  constexpr std::uint64_t kMax32 = std::numeric_limits<std::uint32_t>::max();
  for (std::uint64_t i = 0; i < count && !in.failed(); ++i) {
    CellRecord record{cell, {}};
    record.interval.min = in.height();
    record.interval.max = in.height();
    record.interval.points = static_cast<std::uint32_t>(in.count(kMax32));
    const std::uint64_t objects = in.count(kMax32);
    std::uint64_t label = 0;
    for (std::uint64_t j = 0; j < objects && !in.failed(); ++j) {
      label += in.count(kMax32) + (j > 0 ? 1 : 0);
      if (label > kMax32) in.fail("a label has more than 32 bits");
      if (!in.failed()) map.objects.push_back(static_cast<PlaneLabel>(label));
    }
    map.records.push_back(record);
    map.firstObject.push_back(static_cast<std::uint32_t>(map.objects.size()));
  }
}

void readCells(BodyReader& in, const Announced& announced, RecordMap& map) {
  constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();
  constexpr std::uint64_t kMax32 = std::numeric_limits<std::uint32_t>::max();
  std::int64_t k = announced.kMin, l = announced.lMin - 1, lowest = kHighest;
  std::uint64_t cells = 0;
  for (; !in.atEnd() && !in.failed(); ++cells) {
    const auto columns = static_cast<std::int64_t>(in.count(kMax32));
    const auto rows = static_cast<std::int64_t>(in.count(kMax32));
    if (cells == 0 && columns != 0) in.fail("the first cell does not lie in column k_min");
    k += columns;
    l = (columns > 0 ? announced.lMin : l + 1) + rows;
    if (k > kHighest || l > kHighest) in.fail("a cell lies beyond 32 bits");
    const std::uint64_t records = in.count(kMax32);
    if (records == 0) in.fail("a cell has no record");
    if (in.failed()) return;
    lowest = std::min(lowest, l);
    readRecords(in, {static_cast<std::int32_t>(k), static_cast<std::int32_t>(l)}, records, map);
  }
  if (cells != announced.cells || map.records.size() != announced.records ||
      map.objects.size() != announced.objects)
    in.fail("not as many cells, records or objects as the file says it has");
  if (lowest != announced.lMin) in.fail("no cell lies in row l_min");
}

}  // namespace

std::string mapFileBytes(const StoredMap& stored) {
  const RecordMap& map = stored.map;
  require(!map.records.empty() && map.firstObject.size() == map.records.size() + 1 && !stored.sources.empty(),
          "mapFileBytes: a map without records or sources");
  const std::int32_t kMin = map.records.front().cell.k, lMin = lowestRow(map);
  Json document = Json::parse(mapDocument(stored));
  document["window"] = {{"k_min", kMin}, {"l_min", lMin}};
  const std::string json = jsonLine(document);
  require(json.size() <= kMaxJsonBytes, "mapFileBytes: too many sources");

  std::string bytes(kFirstLine);
  appendRaw(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += json;
  CellIndex last{kMin, lMin};
  for (size_t begin = 0; begin < map.records.size();) {
    const CellIndex cell = map.records[begin].cell;
    size_t end = begin + 1;
    while (end < map.records.size() && map.records[end].cell == cell) ++end;
    const std::int64_t columns = std::int64_t{cell.k} - last.k;
    const std::int64_t below = columns > 0 || begin == 0 ? lMin : std::int64_t{last.l} + 1;
    require(columns >= 0 && cell.l >= below, "mapFileBytes: cells out of order");
    appendCount(bytes, static_cast<std::uint64_t>(columns));
    appendCount(bytes, static_cast<std::uint64_t>(cell.l - below));
    appendCount(bytes, end - begin);
    for (size_t i = begin; i < end; ++i) {
      appendRaw(bytes, map.records[i].interval.min);
      appendRaw(bytes, map.records[i].interval.max);
      appendCount(bytes, map.records[i].interval.points);
      const auto objects = map.objectsOf(i);
      appendCount(bytes, objects.size());
      for (size_t j = 0; j < objects.size(); ++j)
        appendCount(bytes, j == 0 ? objects[0] : objects[j] - objects[j - 1] - 1);
    }
    last = cell;
    begin = end;
  }
  return bytes + checksumOf(bytes);
}

bool looksLikeMapFile(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

Expected<StoredMap> mapFromFileBytes(const std::string& path, std::string_view bytes) {
  if (!looksLikeMapFile(bytes))
    return Error{path, "byte 0", "not a map file of this program", "give a .strata file"};
  if (!bytes.starts_with(kFirstLine))
    return Error{path, "line 1", "a version of the format that is not known here", "use a newer program"};
  const size_t jsonAt = kFirstLine.size() + 4;
  if (bytes.size() < jsonAt + kChecksumBytes) return Error{path, "", "the file is cut short", kRemedy};
  const std::string_view sealed = bytes.substr(0, bytes.size() - kChecksumBytes);
  if (checksumOf(sealed) != bytes.substr(sealed.size()))
    return Error{path, "", "its checksum is wrong: the file is damaged or cut short", kRemedy};
  std::uint32_t jsonBytes = 0;
  std::memcpy(&jsonBytes, bytes.data() + kFirstLine.size(), 4);
  if (jsonBytes > kMaxJsonBytes || jsonBytes > sealed.size() - jsonAt)
    return Error{path, "byte " + std::to_string(kFirstLine.size()), "the length of its header is wrong",
                 kRemedy};
  const std::string json(bytes.substr(jsonAt, jsonBytes));

  size_t records = 0;
  Expected<StoredMap> stored = mapFromDocument(json, path, records);
  if (!stored) return stored;
  const Expected<Announced> announced = announcedIn(Json::parse(json), path);
  if (!announced) return announced.error();
  const std::string_view body = sealed.substr(jsonAt + jsonBytes);
  if (announced->cells > body.size() / kMinCellBytes || announced->records > body.size() / kMinRecordBytes ||
      announced->objects > body.size())
    return Error{path, "key counts", "more than the file's bytes can hold", kRemedy};
  stored->map.records.reserve(announced->records);
  stored->map.firstObject.reserve(announced->records + 1);
  stored->map.objects.reserve(announced->objects);
  BodyReader in(body, jsonAt + jsonBytes);
  readCells(in, *announced, stored->map);
  if (in.failed()) return in.error(path);
  if (const auto problem = problemOf(*stored))
    return Error{path, "record " + std::to_string(problem->record + 1), problem->what, kRemedy};
  return stored;
}

}  // namespace stratascope
