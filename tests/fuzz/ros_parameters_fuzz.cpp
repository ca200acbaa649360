// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/ros_parameters/resolve.h>

/// Parameters of Nav2 or move_base, of a robot with its sensor and a method.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("nav.yaml", fuzz::text_of(data, size));
  for (const char* section : {"[robot]", "[sensor]", "[method.m]"})
    fuzz::read_or_refuse([&] {
      IniFile ini = IniFile::from_text(section + ("\nfrom = " + file.path() + "\n"));
      for (const RosParameterReport& report : resolve_ros_parameters(ini)) report.listing();
      const std::string name = ini.sections().front();
      const IniFile stored = IniFile::from_text(ini.canonical_text());
      fuzz::expect(stored.sections().size() == 1, "values add no sections");
      fuzz::expect(stored.keys(name).size() == ini.keys(name).size(), "values add no keys");
      for (const std::string& key : ini.keys(name))
        fuzz::expect(stored.get(name, key) == ini.get(name, key), "stored values are the same");
    });
  return 0;
}
