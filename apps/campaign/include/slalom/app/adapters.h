#pragma once

#include <slalom/methods/registry.h>

namespace slalom {

/// All adapters, by name.
MethodRegistry all_adapters();

}  // namespace slalom
