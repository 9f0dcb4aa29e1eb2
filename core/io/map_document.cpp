// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "io/export.h"
#include "io/map_file.h"
#include "io/strict_json.h"
#include "params/param_table.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMax32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 53;  // exact in every JSON reader

/// Takes what a map needs out of a document; keeps the first problem.
class DocumentReader {
public:
  explicit DocumentReader(std::string path) : path_(std::move(path)) {}

  const Json& need(const Json& object, const char* key, const std::string& place) {
    static const Json nothing;
    if (object.is_object() && object.contains(key)) return object[key];
    return fail(place + key, "missing"), nothing;
  }
  std::uint64_t count(const Json& object, const char* key, const std::string& place, std::uint64_t most) {
    const Json& value = need(object, key, place);
    if (failed()) return 0;
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
      return fail(place + key, "not a whole number from 0 to " + std::to_string(most)), 0;
    return value.get<std::uint64_t>();
  }
  void fail(const std::string& key, const std::string& what) {
    if (!error_)
      error_ =
          Error{path_, "key " + key, what, "restore the file as the program wrote it, or make the map again"};
  }
  bool failed() const { return error_.has_value(); }
  const std::optional<Error>& error() const { return error_; }

private:
  std::string path_;
  std::optional<Error> error_;
};

/// What of an input's entry goes along with a map: not where its file lay, which differs from run to run.
Json entryOf(const Json& input, const Json& version, const Json& parameters) {
  Json entry = input;
  for (const char* key : {"path", "notes", "label_base", "label_count"}) entry.erase(key);
  if (!entry.contains("version")) entry["version"] = version;
  if (!entry.contains("parameters")) entry["parameters"] = parameters;
  return entry;
}

Eigen::Vector3d originIn(DocumentReader& reader, const Json& input, const std::string& place) {
  const Json& list = input["local_origin"];
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (!list.is_array() || list.size() != 3)
    return reader.fail(place + "local_origin", "not three numbers"), origin;
  for (size_t i = 0; i < 3; ++i)
    if (list[i].is_number())
      origin[static_cast<Eigen::Index>(i)] = list[i].get<double>();
    else
      reader.fail(place + "local_origin", "not three numbers");
  return origin;
}

MapSource sourceOf(DocumentReader& reader, const Json& input, const Json& document, size_t number,
                   std::uint64_t& base) {
  const std::string place = "inputs[" + std::to_string(number) + "].";
  MapSource source;
  const Json& name = reader.need(input, "name", place);
  if (!reader.failed() && !name.is_string()) reader.fail(place + "name", "not a text");
  std::uint64_t labels = 0;
  if (input.is_object() && input.contains("label_count")) {
    base = reader.count(input, "label_base", place, kMax32);
    labels = reader.count(input, "label_count", place, kMax32);
  } else {  // a run numbers its planes by neuron, scan after scan
    const std::uint64_t lines = reader.count(input, "lines", place, kMax32);
    labels = lines * reader.count(input, "beams", place, kMax32);
  }
  source.points = reader.count(input, "points", place, kMaxCount);
  if (input.is_object() && input.contains("local_origin"))
    source.localOrigin = originIn(reader, input, place);
  if (!reader.failed() && (labels > kMax32 || base > kMax32 - labels))
    reader.fail(place + "label_count", "more labels than 32 bits can count");
  if (reader.failed()) return source;
  source.name = name.get<std::string>();
  source.labelBase = static_cast<PlaneLabel>(base);
  source.labelCount = static_cast<PlaneLabel>(labels);
  const Json unknown;
  source.json = jsonLine(entryOf(input, document.contains("version") ? document["version"] : unknown,
                                 document.contains("parameters") ? document["parameters"] : unknown));
  base += labels;
  return source;
}

}  // namespace

StoredMap storedMapOf(const Snapshot& snapshot, const std::string& run) {
  require(snapshot.intervalMap != nullptr, "storedMapOf: no interval map");
  size_t records = 0;
  Expected<StoredMap> stored = mapFromDocument(run, "run.json", records);
  require(stored && records == snapshot.intervalMap->records.size(),
          "storedMapOf: the document of another run");
  stored->map = recordMapOf(*snapshot.intervalMap, snapshot.objectMap.get(), snapshot.params.intervals);
  return *std::move(stored);
}

std::string mapDocument(const StoredMap& stored) {
  Json document;
  document["program"] = "stratascope";
  document["version"] = versionText();
  document["inputs"] = Json::array();
  std::uint64_t points = 0;
  for (const MapSource& source : stored.sources) {
    Json entry = Json::parse(source.json);
    entry["label_base"] = source.labelBase;
    entry["label_count"] = source.labelCount;
    document["inputs"].push_back(std::move(entry));
  }
  for (const CellRecord& r : stored.map.records) points += r.interval.points;
  PipelineParams params;
  params.intervals = stored.map.intervals;
  document["parameters"] = {{"cell", stored.map.cell},
                            {"epsilon", stored.map.intervals.epsilon},
                            {"intervals", paramText(*findParam("intervals"), params)}};
  document["points"] = points;
  document["counts"] = {{"scans", stored.sources.size()},
                        {"cells", stored.map.cells()},
                        {"records", stored.map.records.size()},
                        {"objects", stored.map.objects.size()}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Expected<StoredMap> mapFromDocument(const std::string& text, const std::string& path, size_t& records) {
  const Expected<Json> parsed = parseStrictJson(text, path);
  if (!parsed) return parsed.error();
  const Json& document = *parsed;
  DocumentReader reader(path);
  StoredMap stored;
  if (reader.need(document, "program", "") != "stratascope") reader.fail("program", "not \"stratascope\"");

  const Json& parameters = reader.need(document, "parameters", "");
  PipelineParams params;
  for (const char* key : {"cell", "epsilon", "intervals"}) {
    const Json& value = reader.need(parameters, key, "parameters.");
    if (reader.failed()) break;
    const bool wordWanted = findParam(key)->kind == ParamKind::Choice;
    if (wordWanted ? !value.is_string() : !value.is_number())
      reader.fail(std::string("parameters.") + key, wordWanted ? "not a word" : "not a number");
    const std::string word = value.is_string() ? value.get<std::string>() : jsonLine(value);
    if (const Status set = setParam(params, key, word); !set)
      reader.fail(std::string("parameters.") + key, set.error().what);
  }
  if (const auto problems = params.validate(); !problems.empty()) reader.fail("parameters", problems.front());
  stored.map.cell = params.grid.cell;
  stored.map.intervals = params.intervals;

  const Json& inputs = reader.need(document, "inputs", "");
  if (!reader.failed() && (!inputs.is_array() || inputs.empty()))
    reader.fail("inputs", "not a list of scans");
  std::uint64_t base = 0;
  for (size_t i = 0; !reader.failed() && i < inputs.size(); ++i) {
    const std::uint64_t end = base;
    stored.sources.push_back(sourceOf(reader, inputs[i], document, i, base));
    if (!reader.failed() && stored.sources.back().localOrigin != stored.sources.front().localOrigin)
      reader.fail("inputs[" + std::to_string(i) + "].local_origin", "another than that of the first input");
    if (!reader.failed() && stored.sources.back().labelBase < end)
      reader.fail("inputs[" + std::to_string(i) + "].label_base", "labels of two scans overlap");
  }
  if (!reader.failed())
    records = reader.count(reader.need(document, "counts", ""), "records", "counts.", kMax32);
  if (reader.failed()) return *reader.error();
  return stored;
}

}  // namespace stratascope
