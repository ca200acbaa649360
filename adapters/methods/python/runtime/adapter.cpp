// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/methods/adapter.h>
#include <slalom/python/python_method.h>

extern "C" __attribute__((visibility("default"))) const slalom::MethodAdapter*
slalom_method_adapter(slalom::ForkHooks& hooks) {
  using namespace slalom;
  share_fork_hooks(hooks);
  static const MethodAdapter adapter = {"python", read_python_method,
                                        visit_options_of<PythonOptions>};
  return &adapter;
}
