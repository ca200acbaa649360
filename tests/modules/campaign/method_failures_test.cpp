#include "error_text.h"

#include <slalom/campaign/method_failures.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

RunRecord run(const std::string& scenario, const std::string& method, const std::string& outcome,
              const std::string& detail = "") {
  RunRecord record;
  record.scenario_name = scenario;
  record.scenario_hash = "hash of " + scenario;
  record.method = method;
  record.outcome = outcome;
  record.outcome_detail = detail;
  return record;
}

TEST(MethodFailures, AreNamedWithTheReasonAndTheFirstRunInWhateverOrderTheyCome) {
  MethodFailures failures;
  failures.add(run("room_2", "mine", "method_error", "ValueError: b"));
  failures.add(run("room_1", "mine", "method_error", "AttributeError: a (mine.py:5)"));
  failures.add(run("room_3", "mine", "success"));
  failures.add(run("room_3", "nd", "collision"));
  const std::vector<std::string> lines = failures.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "mine: 2 of 3 runs ended with method_error: AttributeError: a (mine.py:5) (first: "
            "room_1/mine/0)");
  EXPECT_TRUE(failures.methods_without_a_sound_run().empty());
}

TEST(MethodFailures, OfEveryRunNameTheMethod) {
  MethodFailures failures;
  failures.add(run("room_1", "mine", "method_error", "x"));
  failures.add(run("room_2", "mine", "method_crash", "killed by signal 11"));
  failures.add(run("room_1", "nd", "stuck"));
  EXPECT_EQ(failures.lines().size(), 2U);
  EXPECT_EQ(failures.methods_without_a_sound_run(), std::vector<std::string>{"mine"});
}

TEST(MethodFailures, AreOneLineEachWhateverTheMethodSays) {
  MethodFailures failures;
  failures.add(run("room_1", "mine", "method_error", "two\nlines \x1b[31m"));
  ASSERT_EQ(failures.lines().size(), 1U);
  EXPECT_EQ(failures.lines()[0].find_first_of("\n\x1b"), std::string::npos);
}

}  // namespace
}  // namespace slalom
