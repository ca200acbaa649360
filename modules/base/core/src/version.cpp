// SPDX-License-Identifier: BSD-3-Clause
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
  return mrpt_version(MRPT_VERSION);
}

std::string mrpt_version(unsigned code) {
  // 0xMNP, a hexadecimal digit each; two digits each in later versions: 2.5.8 is 0x258, 2.14.7
  // 0x20e07.
  const unsigned bits = code < 0x1000 ? 4 : 8, mask = (1U << bits) - 1;
  return std::to_string(code >> (2 * bits)) + "." + std::to_string((code >> bits) & mask) + "." +
         std::to_string(code & mask);
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

Error not_built(const std::string& where, const std::string& part) {
  return usage_error(where, "Slalom was built without this part",
                     "all targets of a build by CMake with -D" + part + "=ON");
}

}  // namespace slalom
