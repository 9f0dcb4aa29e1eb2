// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// sweep.
#include "cli_support.h"

namespace stratascope::test {
namespace {

TEST_F(Cli, SweepTellsWhatProcessFindsForEachValue) {
  const Result r = run("sweep room.pcd --param epsilon --from 0.05 --to 0.8 --steps 3 --cell 0.2 --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const json document = json::parse(r.out);
  EXPECT_EQ(document["parameter"], "epsilon");
  ASSERT_EQ(document["samples"].size(), 3u);
  for (const json& sample : document["samples"]) {
    ASSERT_EQ(run("process room.pcd --cell 0.2 --out out --epsilon " + sample["value"].dump()).status, 0);
    EXPECT_EQ(sample["records"], runDocument("out")["counts"]["records"]);
    EXPECT_EQ(sample["planes"], runDocument("out")["counts"]["planes"]);
  }
  EXPECT_GT(document["samples"][0]["records"], document["samples"][2]["records"]);
}

TEST_F(Cli, SweepWritesATableWithItsOrigin) {
  const Result r =
      run("sweep room.pcd --param plane-distance --from 0.01 --to 0.1 --steps 3 --geometric --csv s.csv");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(linesIn(r.out), 4u);
  const std::string csv = contentsOf(work_ / "s.csv");
  EXPECT_EQ(linesIn(csv), 8u);
  for (const char* part : {"# stratascope ", "# input \"room.pcd\" sha256 ",
                           "# sweep plane_distance from 0.01 to 0.1 in 3 geometric steps\n",
                           "\nplane_distance,planes,classified,", "\n0.0316228,"})
    EXPECT_NE(csv.find(part), std::string::npos) << part;
}

TEST_F(Cli, SweepRefusesWhatCannotBeSwept) {
  expectRefused("sweep room.pcd --param estimator --from 0 --to 2", 2, {"estimator", "not a number"});
  expectRefused("sweep room.pcd --param epsilonn --from 0.1 --to 2", 2, {"epsilonn", "did you mean epsilon"});
  expectRefused("sweep room.pcd --param cell --from 0 --to 2", 2, {"cell", "give 0.001 to 10"});
  expectRefused("sweep nothing.pcd --param cell --from 0.1 --to 2", 1, {"nothing.pcd"});
  expectRefused("sweep room.pcd --param cell --from 0.1 --to 1 --steps 2 --csv no/such/s.csv", 1,
                {"no/such"});
}

}  // namespace
}  // namespace stratascope::test
