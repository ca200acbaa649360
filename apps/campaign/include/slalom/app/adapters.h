#pragma once

#include <slalom/methods/registry.h>

namespace slalom {

/// Every adapter that Slalom has, by its name.
MethodRegistry all_adapters();

}  // namespace slalom
