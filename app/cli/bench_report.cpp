// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/bench_report.h"

#include <nlohmann/json.hpp>

#include "app/cli/json_value.h"
#include "app/cli/text_table.h"

namespace stratascope::cli {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::string milliseconds(double seconds) {
  return fixed(1e3 * seconds, seconds < 0.1 ? 2 : 0);
}

std::string kib(std::size_t bytes) {
  return fixed(static_cast<double>(bytes) / 1024, 0) + " KiB";
}

std::string perNeuron(double seconds, const BenchResult& r) {
  return fixed(1e9 * seconds / static_cast<double>(r.neurons), 1);
}

std::string normalsText(const std::optional<NormalQuality>& q) {
  return q ? fixed(q->medianDeg, 3) + "° / " + fixed(q->ninetyDeg, 2) + "° / " + fixed(100 * q->within10, 1) +
                 "%"
           : "";
}

std::string stagesText(const std::vector<Stage>& stages) {
  std::string text;
  for (const Stage stage : stages) text += std::string(text.empty() ? "" : " ") + stageName(stage);
  return text;
}

/// Ours and the peers', one below the other.
std::string timesTable(const BenchResult& r) {
  const std::string threads = std::to_string(r.threads);
  Rows rows = {{"what", "threads", "ms", "ns/neuron", "normals: median / 90% / within 10°", "planes", "map"}};
  const auto add = [&](const std::string& what, const std::string& used, double seconds,
                       const std::string& normals = "", const std::string& planes = "",
                       const std::string& map = "") {
    rows.push_back({what, used, milliseconds(seconds), perNeuron(seconds, r), normals, planes, map});
  };
  const std::string planes =
      r.correct ? std::to_string(*r.correct) + " of " + std::to_string(r.truthPlanes.value_or(0)) : "";
  for (int s = 0; s < kStageCount; ++s) {
    const Stage stage = static_cast<Stage>(s);
    add(stageName(stage), threads, r.stages[static_cast<size_t>(s)],
        stage == Stage::Normals ? normalsText(r.normals) : "", stage == Stage::Planes ? planes : "",
        stage == Stage::HeightMap   ? kib(r.heightMapBytes)
        : stage == Stage::Intervals ? kib(r.intervalMapBytes)
                                    : "");
  }
  add("whole pipeline, new each time", threads, r.pipeline);
  add("whole pipeline, the same scan again", threads, r.again);
  if (r.threads > 1) add("whole pipeline, one thread", "1", r.oneThread);
  for (const BenchPeer& peer : r.peers)
    add(peer.name, std::to_string(peer.threads), peer.seconds, normalsText(peer.normals),
        peer.correct ? std::to_string(*peer.correct) + " of " + std::to_string(r.truthPlanes.value_or(0))
                     : "",
        peer.bytes ? kib(*peer.bytes) : "");
  return textTable(rows);
}

std::string changesTable(const BenchResult& r) {
  Rows rows = {{"changed", "ms", "stages that ran again"}};
  for (const BenchChange& change : r.changes)
    rows.push_back({change.parameter, milliseconds(change.seconds), stagesText(change.stages)});
  return textTable(rows);
}

std::string costsTable(const std::vector<ProcessCost>& costs) {
  Rows rows = {{"lattice", "neurons", "ms", "processor ms", "processor ns/neuron", "peak, file to result",
                "bytes/neuron"}};
  for (const ProcessCost& c : costs) {
    const auto neurons = static_cast<double>(c.neurons);
    rows.push_back({std::to_string(c.lines) + " x " + std::to_string(c.beams), std::to_string(c.neurons),
                    milliseconds(c.seconds), milliseconds(c.processorSeconds),
                    fixed(1e9 * c.processorSeconds / neurons, 1), kib(c.peakBytes),
                    fixed(static_cast<double>(c.peakBytes) / neurons, 0)});
  }
  return textTable(rows);
}

std::string goalsTable(const std::vector<BenchGoal>& goals) {
  Rows rows = {{"goal", "measured", "wanted", "in this run"}};
  for (const BenchGoal& g : goals)
    rows.push_back({g.text, fixed(g.value, g.decimals) + g.unit,
                    (g.atLeast ? "≥ " : "≤ ") + fixed(g.goal, g.decimals) + g.unit,
                    g.met() ? "met" : "missed"});
  return textTable(rows);
}

Json normalsJson(const std::optional<NormalQuality>& q) {
  if (!q) return nullptr;
  return {{"median_deg", q->medianDeg}, {"ninety_percent_deg", q->ninetyDeg}, {"within_10_deg", q->within10}};
}

}  // namespace

