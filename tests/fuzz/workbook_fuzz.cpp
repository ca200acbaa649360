// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/analysis/csv_columns.h>

#include <foreign_table.h>

/// A workbook of one sheet with a table.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("workbook", fuzz::text_of(data, size));
  fuzz::read_or_refuse(
      [&] { columns_from_csv(table_from_workbook(file.path(), "").csv, "input", {}); });
  return 0;
}
