// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace slalom {

/// Limits the address space of the calling process to its current size plus `bytes`; 0: unlimited.
/// Allocations beyond it fail. No effect under AddressSanitizer, which reserves terabytes.
void limit_memory(std::size_t bytes);

/// Makes the system terminate the calling process (SIGXCPU) after `seconds` more of CPU time,
/// rounded up to whole seconds; 0: unlimited.
void limit_cpu_time(double seconds);

}  // namespace slalom
