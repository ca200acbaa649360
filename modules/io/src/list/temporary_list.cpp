// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/io/temporary_list.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A folder for one list, since SQLite creates its journal next to the list.
class TemporaryListFolder {
 public:
  TemporaryListFolder() {
    std::string name = (fs::temp_directory_path() / "slalom_list_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw job_error(name, std::string("cannot be created: ") + std::strerror(errno),
                      "a writable folder for temporary files");
    path_ = name;
  }
  ~TemporaryListFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryListFolder(const TemporaryListFolder&) = delete;
  TemporaryListFolder& operator=(const TemporaryListFolder&) = delete;

  std::string file() const { return (path_ / "new.scenarios").string(); }

 private:
  fs::path path_;
};

/// The list is closed before its folder is removed.
struct ListInFolder {
  TemporaryListFolder folder;
  ScenarioList list = ScenarioList::create(folder.file());
};

}  // namespace

std::shared_ptr<ScenarioList> make_temporary_list() {
  const auto owner = std::make_shared<ListInFolder>();
  return {owner, &owner->list};
}

}  // namespace slalom
