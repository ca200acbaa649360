// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

/// The entry point of each target, as required by libFuzzer. Without libFuzzer all targets are in
/// one program, each under its own name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace slalom::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A reader may accept its input or refuse it with an Error; anything else ends the program.
template <typename Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const Error&) {
  }
}

/// An invariant of all accepted inputs.
inline void expect(bool holds, const char* invariant) {
  if (holds) return;
  std::fprintf(stderr, "violated invariant: %s\n", invariant);
  std::abort();
}

/// A file in memory, for readers that need a path.
class InputFile {
 public:
  InputFile(const std::string& name, const std::string& bytes)
      : path_("/dev/shm/slalom_fuzz_" + std::to_string(getpid()) + "_" + name) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~InputFile() { unlink(path_.c_str()); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace slalom::fuzz
