// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

ResultTable small_table() {
  ResultFixture fixture;
  for (const double optimality : {0.9, 0.8, 0.7, -1.0}) {
    fixture.add_run(fixture.add_scenario(Value::of(0.1)), "nd", optimality);
  }
  return fixture.table;
}

TEST(TableText, ShowsEveryCellWithItsSampleSize) {
  const auto tables = build_cross_tables(small_table(), parse_bin_specs("density:0,0.2"),
                                         {"success", "optimality", "path_length"}, {});
  // Wilson of 3/4: [0.301, 0.954]; of 0.9, 0.8, 0.7 Gaffke's interval in [0, 1].
  EXPECT_EQ(render_cross_table_text(tables[0]),
            "nd by density, 95 % intervals\n\n"
            "density   success ↑          optimality ↑          path_length ↓ m\n"
            "────────  ─────────────────  ────────────────────  ───────────────\n"
            "[0, 0.2]  0.75 [0.30, 0.95]  0.800 [0.231, 0.948]  10.0\n"
            "4 runs    3/4                ±0.100 n = 3 of 4     ±0.0 n = 4\n"
            "NA  optimality: 1 collision; more than 10 %: means not comparable\n"
            "NA  interval of a mean of path_length: no bounds\n");
}

TEST(TableText, IsWrappedWithManyColumns) {
  const std::vector<std::string> columns(12, "optimality");
  const std::string text =
      render_tables_text(small_table(), parse_bin_specs("density:2;all"), columns, 0.95);
  for (const std::string& line : split(text, '\n')) EXPECT_LE(display_width(line), 120u) << line;
}

TEST(TableText, ReportsThatThereAreNoRuns) {
  EXPECT_EQ(render_tables_text(ResultFixture().table, {BinSpec{}}, {"success"}, 0.95),
            "No runs.\n");
}

}  // namespace
}  // namespace slalom
