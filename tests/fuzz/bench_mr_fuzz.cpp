// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/analysis/csv_columns.h>

#include <benchmark_table.h>

/// Results of Bench-MR, as a table.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const auto table = bench_mr_from_text(fuzz::text_of(data, size));
    if (!table) return;
    CsvColumnOptions options;
    options.success_words = table->success_words;
    columns_from_csv(table->csv, "input", options);
  });
  return 0;
}
