// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>

#include <sstream>
#include <string>

namespace slalom {

/// Output of dump().
inline std::string dump_text(const ResultFile& file, const DamageHandler& report = {}) {
  std::ostringstream text;
  dump(file, text, report);
  return text.str();
}

}  // namespace slalom
