#include <slalom/core/error.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(Error, SaysWhereWhatAndWhatWasExpectedInOneLine) {
  EXPECT_STREQ(usage_error("a.ini:3: [robot] radius", "'-1' is not valid", "a number > 0").what(),
               "a.ini:3: [robot] radius: '-1' is not valid; expected a number > 0");
  EXPECT_STREQ(job_error("", "disk full").what(), "disk full");
}

TEST(Error, StaysOneLineWhateverOthersSay) {
  EXPECT_STREQ(usage_error("a.ini", "refuses: too\nwide\r", "less").what(),
               "a.ini: refuses: too wide ; expected less");
}

TEST(Error, CulpritDecidesTheExitStatus) {
  EXPECT_EQ(job_error("x", "y").exit_status(), 1);
  EXPECT_EQ(usage_error("x", "y").exit_status(), 2);
  EXPECT_EQ(file_error("x", "y").exit_status(), 3);
}

}  // namespace
}  // namespace slalom
