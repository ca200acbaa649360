// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_files.h>
#include <slalom/results/result_table.h>
#include <slalom/slalom.h>

#include <memory>
#include <string>

struct slalom_results {
  slalom::ResultTable table;
  std::string path;                                    ///< of the result file or folder; "": none
  mutable std::unique_ptr<slalom::ResultFiles> files;  ///< opened when a trajectory is read
};
