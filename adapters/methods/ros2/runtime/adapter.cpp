// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/methods/adapter.h>
#include <slalom/ros2/ros2_method.h>

extern "C" __attribute__((visibility("default"))) const slalom::MethodAdapter*
slalom_method_adapter(slalom::ForkHooks& hooks) {
  using namespace slalom;
  share_fork_hooks(hooks);
  static const MethodAdapter adapter = {
      "ros2",
      [](const IniFile& ini, const std::string& section) { return read_ros2_method(ini, section); },
      visit_options_of<Ros2Options>, ros2_parameter_value, "parameter_set"};
  return &adapter;
}
