// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/library/part.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>

#include <algorithm>

namespace slalom {
namespace {

/// A new adapter is registered here.
constexpr MethodAdapter kAdapters[] = {
    {"mrpt_holonomic", read_holonomic_method, visit_options_of<HolonomicOptions>,
     holonomic_config_value, "config_set"},
    {"mrpt_navigator", read_navigator_method, visit_options_of<NavigatorOptions>,
     navigator_config_value, "config_set"},
    {"library", read_library_method, visit_options_of<LibraryOptions>},
};

/// Adapters that are loaded when they are first used: the libraries that they need are large.
constexpr const char* kLoadedAdapters[] = {"python", "onnx", "lcm", "ros2"};

const MethodAdapter& load_adapter(const std::string& name, const std::string& where) {
  const auto get =
      reinterpret_cast<GetMethodAdapter*>(find_in_part(name, "slalom_method_adapter", where));
  return *get(fork_hooks());
}

}  // namespace

const MethodAdapter* find_adapter(const std::string& name, const std::string& where) {
  for (const MethodAdapter& adapter : kAdapters)
    if (name == adapter.name) return &adapter;
  const bool is_loaded = std::any_of(std::begin(kLoadedAdapters), std::end(kLoadedAdapters),
                                     [&](const char* loaded) { return name == loaded; });
  return is_loaded ? &load_adapter(name, where) : nullptr;
}

MethodRegistry all_adapters() {
  MethodRegistry registry;
  for (const MethodAdapter& adapter : kAdapters) registry.add(adapter.name, adapter.read);
  for (const char* name : kLoadedAdapters)
    registry.add(name, [name](const IniFile& ini, const std::string& section) {
      return load_adapter(name, ini.where(section, "adapter")).read(ini, section);
    });
  return registry;
}

void visit_adapter_options(
    const std::function<void(const std::function<void(OptionVisitor&)>&)>& visit) {
  const auto visit_one = [&](const MethodAdapter& adapter) {
    visit([&](OptionVisitor& v) {
      std::string name = adapter.name;
      v.option("adapter", name, "adapter of this method", {name});
      adapter.visit_options(v);
    });
  };
  for (const MethodAdapter& adapter : kAdapters) visit_one(adapter);
  for (const char* name : kLoadedAdapters) {
    const MethodAdapter* adapter = nullptr;
    try {
      adapter = &load_adapter(name, name);
    } catch (const Error&) {
      continue;  // was not built
    }
    visit_one(*adapter);
  }
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
  if (const MethodAdapter* adapter = find_adapter(name, ini.where(section, "adapter")))
    adapter->visit_options(find);
  return found;
}

}  // namespace slalom
