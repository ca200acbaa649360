#include <slalom/core/text.h>
#include <slalom/core/version.h>

#include <mrpt/version.h>

#include <fstream>

namespace slalom {

std::string version() {
  return SLALOM_VERSION;
}

std::string compiler_version() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

std::string mrpt_version() {
  // 0xMNP: one hexadecimal digit each for major, minor and patch.
  return std::to_string(MRPT_VERSION >> 8) + "." + std::to_string((MRPT_VERSION >> 4) & 15) + "." +
         std::to_string(MRPT_VERSION & 15);
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && trim(line.substr(0, colon)) == "model name")
      return trim(line.substr(colon + 1));
  }
  return "unknown";
}

}  // namespace slalom
