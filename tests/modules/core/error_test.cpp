#include <slalom/core/error.h>

#include <gtest/gtest.h>
#include <mrpt/core/exceptions.h>

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

TEST(ReasonOf, KeepsTheMessageOfMrptExceptionsWithoutTheirCallStack) {
  try {
    THROW_EXCEPTION("the map is\tupside down");
  } catch (const std::exception& e) {
    EXPECT_NE(std::string(e.what()).find('\n'), std::string::npos)
        << "MRPT tells more than we want";
    EXPECT_EQ(reason_of(e), "the map is\tupside down");
  }
}

TEST(ReasonOf, IsTheLocationWhereMrptWrapsAnExceptionWithoutMessage) {
  EXPECT_EQ(reason_of(std::runtime_error("==== MRPT exception ====\nMessage:  \nLocation: no such "
                                         "file\nCall stack backtrace:\n[0 ] 0x7f01")),
            "no such file");
}

TEST(ReasonOf, IsOneLineForAllOthers) {
  EXPECT_EQ(reason_of(std::runtime_error("first\nsecond")), "first second");
}

}  // namespace
}  // namespace slalom
