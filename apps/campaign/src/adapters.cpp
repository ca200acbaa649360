#include <slalom/app/adapters.h>
#include <slalom/core/options.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/python/python_method.h>

namespace slalom {
namespace {

struct Adapter {
  const char* name;
  MethodFactory (*read)(const IniFile& ini, const std::string& section);
  std::string (*options)();  ///< help
};

template <typename Options>
std::string options_of() {
  Options options;
  OptionLister lister;
  options.visit(lister);
  return lister.text();
}

MethodFactory read_lcm(const IniFile& ini, const std::string& section) {
  return read_lcm_method(ini, section);
}

/// A new adapter is registered here.
constexpr Adapter kAdapters[] = {
    {"mrpt_holonomic", read_holonomic_method, options_of<HolonomicOptions>},
    {"mrpt_navigator", read_navigator_method, options_of<NavigatorOptions>},
    {"library", read_library_method, options_of<LibraryOptions>},
    {"python", read_python_method, options_of<PythonOptions>},
    {"lcm", read_lcm, options_of<LcmOptions>},
};

}  // namespace

MethodRegistry all_adapters() {
  MethodRegistry registry;
  for (const Adapter& adapter : kAdapters) registry.add(adapter.name, adapter.read);
  return registry;
}

std::string adapter_options_help() {
  std::string text;
  for (const Adapter& adapter : kAdapters) text += "\n[method.NAME]\n" + adapter.options();
  return text;
}

}  // namespace slalom
