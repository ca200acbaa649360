#pragma once

#include <slalom/methods/registry.h>

#include <string>

namespace slalom {

/// All adapters, by name.
MethodRegistry all_adapters();

/// The keys of [method.NAME] of all adapters, as for `--options`.
std::string adapter_options_help();

}  // namespace slalom
