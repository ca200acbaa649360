// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/scratch_folder.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace slalom {

ScratchFolder::ScratchFolder()
    : path_((std::filesystem::temp_directory_path() / "slalom_XXXXXX").string()) {
  if (mkdtemp(path_.data()) == nullptr)
    throw job_error(path_, std::string("cannot be created: ") + std::strerror(errno),
                    "a writable folder for temporary files");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace slalom
