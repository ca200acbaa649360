// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/core/ini_file.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const IniFile ini = IniFile::from_text(fuzz::text_of(data, size), "input");
    for (const std::string& section : ini.sections())
      for (const std::string& key : ini.keys(section)) {
        fuzz::expect(ini.get(section, key).has_value(), "a listed key has a value");
        ini.where(section, key);
      }
    ini.canonical_text();
  });
  return 0;
}
