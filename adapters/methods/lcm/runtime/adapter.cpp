// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/lcm/lcm_method.h>
#include <slalom/methods/adapter.h>

extern "C" __attribute__((visibility("default"))) const slalom::MethodAdapter*
slalom_method_adapter(slalom::ForkHooks& hooks) {
  using namespace slalom;
  share_fork_hooks(hooks);
  static const MethodAdapter adapter = {
      "lcm",
      [](const IniFile& ini, const std::string& section) { return read_lcm_method(ini, section); },
      visit_options_of<LcmOptions>};
  return &adapter;
}
