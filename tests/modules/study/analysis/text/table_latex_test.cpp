// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/table_latex.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(TableLatex, EscapesSpecialCharacters) {
  EXPECT_EQ(latex_text("a_b"), "a\\_b");
  EXPECT_EQ(latex_text("50 % & #1 {$}"), "50 \\% \\& \\#1 \\{\\$\\}");
  EXPECT_EQ(latex_text("\\~^"), "\\textbackslash{}\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(latex_text("[0, 1)"), "{[}0, 1)");
  EXPECT_EQ(latex_text("a\n\xc3\xa9"), "a\xc3\xa9");
  EXPECT_EQ(latex_text("\xc3\x9e\xc3"), "??");
  EXPECT_EQ(latex_text("\xce\xb1-gap \xf0\x9f\xa4\x96"), "?-gap ?");
}

TEST(TableLatex, HasOneRowPerBinAndOneFieldPerColumn) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.05));
  fixture.add_run(hash, "follow_gap", 0.5);
  fixture.add_run(hash, "follow_gap", -1, 1);
  const auto tables = build_cross_tables(fixture.table, {parse_bin_spec("density:0,0.1,0.3")},
                                         {"success", "optimality"}, {});
  const std::string text = render_latex(tables.at(0));
  EXPECT_EQ(count(text, "\\\\\n"), 3u) << text;    // header and two bins
  EXPECT_EQ(count(text, " & "), 3u * 3u) << text;  // bin, runs, two metrics
  EXPECT_NE(text.find("follow\\_gap by density"), std::string::npos) << text;
  EXPECT_NE(text.find("n = 1 of 2"), std::string::npos) << text;
  EXPECT_NE(text.find("95\\,\\%"), std::string::npos) << text;
}

TEST(TableLatex, LabelsOfTablesInOneDocumentDiffer) {
  const std::string table = latex_tabular("By density", "a by density", {"density"}, {});
  const std::string text = latex_document({table, table, table});
  for (const char* label : {"{tab:a-by-density}", "{tab:a-by-density_2}", "{tab:a-by-density_3}"})
    EXPECT_EQ(count(text, std::string("\\label") + label), 1u) << text;
  EXPECT_EQ(count(text, "\\label"), 3u);
}

TEST(TableLatex, OfASummaryContainsEveryMethod) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.05));
  fixture.add_run(hash, "a", 0.5);
  fixture.add_run(hash, "b", 1);
  const std::string text = render_latex(build_summary(fixture.table, {"success"}, {}));
  EXPECT_NE(text.find("\na & 1 & 1.00 "), std::string::npos) << text;
  EXPECT_NE(text.find("\nb & 1 & 1.00 "), std::string::npos) << text;
}

}  // namespace
}  // namespace slalom
