// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/resolve.h>

/// A robot, with its lasers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("robot.urdf", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] {
    IniFile ini = IniFile::from_text("[robot]\nfrom = " + file.path() + "\n");
    for (const RosParameterReport& report : resolve_ros_parameters(ini)) report.listing();
    const IniFile stored = IniFile::from_text(ini.canonical_text());
    fuzz::expect(stored.sections().size() == ini.sections().size(), "names add no sections");
    for (const std::string& section : ini.sections())
      for (const std::string& key : ini.keys(section))
        fuzz::expect(stored.get(section, key) == ini.get(section, key), "values are stored");
    read_robot_model(ini);
  });
  return 0;
}
