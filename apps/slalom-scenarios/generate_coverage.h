#pragma once

#include <slalom/core/ini_file.h>

#include <cstdint>
#include <string>

namespace slalom {

struct CoverageArguments {
  std::string output;
  std::uint64_t seed = 1;
  int jobs = 1;
  bool quiet = false, json = false;
};

/// Fills the bins of [coverage] and writes the list; prints the table of bins.
void generate_by_coverage(const IniFile& ini, const CoverageArguments& arguments);

}  // namespace slalom
