// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/analysis/csv_columns.h>

/// Tables of other programs, with and without a header line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string text = fuzz::text_of(data, size);
  CsvColumnOptions headless;
  headless.names = {"world", "success", "time"};
  CsvColumnOptions words;
  words.success_words = {"parked"};
  for (const CsvColumnOptions& options : {CsvColumnOptions{}, headless, words})
    fuzz::read_or_refuse([&] {
      const ResultTable table = columns_from_csv(text, "input", options);
      fuzz::expect(table.size() > 0 && !table.metrics.empty(), "a table has rows and metrics");
      for (const ValueColumn& column : table.metrics)
        fuzz::expect(column.size() == table.size(), "a column has a value of each row");
    });
  return 0;
}
