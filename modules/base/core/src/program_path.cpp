// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/program_path.h>
#include <slalom/core/text.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace slalom {

/// The archive's programs stand behind launchers of their names, which may start them by the loader
/// of another glibc (scripts/launcher.sh).
std::string program_path() {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (starts_with(program.filename().string(), "ld-linux")) program = program_invocation_name;
  const fs::path launcher = program.parent_path() / "../../../bin" / program.filename();
  const bool is_behind =
      program.parent_path().filename() == "programs" && fs::exists(launcher, error);
  return (is_behind ? launcher.lexically_normal() : program).string();
}

std::string program_folder() {
  return std::filesystem::path(program_path()).parent_path().string();
}

std::string shipped_file(const std::string& name) {
  const auto path = std::filesystem::path(program_folder()) / "../share/slalom" / name;
  return path.lexically_normal().string();
}

}  // namespace slalom
