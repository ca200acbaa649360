#pragma once

#include <cstddef>

namespace slalom {

/// Bounds the address space of the calling process to what it has now and `bytes` more; 0: no
/// bound. Allocations beyond fail. Without effect under AddressSanitizer, which reserves terabytes.
void limit_memory(std::size_t bytes);

/// Lets the system end the calling process (SIGXCPU) when it has used `seconds` more of processor
/// time, rounded up to whole seconds; 0: no bound.
void limit_cpu_time(double seconds);

}  // namespace slalom
