#include <slalom/app/adapters.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>

namespace slalom {

MethodRegistry all_adapters() {
  MethodRegistry registry;
  registry.add("lcm", make_lcm_method);
  registry.add("library", make_library_method);
  registry.add("mrpt_holonomic", make_holonomic_method);
  registry.add("mrpt_navigator", make_navigator_method);
  return registry;
}

}  // namespace slalom
