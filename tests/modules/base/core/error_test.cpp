// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/printable.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mrpt/core/exceptions.h>

namespace slalom {
namespace {

TEST(Error, ContainsWhereWhatAndExpectedInOneLine) {
  EXPECT_STREQ(usage_error("a.ini:3: [robot] radius", "'-1' is not valid", "a number > 0").what(),
               "a.ini:3: [robot] radius: '-1' is not valid; expected a number > 0");
  EXPECT_STREQ(job_error("", "disk full").what(), "disk full");
}

TEST(Printable, FindsTheFirstByteThatIsNotUtf8) {
  EXPECT_FALSE(find_invalid_utf8(""));
  EXPECT_FALSE(find_invalid_utf8("caf\xc3\xa9 \xe2\x86\x92 \xf0\x9f\x98\x80\n"));
  EXPECT_EQ(find_invalid_utf8("caf\xe9"), 3U);           // Latin-1
  EXPECT_EQ(find_invalid_utf8("a\xc3"), 1U);             // incomplete
  EXPECT_EQ(find_invalid_utf8("ab\xc0\xaf"), 2U);        // a longer form of "/"
  EXPECT_EQ(find_invalid_utf8("\xed\xa0\x80"), 0U);      // a surrogate
  EXPECT_EQ(find_invalid_utf8("\xf4\x90\x80\x80"), 0U);  // above U+10FFFF
}

TEST(Error, ReplacesLineBreaksBySpaces) {
  EXPECT_STREQ(usage_error("a.ini", "refuses: too\nwide\r", "less").what(),
               "a.ini: refuses: too wide ; expected less");
}

TEST(Error, ShowsBytesThatATerminalCannotShowByTheirNumbers) {
  // A terminal acts on ESC (0x1B) and on the control characters of C1 (U+0080 to U+009F).
  EXPECT_STREQ(usage_error("a.ini", std::string("'\x1b[31m\0\x7f\xff'", 10)).what(),
               "a.ini: '\\x1b[31m\\x00\\x7f\\xff'");
  EXPECT_STREQ(file_error("a.ini",
                          "\xc2\x9b"
                          "2J")
                   .what(),
               "a.ini: \\xc2\\x9b2J");
}

TEST(Error, KeepsLettersOfUtf8AndShowsWhatIsMalformedByItsNumbers) {
  EXPECT_STREQ(file_error("größe_\u2192_\U0001F916.ini", "tab\there").what(),
               "größe_\u2192_\U0001F916.ini: tab\there");
  EXPECT_STREQ(file_error("gr\xf6\xdf"
                          "e.ini",
                          "x")
                   .what(),
               "gr\\xf6\\xdfe.ini: x");  // Latin 1
  EXPECT_STREQ(file_error("a", "cut \xe2\x86").what(), "a: cut \\xe2\\x86");
  EXPECT_STREQ(file_error("a", "\xc0\xaf").what(), "a: \\xc0\\xaf");           // overlong '/'
  EXPECT_STREQ(file_error("a", "\xed\xa0\x80").what(), "a: \\xed\\xa0\\x80");  // a surrogate
  EXPECT_STREQ(file_error("a", "\xf4\x90\x80\x80").what(),
               "a: \\xf4\\x90\\x80\\x80");  // above U+10FFFF
}

TEST(Error, ShowsControlsOfTheDirectionOfTextByTheirNumbers) {
  // They let "gnp.exe" be shown as "exe.png".
  for (const std::string control : {"\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d",
                                    "\u202e", "\u2066", "\u2067", "\u2068", "\u2069", "\u061c"}) {
    std::string numbers;
    for (const char c : control) numbers += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    EXPECT_EQ(printable_line("a" + control + "b"), "a" + numbers + "b");
  }
  const std::string neighbors = "\u200d\u2010\u2029\u202f\u2065\u206a\u061b\u061d";
  EXPECT_EQ(printable_line(neighbors), neighbors);
}

TEST(Error, KindDeterminesTheExitStatus) {
  EXPECT_EQ(job_error("x", "y").exit_status(), 1);
  EXPECT_EQ(usage_error("x", "y").exit_status(), 2);
  EXPECT_EQ(file_error("x", "y").exit_status(), 3);
}

TEST(ReasonOf, KeepsTheMessageOfMrptExceptionsWithoutTheirCallStack) {
  try {
    THROW_EXCEPTION("the map is\tupside down");
  } catch (const std::exception& e) {
    EXPECT_NE(std::string(e.what()).find('\n'), std::string::npos) << "MRPT appends its call stack";
    EXPECT_EQ(reason_of(e), "the map is\tupside down");
  }
}

TEST(ReasonOf, KeepsAllLinesOfTheMessageOfMrptExceptions) {
  try {
    const int weights = 4, factors = 7;
    ASSERT_EQUAL_(weights, factors);
  } catch (const std::exception& e) {
    EXPECT_EQ(reason_of(e), "ASSERT_EQUAL_(weights,factors) failed with weights=4 factors=7");
  }
}

TEST(ReasonOf, IsTheLocationOfMrptExceptionsWithoutMessage) {
  EXPECT_EQ(reason_of(std::runtime_error("==== MRPT exception ====\nMessage:  \nLocation: no such "
                                         "file\nCall stack backtrace:\n[0 ] 0x7f01")),
            "no such file");
}

TEST(ReasonOf, IsCutBetweenCharactersWhereItIsLongerThanAFewKilobytes) {
  EXPECT_EQ(reason_of(std::runtime_error(std::string(4096, 'x'))), std::string(4096, 'x'));
  EXPECT_EQ(reason_of(std::runtime_error(std::string(10 << 20, 'x'))),
            std::string(4096, 'x') + "... (cut after 4096 bytes)");
  EXPECT_EQ(reason_of(std::runtime_error(std::string(4094, 'x') + "\u2192 and more")),
            std::string(4094, 'x') + "... (cut after 4094 bytes)");
}

TEST(ReasonOf, NamesAnExceptionWithoutAText) {
  class Speechless : public std::exception {
    const char* what() const noexcept override { return nullptr; }
  };
  EXPECT_EQ(reason_of(Speechless()), "an exception without a text");
}

TEST(ReasonOf, IsOneLineForOtherExceptions) {
  EXPECT_EQ(reason_of(std::runtime_error("first\nsecond")), "first second");
}

}  // namespace
}  // namespace slalom
