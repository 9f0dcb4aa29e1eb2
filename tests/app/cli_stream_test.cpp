// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Drives serve and stream of the real stratascope-cli against each other.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/file_util.h"
#include "support/scan_files.h"

namespace {

using namespace std::chrono_literals;
using nlohmann::json;
namespace test = stratascope::test;

std::ptrdiff_t linesIn(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// A stratascope-cli that runs beside the test; its outputs go into files.
class Process {
public:
  Process(const test::TemporaryFolder& folder, const std::string& name, std::vector<std::string> arguments)
      : out_(folder / (name + ".out")), err_(folder / (name + ".err")) {
    arguments.insert(arguments.begin(), STRATASCOPE_CLI);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    id_ = fork();
    if (id_ == 0) {
      for (const auto& [path, fd] : {std::pair{out_, STDOUT_FILENO}, {err_, STDERR_FILENO}})
        dup2(open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), fd);
      execv(argv[0], argv.data());
      _exit(127);
    }
  }
  ~Process() {
    if (id_ > 0) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  void interrupt() const { kill(id_, SIGINT); }
  /// Exit status; −1 if it does not end in a long time.
  int wait() {
    for (int i = 0; i < 6000; ++i) {
      int status = 0;
      if (waitpid(id_, &status, WNOHANG) == id_) {
        id_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      }
      std::this_thread::sleep_for(10ms);
    }
    return -1;
  }
  std::string out() const { return stratascope::readFile(out_).value(); }
  std::string err() const { return stratascope::readFile(err_).value(); }
  /// The first line of its output, once it is there.
  std::string firstLine() const {
    for (int i = 0; i < 3000; ++i) {
      const auto text = stratascope::readFile(out_);
      if (text && text->find('\n') != std::string::npos) return text->substr(0, text->find('\n'));
      std::this_thread::sleep_for(10ms);
    }
    return "";
  }

private:
  std::string out_, err_;
  pid_t id_ = -1;
};

class CliStream : public testing::Test {
protected:
  void SetUp() override {
    test::putFile(folder_ / "scene.json",
                  R"({"name": "cell", "scanner": {"position": [0, 0, 1], "lines": 60, "beams": 61},
                      "items": [{"shape": "room", "base": [0, 0, 0], "size": [6, 5, 3]},
                                {"shape": "box", "name": "crate", "corner": [2, 0, 0], "size": [0.5, 0.5, 1]}]})");
    Process simulate(folder_, "simulate", {"simulate", folder_ / "scene.json", "-o", folder_ / "scan.pcd"});
    ASSERT_EQ(simulate.wait(), 0) << simulate.err();
  }
  std::string file(const std::string& directory, const std::string& name) {
    return stratascope::readFile((std::filesystem::path(folder_ / directory) / name).string()).value();
  }
  /// A cloud without the comments that say where it came from.
  std::string cloud(const std::string& directory) {
    const std::string bytes = file(directory, "cloud.pcd");
    return bytes.substr(bytes.find("\nVERSION"));
  }
  json run(const std::string& directory) { return json::parse(file(directory, "run.json")); }

  test::TemporaryFolder folder_;
};

TEST_F(CliStream, ServeAndStreamEndWithTheFilesOfProcess) {
  Process process(folder_, "process",
                  {"process", folder_ / "scan.pcd", "--out", folder_ / "p", "--epsilon", "0.2"});
  ASSERT_EQ(process.wait(), 0) << process.err();
  Process serve(folder_, "serve", {"serve", folder_ / "scan.pcd", "--port", "0", "--speed", "20", "--once"});
  const std::string address = serve.firstLine();
  ASSERT_TRUE(address.starts_with("tcp://127.0.0.1:")) << serve.err();
  Process stream(folder_, "stream",
                 {"stream", address, "--out", folder_ / "s", "--epsilon", "0.2", "--json"});
  ASSERT_EQ(stream.wait(), 0) << stream.err();
  EXPECT_EQ(serve.wait(), 0) << serve.err();
  for (const char* name : {"planes.json", "edges.json", "height_map.asc", "intervals.csv"})
    EXPECT_EQ(file("s", name), file("p", name)) << name;
  EXPECT_EQ(cloud("s"), cloud("p"));
  EXPECT_EQ(stream.out(), file("s", "run.json"));
  const json document = run("s");
  EXPECT_EQ(document["parameters"], run("p")["parameters"]);
  EXPECT_EQ(document["inputs"][0]["path"], address);
  EXPECT_TRUE(document["inputs"][0]["sha256"].is_null());
  EXPECT_EQ(document["stream"]["received"], 60);
  for (const char* key : {"missing", "dropped", "bad_crc", "resynchronised", "duplicated", "out_of_order"})
    EXPECT_EQ(document["stream"][key], 0) << key;
}

TEST_F(CliStream, AReplayIsToldByItsAddressAndASceneByItsNoiseAndHead) {
  const auto done = [&](const std::string& name, std::vector<std::string> arguments) {
    Process process(folder_, name, std::move(arguments));
    EXPECT_EQ(process.wait(), 0) << process.err();
  };
  done("p", {"process", folder_ / "scan.pcd", "--out", folder_ / "p"});
  done("r", {"stream", "replay:" + (folder_ / "scan.pcd"), "--speed", "0", "--out", folder_ / "r"});
  EXPECT_EQ(cloud("r"), cloud("p"));
  EXPECT_EQ(run("r")["inputs"][0]["sha256"], run("p")["inputs"][0]["sha256"]);
  done("simulate", {"simulate", folder_ / "scene.json", "--noise", "none", "-o", folder_ / "still.pcd"});
  done("n", {"process", folder_ / "still.pcd", "--out", folder_ / "n"});
  const std::string scene = "replay:" + (folder_ / "scene.json");
  done("s", {"stream", scene, "--speed", "0", "--noise", "none", "--out", folder_ / "s"});
  EXPECT_EQ(cloud("s"), cloud("n"));
  done("t", {"stream", scene, "--speed", "0", "--noise", "none", "--head", "turns", "--out", folder_ / "t"});
  EXPECT_NE(cloud("t"), cloud("n"));
}

TEST_F(CliStream, InterruptKeepsWhatArrived) {
  Process serve(
      folder_, "serve",
      {"serve", folder_ / "scene.json", "--port", "0", "--speed", "2", "--loop", "--moving", "crate"});
  const std::string address = serve.firstLine();
  Process stream(folder_, "stream", {"stream", address, "--out", folder_ / "s"});
  for (int i = 0; i < 6000 && serve.err().find("listener") == std::string::npos; ++i)
    std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(700ms);
  stream.interrupt();
  EXPECT_EQ(stream.wait(), 0) << stream.err();
  serve.interrupt();
  EXPECT_EQ(serve.wait(), 0) << serve.err();
  const json document = run("s");
  EXPECT_GT(document["stream"]["received"], 0);
  EXPECT_EQ(document["inputs"][0]["lines"], 60);
}

TEST_F(CliStream, AReplayNeedsNoSocket) {
  Process process(folder_, "process", {"process", folder_ / "scan.pcd", "--out", folder_ / "p"});
  Process stream(folder_, "stream", {"stream", folder_ / "scan.pcd", "--speed", "0", "--out", folder_ / "s"});
  ASSERT_EQ(process.wait(), 0);
  ASSERT_EQ(stream.wait(), 0) << stream.err();
  EXPECT_EQ(file("s", "intervals.csv"), file("p", "intervals.csv"));
  EXPECT_NE(stream.out().find("received"), std::string::npos);
}

TEST_F(CliStream, WhatCannotBeIsSaid) {
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& word) {
    Process process(folder_, "bad", arguments);
    EXPECT_EQ(process.wait(), status) << process.err();
    EXPECT_EQ(process.out(), "");
    EXPECT_EQ(linesIn(process.err()), 1) << process.err();
    EXPECT_NE(process.err().find(word), std::string::npos) << process.err();
    EXPECT_FALSE(std::filesystem::exists(folder_ / "o"));
  };
  test::putFile(folder_ / "cloud.xyz", "1 0 0\n0 1 0.5\n1 1 1\n2 0 0\n0 2 0.5\n2 2 1\n");
  const std::string scan = folder_ / "scan.pcd", out = folder_ / "o";
  refused({"serve", scan}, 2, "--port");
  refused({"serve", scan, "--port", "70000"}, 2, "--port");
  refused({"serve", scan, "--port", "0", "--speed", "-1"}, 2, "--speed");
  refused({"serve", scan, "--port", "0", "--once", "--loop"}, 2, "--once");
  refused({"serve", folder_ / "absent.pcd", "--port", "0"}, 1, "absent.pcd");
  refused({"serve", folder_ / "cloud.xyz", "--port", "0"}, 1, "cloud.xyz");
  refused({"serve", scan, "--port", "0", "--bind", "203.0.113.7"}, 1, "203.0.113.7");
  refused({"serve", folder_ / "scene.json", "--port", "0", "--moving", "ghost"}, 1, "ghost");
  refused({"stream", "tcp://127.0.0.1:1"}, 2, "--out");
  refused({"stream", "tcp://127.0.0.1", "--out", out}, 2, "tcp://127.0.0.1");
  refused({"stream", "serial:/dev/absent", "--give-up", "0.3", "--out", out}, 1, "/dev/absent");
  refused({"stream", "tcp://127.0.0.1:1", "--give-up", "0.3", "--out", out}, 1, "127.0.0.1:1");
  refused({"stream", folder_ / "absent.pcd", "--out", out}, 1, "absent.pcd");
}

}  // namespace
