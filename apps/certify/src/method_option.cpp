// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/method_option.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/ros2/ros2_method.h>

namespace slalom {
namespace {

/// The key that has the options of a configuration: of an MRPT class, or of nodes of ROS 2.
std::string overrides_key(const IniFile& ini, const std::string& section) {
  return ini.get(section, "adapter").value_or("") == "ros2" ? "parameter_set" : "config_set";
}

bool is_of_configuration(const std::string& option) {
  return option.find('.') != std::string::npos;
}

}  // namespace

std::optional<std::string> get_method_option(const IniFile& ini, const std::string& method,
                                             const std::string& option, const std::string& where) {
  const std::string section = "method." + method;
  if (!is_of_configuration(option)) return ini.get(section, option);
  const std::string adapter = ini.get(section, "adapter").value_or("");
  if (adapter == "mrpt_navigator") return navigator_config_value(ini, section, option);
  if (adapter == "mrpt_holonomic") return holonomic_config_value(ini, section, option);
  if (adapter == "ros2") return ros2_parameter_value(ini, section, option);
  throw usage_error(where, "is no option of [" + section + "]",
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
  const std::string key = overrides_key(ini, section);
  std::string overrides;
  for (const std::string& one : split_nonempty(ini.get(section, key).value_or(""), ';'))
    if (trim(one.substr(0, one.find('='))) != option) overrides += one + "; ";
  ini.set(section, key, overrides + option + "=" + value, "");
}

}  // namespace slalom
