// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/output_folder.h>
#include <slalom/core/error.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace slalom {

void make_output_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    throw job_error(path, "cannot create the folder (" + error.message() + ")", "a writable path");
  const std::string probe = path + "/.slalom-write-test";
  const int file = open(probe.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0)
    throw job_error(path,
                    std::string("cannot create files in the folder (") + std::strerror(errno) + ")",
                    "a writable path");
  close(file);
  unlink(probe.c_str());
}

}  // namespace slalom
