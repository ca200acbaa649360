#pragma once

#include <slalom/core/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

/// What each target defines, as libFuzzer wants it. Where there is no libFuzzer all targets are in
/// one program, each under a name of its own.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace slalom::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A reader may take its input or refuse it with an Error; anything else ends the program.
template <typename Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const Error&) {
  }
}

/// A law that holds for whatever a reader takes.
inline void expect(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "broken law: %s\n", law);
  std::abort();
}

/// A file of this process in memory, for readers that want a path.
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
