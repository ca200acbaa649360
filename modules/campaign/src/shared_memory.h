#pragma once

#include "file_descriptor.h"

#include <slalom/core/shared_array.h>

#include <cstddef>

namespace slalom {

/// Memory that processes share by its descriptor: one writes it, then it is sealed, and others map
/// it. None where the system cannot.
FileDescriptor create_shared_memory();

/// Appends bytes. Throws Error (Job) when the system is out of memory.
void append_to_shared_memory(int file, const void* data, std::size_t size);

/// From now on nobody can change the memory, in whatever process. False if that is not possible.
bool seal_shared_memory(int file);

/// Maps sealed memory; empty if it is not sealed or cannot be mapped. A process that makes its
/// mapping writable changes a copy of its own.
SharedArray<std::byte> map_shared_memory(int file);

}  // namespace slalom
