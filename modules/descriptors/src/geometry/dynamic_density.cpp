#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// Total area of moving obstacles / A. Scenarios have no moving obstacles, so it is 0.
Value dynamic_density(const DescriptorContext&) {
  return Value::of(0);
}

}  // namespace slalom::descriptors
