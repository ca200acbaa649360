// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/version.h>
#include <slalom/spreadsheet/workbook.h>

namespace slalom {

void write_workbook(const std::vector<DataTable>&, const std::string& path) {
  throw not_built(path, "SLALOM_WITH_XLSX");
}

}  // namespace slalom
