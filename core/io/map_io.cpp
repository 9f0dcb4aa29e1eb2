// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_io.h"

#include <algorithm>
#include <filesystem>

#include "io/export.h"
#include "io/file_util.h"
#include "io/geotiff.h"
#include "io/map_csv.h"
#include "io/map_rules.h"
#include "io/mesh_export.h"
#include "io/number_text.h"
#include "io/strict_json.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxDocumentBytes = 16u << 20;
constexpr const char* kReadable = "give a .strata file, an intervals.csv, or the directory of a run";

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The document that tells of a table: its own, or that of its run.
std::optional<fs::path> documentBeside(const fs::path& table) {
  for (const fs::path& path : {fs::path(table.string() + ".json"), table.parent_path() / "run.json"})
    if (isThere(path)) return path;
  return {};
}

/// A table nobody tells anything of is its own source.
MapSource sourceOfTable(const std::string& path, std::string_view bytes, const RecordMap& map) {
  MapSource source;
  source.name = fs::path(path).filename().string();
  for (const CellRecord& r : map.records) source.points += r.interval.points;
  source.labelCount = map.objects.empty() ? 0 : *std::max_element(map.objects.begin(), map.objects.end());
  Json entry;
  entry["name"] = source.name;
  entry["bytes"] = bytes.size();
  entry["sha256"] = sha256Hex(bytes);
  entry["format"] = "intervals.csv";
  entry["points"] = source.points;
  entry["version"] = nullptr;
  entry["parameters"] = {{"cell", map.cell}, {"epsilon", map.intervals.epsilon}, {"intervals", "linked"}};
  source.json = jsonLine(entry);
  return source;
}

Expected<OpenedMap> readTable(const std::string& path, std::string_view bytes,
                              const MapAssumptions& assumptions) {
  OpenedMap opened{path, {}, {}};
  if (const auto beside = documentBeside(path)) {
    const auto text = readFile(beside->string(), kMaxDocumentBytes);
    if (!text) return text.error();
    size_t records = 0;
    auto told = mapFromDocument(*text, beside->string(), records);
    if (!told) return told.error();
    auto map = intervalsFromCsv(path, bytes, told->map.cell);
    if (!map) return map.error();
    if (map->records.size() != records)
      return Error{path, "",
                   "it has " + std::to_string(map->records.size()) + " records, but " + beside->string() +
                       " tells of " + std::to_string(records),
                   "the table is cut short, or not of that run: keep a table with its own document"};
    map->intervals = told->map.intervals;
    opened.stored = *std::move(told);
    opened.stored.map = *std::move(map);
  } else {
    auto map = intervalsFromCsv(path, bytes, assumptions.cell);
    if (!map) return map.error();
    if (assumptions.epsilon) map->intervals.epsilon = *assumptions.epsilon;
    opened.stored.sources.push_back(sourceOfTable(path, bytes, *map));
    opened.stored.map = *std::move(map);
    opened.notes.push_back(path + ": no run.json beside it, so it is taken as linked with epsilon " +
                           numberText(opened.stored.map.intervals.epsilon) + " m, cell " +
                           numberText(opened.stored.map.cell) + " m.");
  }
  if (const auto problem = problemOf(opened.stored))
    return Error{path, "line " + std::to_string(problem->record + 2), problem->what,
                 "give the intervals.csv that process or merge wrote, and what it was made with"};
  return opened;
}

}  // namespace

Expected<OpenedMap> readMap(const std::string& path, const MapAssumptions& assumptions) {
  std::string file = path;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    file = (fs::path(path) / "map.strata").string();
    if (!isThere(file)) file = (fs::path(path) / "intervals.csv").string();
    if (!isThere(file))
      return Error{path, "", "neither map.strata nor intervals.csv in this directory", kReadable};
  }
  const auto bytes = readFile(file);
  if (!bytes) return bytes.error();
  if (looksLikeMapFile(*bytes)) {
    auto stored = mapFromFileBytes(file, *bytes);
    if (!stored) return stored.error();
    return OpenedMap{file, *std::move(stored), {}};
  }
  if (bytes->starts_with("k,l,")) return readTable(file, *bytes, assumptions);
  return Error{file, "", "not a map: neither a .strata file nor a table of intervals", kReadable};
}

Expected<std::vector<OutputFile>> mapFiles(const StoredMap& stored, const std::string& path,
                                           std::string& directory) {
  const fs::path target(path);
  const std::string name = target.filename().string(), extension = target.extension().string();
  std::error_code ignored;
  const bool isDirectory = name.empty() || extension.empty() || fs::is_directory(target, ignored);
  directory = isDirectory ? path : target.parent_path().empty() ? "." : target.parent_path().string();
  if (!isDirectory && extension == ".strata") return std::vector<OutputFile>{{name, mapFileBytes(stored)}};
  if (!isDirectory && extension == ".csv")
    return std::vector<OutputFile>{{name, intervalsCsv(stored.map)}, {name + ".json", mapDocument(stored)}};
  if (!isDirectory && (extension == ".ply" || extension == ".vtp")) {
    const QuadMesh mesh = intervalMesh(stored.map);
    const Provenance provenance = provenanceOf(mapDocument(stored));
    return std::vector<OutputFile>{
        {name, extension == ".ply" ? meshPly(mesh, provenance) : meshVtp(mesh, provenance)}};
  }
  if (!isDirectory && extension != ".asc" && extension != ".tif")
    return Error{path, "", "no kind of map is written with this extension",
                 "use .strata, .csv, .asc, .tif, .ply, .vtp or a directory"};
  auto heights = heightMapOf(stored.map);
  if (!heights) {
    Error error = heights.error();
    error.file = path;
    return error;
  }
  if (extension == ".tif" && !isDirectory) {
    auto bytes =
        heightMapGeoTiff(*heights, provenanceOf(mapDocument(stored)), stored.sources.front().localOrigin);
    if (!bytes) return bytes.error();
    return std::vector<OutputFile>{{name, *std::move(bytes)}};
  }
  if (!isDirectory)
    return std::vector<OutputFile>{{name, heightMapAsc(*heights)}, {name + ".json", mapDocument(stored)}};
  return std::vector<OutputFile>{{"intervals.csv", intervalsCsv(stored.map)},
                                 {"height_map.asc", heightMapAsc(*heights)},
                                 {"map.strata", mapFileBytes(stored)},
                                 {"run.json", mapDocument(stored)}};
}

}  // namespace stratascope
