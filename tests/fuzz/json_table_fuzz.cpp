// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/analysis/csv_columns.h>

#include <foreign_table.h>

/// A table as JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const auto table = table_from_json(fuzz::text_of(data, size), "input");
    if (!table) return;
    CsvColumnOptions options;
    options.success_words = table->success_words;
    columns_from_csv(table->csv, "input", options);
  });
  return 0;
}
