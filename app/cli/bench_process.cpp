// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/bench_process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/stopwatch.h"
#include "evaluate/statistics.h"
#include "io/file_util.h"
#include "io/scan_io.h"
#include "params/param_table.h"
#include "pipeline/pipeline.h"

extern char** environ;

namespace stratascope::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A folder of its own, gone with the object.
class ScratchFolder {
public:
  ScratchFolder() {
    std::error_code failed;
    std::string name = (fs::temp_directory_path(failed) / "stratascope-bench-XXXXXX").string();
    if (!failed && ::mkdtemp(name.data())) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  bool made() const { return !path_.empty(); }
  std::string file(const char* name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

/// Standard output of this program run with `arguments`; nothing if it fails.
std::optional<std::string> outputOf(const std::vector<std::string>& arguments) {
  int ends[2];
  if (::pipe(ends) != 0) return std::nullopt;
  std::vector<char*> argv;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  pid_t child = 0;
  const int failed = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string text;
  if (!failed) {
    char buffer[4096];
    for (ssize_t n; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
      text.append(buffer, static_cast<size_t>(n));
  }
  ::close(ends[0]);
  int status = 0;
  if (failed || ::waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return std::nullopt;
  return text;
}

}  // namespace

Status printCost(const std::string& file, const Settings& settings, const Execution& execution, int runs) {
  const std::size_t atStart = residentMemory().now;
  auto read = readScan(file);
  if (!read) return read.error();
  const ScanPtr scan = std::make_shared<const Scan>(std::move(*read));
  std::vector<double> seconds, processor;
  std::size_t peak = 0;
  // The first run tells the peak, and not the time: a virtual machine may have to fetch the memory that
  // nobody used so far from its host, which takes longer than the pipeline.
  for (int run = 0; run <= runs; ++run) {
    const Stopwatch watch;
    const std::clock_t before = std::clock();
    Pipeline pipeline;
    pipeline.setScans({scan});
    const auto result = pipeline.run(settings.params, execution);
    if (!result) return result.error();
    if (run == 0) {
      peak = residentMemory().peak;
      continue;
    }
    seconds.push_back(watch.seconds());
    processor.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  const Json document = {{"lines", scan->lattice->lines()},
                         {"beams", scan->lattice->beams()},
                         {"seconds", medianOf(seconds)},
                         {"processor_seconds", medianOf(processor)},
                         {"peak_bytes", peak - std::min(peak, atStart)}};
  std::cout << document.dump() << '\n';
  return success();
}

Expected<ProcessCost> costOfProcess(const Scan& scan, const PipelineParams& params, int threads, int runs) {
  const ScratchFolder folder;
  if (!folder.made())
    return Error{"", "temporary folder", "cannot be made", "give one that can be written in TMPDIR"};
  const std::string file = folder.file("scan.pcd"), parameters = folder.file("params.json");
  if (const Status written = writeScan(scan, file); !written) return written.error();
  if (const Status written = writeFileAtomically(parameters, paramsToJson(params)); !written)
    return written.error();
  const auto text = outputOf({"stratascope-cli", "bench", file, "--cost-only", "--params", parameters,
                              "--runs", std::to_string(runs), "--threads", std::to_string(threads)});
  const Json document = text ? Json::parse(*text, nullptr, false) : Json();
  if (!document.is_object())
    return Error{"", "the process that measures memory", "failed", "see what it said above"};
  ProcessCost cost;
  cost.lines = document.at("lines");
  cost.beams = document.at("beams");
  cost.neurons = static_cast<std::size_t>(cost.lines) * static_cast<std::size_t>(cost.beams);
  cost.seconds = document.at("seconds");
  cost.processorSeconds = document.at("processor_seconds");
  cost.peakBytes = document.at("peak_bytes");
  return cost;
}

}  // namespace stratascope::cli
