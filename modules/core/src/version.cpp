#include <slalom/core/version.h>

#include <mrpt/version.h>

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

}  // namespace slalom
