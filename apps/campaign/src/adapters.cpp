#include <slalom/app/adapters.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/python/python_method.h>

namespace slalom {

MethodRegistry all_adapters() {
  MethodRegistry registry;
  registry.add("lcm", [](const IniFile& ini, const std::string& section) {
    return read_lcm_method(ini, section);
  });
  registry.add("library", read_library_method);
  registry.add("mrpt_holonomic", read_holonomic_method);
  registry.add("mrpt_navigator", read_navigator_method);
  registry.add("python", read_python_method);
  return registry;
}

}  // namespace slalom