std::string benchText(const BenchReport& report) {
  const BenchResult& r = report.result;
  std::string text = report.scan + ": " + std::to_string(r.neurons) + " neurons, " +
                     std::to_string(r.points) + " points; " + std::to_string(r.threads) +
                     (r.threads == 1 ? " thread" : " threads") + ", median of " + std::to_string(r.runs) +
                     " runs\n" + timesTable(r);
  if (r.threads > 1)
    text += "\n" + std::to_string(r.threads) + " busy threads do " + fixed(r.busyGain, 2) +
            " times the work of one now; the pipeline gains " + fixed(r.oneThread / r.pipeline, 2) +
            " times; results of 1 and " + std::to_string(r.threads) +
            " threads: " + (r.sameBits ? "the same bits" : "DIFFERENT") + '\n';
  text += '\n' + changesTable(r);
  if (!report.costs.empty()) text += '\n' + costsTable(report.costs);
  if (const auto goals = benchGoals(r, report.costs); !goals.empty()) text += '\n' + goalsTable(goals);
  return text;
}

std::string benchJson(const BenchReport& report) {
  const BenchResult& r = report.result;
  Json document = {{"scan", report.scan},  {"neurons", r.neurons}, {"points", r.points},
                   {"threads", r.threads}, {"runs", r.runs},       {"seconds", Json::object()}};
  for (int s = 0; s < kStageCount; ++s)
    document["seconds"][stageName(static_cast<Stage>(s))] = r.stages[static_cast<size_t>(s)];
  document["seconds"]["pipeline"] = r.pipeline;
  document["seconds"]["pipeline_memory_at_hand"] = r.again;
  document["seconds"]["pipeline_one_thread"] = r.oneThread;
  document["busy_thread_gain"] = r.busyGain;
  document["same_bits"] = r.sameBits;
  document["normals"] = normalsJson(r.normals);
  document["planes"] = {{"true", orNull(r.truthPlanes)}, {"correct", orNull(r.correct)}};
  document["map_bytes"] = {{"height_map", r.heightMapBytes}, {"intervals", r.intervalMapBytes}};
  document["peers"] = Json::array();
  for (const BenchPeer& p : r.peers)
    document["peers"].push_back({{"key", p.key},
                                 {"name", p.name},
                                 {"threads", p.threads},
                                 {"seconds", p.seconds},
                                 {"bytes", orNull(p.bytes)},
                                 {"normals", normalsJson(p.normals)},
                                 {"correct", orNull(p.correct)}});
  document["changes"] = Json::array();
  for (const BenchChange& c : r.changes) {
    Json stages = Json::array();
    for (const Stage stage : c.stages) stages.push_back(stageName(stage));
    document["changes"].push_back({{"parameter", c.parameter}, {"seconds", c.seconds}, {"stages", stages}});
  }
  document["processes"] = Json::array();
  for (const ProcessCost& c : report.costs)
    document["processes"].push_back({{"lines", c.lines},
                                     {"beams", c.beams},
                                     {"neurons", c.neurons},
                                     {"seconds", c.seconds},
                                     {"processor_seconds", c.processorSeconds},
                                     {"peak_bytes", c.peakBytes}});
  document["goals"] = Json::array();
  for (const BenchGoal& g : benchGoals(r, report.costs))
    document["goals"].push_back({{"key", g.key},
                                 {"text", g.text},
                                 {"value", g.value},
                                 {"goal", g.goal},
                                 {"at_least", g.atLeast},
                                 {"met", g.met()}});
  document["notes"] = report.notes;
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace stratascope::cli
