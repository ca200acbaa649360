// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/lack_of_time.h>
#include <slalom/results/table_builder.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

const std::string kSentence =
    "nobody can arrive within 60 s: the shortest path takes at least 103.1 s at 0.26 m/s";

TEST(LackOfTime, IsFoundInTheDetailOfARun) {
  EXPECT_EQ(lack_of_time_in("goal not reached after 60.00 s; " + kSentence), kSentence);
  EXPECT_EQ(lack_of_time_in("goal not reached after 60.00 s"), "");
  EXPECT_EQ(lack_of_time_in(""), "");
  EXPECT_EQ(lack_of_time_sentence(60, 103.08, 0.26), kSentence);
}

TEST(LackOfTime, IsNotWhatAMethodOrAnIdSays) {
  for (const std::string& detail :
       {std::string("nobody can arrive within 1 s: all is lost, at (1.00, 2.00) m after 0.00 s"),
        kSentence + ", at (1.00, 2.00) m after 0.00 s",
        "contact with person '" + kSentence +
            "' at (1.00, 2.00) m after 3.00 s, the robot at 1.00 m/s"})
    EXPECT_EQ(lack_of_time_in(detail), "") << detail;
  EXPECT_EQ(lack_of_time_in("contact with person 'nobody can arrive within 1 s'; " + kSentence),
            kSentence);
}

TEST(LackOfTime, NotesNameThreeScenariosAndCountTheOthers) {
  EXPECT_EQ(lack_of_time_note({}, 20), "");
  EXPECT_EQ(lack_of_time_note({{"hall", kSentence}}, 1),
            "in 1 of 1 scenario nobody can arrive within 60 s: hall; in hall the shortest path "
            "takes at least 103.1 s at 0.26 m/s");
  LacksOfTime lacks;
  for (const char* name : {"a", "b", "c", "d", "e"}) lacks.emplace_back(name, kSentence);
  EXPECT_EQ(lack_of_time_note(lacks, 20),
            "in 5 of 20 scenarios nobody can arrive within 60 s: a, b, c and 2 more; in a the "
            "shortest path takes at least 103.1 s at 0.26 m/s");
}

TEST(LackOfTime, ATableCountsItsScenariosOnceWhateverTheOutcomesOfTheirRuns) {
  TableBuilder builder({}, {});
  for (const char* name : {"far", "near"}) {
    const std::string hash = name + std::string("_hash");
    builder.add_scenario({hash, name, {}});
    for (const char* method : {"a", "b"}) {
      RunRecord run;
      run.scenario_hash = hash;
      run.scenario_name = name;
      run.method = method;
      run.outcome = method == std::string("a") ? "stuck" : "timeout";
      run.outcome_detail = hash == "far_hash" ? "no progress; " + kSentence : "no progress";
      builder.add_run(run, {});
    }
  }
  const ResultTable table = builder.finish();
  EXPECT_EQ(note_on_time(table), lack_of_time_note({{"far", kSentence}}, 2));
}

}  // namespace
}  // namespace slalom
