// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/app/method_option.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

/// The adapter of the section if its methods have a configuration of their own, else null.
const MethodAdapter* configured_adapter(const IniFile& ini, const std::string& section) {
  const MethodAdapter* adapter =
      find_adapter(ini.get(section, "adapter").value_or(""), ini.where(section, "adapter"));
  return adapter != nullptr && adapter->configuration_value != nullptr ? adapter : nullptr;
}

bool is_of_configuration(const std::string& option) {
  return option.find('.') != std::string::npos;
}

}  // namespace

std::optional<std::string> get_method_option(const IniFile& ini, const std::string& method,
                                             const std::string& option, const std::string& where) {
  const std::string section = "method." + method;
  if (!is_of_configuration(option)) return ini.get(section, option);
  if (const MethodAdapter* adapter = configured_adapter(ini, section))
    return adapter->configuration_value(ini, section, option);
  throw usage_error(where, "is not an option of [" + section + "]",
                    "a key of it; SECTION.KEY is for mrpt_holonomic and mrpt_navigator, NODE.NAME "
                    "for ros2");
}

void set_method_option(IniFile& ini, const std::string& method, const std::string& option,
                       const std::string& value) {
  const std::string section = "method." + method;
  if (!is_of_configuration(option)) {
    ini.set(section, option, value, "");
    return;
  }
  const MethodAdapter* adapter = configured_adapter(ini, section);
  const std::string key = adapter == nullptr ? "config_set" : adapter->overrides_key;
  std::string overrides;
  for (const std::string& one : split_nonempty(ini.get(section, key).value_or(""), ';'))
    if (trim(one.substr(0, one.find('='))) != option) overrides += one + "; ";
  ini.set(section, key, overrides + option + "=" + value, "");
}

}  // namespace slalom
