// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/core/options.h>
#include <slalom/core/version.h>
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>

#ifdef SLALOM_WITH_LCM
#include <slalom/lcm/lcm_method.h>
#endif
#ifdef SLALOM_WITH_ONNX
#include <slalom/onnx/onnx_method.h>
#endif
#ifdef SLALOM_WITH_PYTHON
#include <slalom/python/python_method.h>
#endif
#ifdef SLALOM_WITH_ROS2
#include <slalom/ros2/ros2_method.h>
#endif

namespace slalom {
namespace {

struct Adapter {
  const char* name;
  MethodFactory (*read)(const IniFile& ini, const std::string& section);
  void (*visit_options)(OptionVisitor& visitor);
};

template <typename Options>
void options_of(OptionVisitor& visitor) {
  Options().visit(visitor);
}

#ifdef SLALOM_WITH_LCM
MethodFactory read_lcm(const IniFile& ini, const std::string& section) {
  return read_lcm_method(ini, section);
}
#endif

#ifdef SLALOM_WITH_ROS2
MethodFactory read_ros2(const IniFile& ini, const std::string& section) {
  return read_ros2_method(ini, section);
}
#endif

/// A new adapter is registered here.
constexpr Adapter kAdapters[] = {
    {"mrpt_holonomic", read_holonomic_method, options_of<HolonomicOptions>},
    {"mrpt_navigator", read_navigator_method, options_of<NavigatorOptions>},
    {"library", read_library_method, options_of<LibraryOptions>},
#ifdef SLALOM_WITH_PYTHON
    {"python", read_python_method, options_of<PythonOptions>},
#endif
#ifdef SLALOM_WITH_ONNX
    {"onnx", read_onnx_method, options_of<OnnxOptions>},
#endif
#ifdef SLALOM_WITH_LCM
    {"lcm", read_lcm, options_of<LcmOptions>},
#endif
#ifdef SLALOM_WITH_ROS2
    {"ros2", read_ros2, options_of<Ros2Options>},
#endif
};

/// Adapters that are optional parts of a build, with their options of CMake.
constexpr std::pair<const char*, const char*> kOptionalAdapters[] = {
    {"lcm", "SLALOM_WITH_LCM"},
    {"onnx", "SLALOM_WITH_ONNX"},
    {"python", "SLALOM_WITH_PYTHON"},
    {"ros2", "SLALOM_WITH_ROS2"}};

}  // namespace

MethodRegistry all_adapters() {
  MethodRegistry registry;
  for (const auto& [name, part] : kOptionalAdapters)
    registry.add(name,
                 [part = part](const IniFile& ini, const std::string& section) -> MethodFactory {
                   throw not_built(ini.where(section, "adapter"), part);
                 });
  for (const Adapter& adapter : kAdapters) registry.add(adapter.name, adapter.read);
  return registry;
}

void visit_adapter_options(
    const std::function<void(const std::function<void(OptionVisitor&)>&)>& visit) {
  for (const Adapter& adapter : kAdapters)
    visit([&](OptionVisitor& v) {
      std::string name = adapter.name;
      v.option("adapter", name, "adapter of this method", {name});
      adapter.visit_options(v);
    });
}

bool uses_network(const std::string& adapter) {
  return adapter == "lcm" || adapter == "ros2";
}

External external_use(const IniFile& ini, const std::string& section, const std::string& key) {
  External found = External::None;
  OptionFunction find([&](const Option& option) {
    if (option.key == key) found = option.external;
  });
  const std::string name = ini.get(section, "adapter").value_or("");
  for (const Adapter& adapter : kAdapters)
    if (name == adapter.name) adapter.visit_options(find);
  return found;
}

}  // namespace slalom
