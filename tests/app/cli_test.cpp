// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Drives the real stratascope-cli: exit statuses, messages, files. What the files say is tested where they
// are made.
#include "cli_support.h"
#include "params/param_table.h"

namespace stratascope::test {
namespace {

TEST_F(Cli, HelpAndVersionAreResults) {
  for (const std::string arguments :
       {"--help", "--version", "info --help", "process --help", "convert --help", "simulate --help",
        "score --help", "bench --help", "merge --help"}) {
    const Result r = run(arguments);
    EXPECT_EQ(r.status, 0) << arguments;
    EXPECT_NE(r.out, "") << arguments;
    EXPECT_EQ(r.err, "") << arguments;
  }
}

TEST_F(Cli, ProcessHelpHasEveryParameter) {
  const std::string help = run("process --help").out;
  for (const auto& info : stratascope::paramTable()) {
    std::string option = std::string("--") + info.key;
    std::replace(option.begin(), option.end(), '_', '-');
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
  EXPECT_NE(help.find("--pose"), std::string::npos);
  EXPECT_NE(help.find("pcl_viewer"), std::string::npos);
}

TEST_F(Cli, BadArgumentsAreStatusTwo) {
  expectRefused("", 2, {});
  expectRefused("paint", 2, {});
  expectRefused("info", 2, {"SCAN"});
  expectRefused("info room.pcd --colour", 2, {"--colour"});
  expectRefused("process room.pcd", 2, {"--out"});
  expectRefused("process --out o", 2, {"SCAN"});
  expectRefused("process room.pcd --session s.stratascope --out o", 2, {"--session", "SCAN"});
  expectRefused("process room.pcd --out o --epsilon abc", 2, {"--epsilon", "abc"});
  expectRefused("process room.pcd --out o --epsilon -1", 2, {"epsilon", "-1"});
  expectRefused("process room.pcd --out o --cell nan", 2, {"--cell"});
  expectRefused("process room.pcd --out o --epsilon2 0.3", 2, {"epsilon2", "epsilon1"});
  expectRefused("process room.pcd --out o --epsilon 0 --cell 0", 2, {"epsilon", "cell"});
  expectRefused("process room.pcd --out o --estimator best", 2, {"--estimator", "regression"});
  expectRefused("process room.pcd --out o --pose 1,2,3", 2, {"--pose"});
  expectRefused("process room.pcd room.pcd --out o --pose 1,2,3,0,0,0", 2, {"--pose"});
  expectRefused("process room.pcd --out o --threads -1", 2, {"--threads"});
  expectRefused("convert room.pcd", 2, {"OUT"});
  expectRefused("convert room.pcd room.png", 2, {"room.png", ".pcd"});
  expectRefused("simulate scene.json", 2, {"--out"});
  expectRefused("simulate scene.json -o s.pcd --noise loud", 2, {"loud"});
  expectRefused("simulate scene.json -o s.pcd --seed x", 2, {"--seed"});
  expectRefused("score room.pcd room.pcd --overlap 0.4", 2, {"--overlap"});
  expectRefused("merge -o m", 2, {"MAP"});
  expectRefused("merge a", 2, {"--out"});
  expectRefused("merge a -o m --epsilon x", 2, {"--epsilon"});
}

TEST_F(Cli, BadInputIsStatusOneAndNamesTheFile) {
  write("empty.pcd", "");
  write("cut.pcd", roomPcd(60, 90).substr(0, 3000));
  write("word.pcd",
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 "
        "1 0 0 0\n"
        "POINTS 1\nDATA ascii\n1 two 3\n");
  write("bad.json", "{\"epsilon\": ");
  write("unknown.json", "{\"epsilom1\": 0.3}");
  fs::create_directories(work_ / "folder");
  for (const std::string name : {"absent.pcd", "empty.pcd", "cut.pcd", "word.pcd"}) {
    expectRefused("info " + name, 1, {name});
    expectRefused("process " + name + " --out o", 1, {name});
    expectRefused("process room.pcd " + name + " --out o", 1, {name});
    expectRefused("convert " + name + " c.pcd", 1, {name});
    expectRefused("score room.pcd " + name, 1, {});
  }
  expectRefused("info word.pcd", 1, {"line 11", "two"});
  expectRefused("info folder", 1, {"folder"});
  expectRefused("process folder --out o", 1, {"folder", "scanNNN.3d"});
  expectRefused("simulate absent.json -o s.pcd", 1, {"absent.json"});
  expectRefused("simulate bad.json -o s.pcd", 1, {"bad.json"});
  expectRefused("simulate scene.json -o absent/s.pcd", 1, {"absent/s.pcd"});
  expectRefused("simulate scene.json -o s.pcd --truth absent/t.pcd", 1, {"absent/t.pcd"});
  expectRefused("process room.pcd --out o --params absent.json", 1, {"absent.json"});
  expectRefused("process room.pcd --out o --params bad.json", 1, {"bad.json"});
  expectRefused("process room.pcd --out o --params unknown.json", 1, {"unknown.json", "epsilon1"});
  expectRefused("process room.pcd --out room.pcd", 1, {"room.pcd"});
  expectRefused("score room.pcd room.pcd", 1, {"room.pcd", "label"});
}

TEST_F(Cli, MissingFilesDoNotReplaceOldResults) {
  write("c.pcd", "old");
  EXPECT_EQ(run("convert absent.pcd c.pcd").status, 1);
  EXPECT_EQ(contentsOf(work_ / "c.pcd"), "old");
}

}  // namespace
}  // namespace stratascope::test
