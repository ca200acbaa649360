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

/// A folder of its own: SQLite puts its journal beside the list.
class TemporaryListFolder {
 public:
  TemporaryListFolder() {
    std::string name = (fs::temp_directory_path() / "slalom_list_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw job_error(name, std::string("cannot be made: ") + std::strerror(errno),
                      "a folder for temporary files that can be written");
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

/// The list is closed before its folder goes.
struct ListInFolder {
  TemporaryListFolder folder;
  ScenarioList list = ScenarioList::create(folder.file());
};

}  // namespace

std::shared_ptr<ScenarioList> make_temporary_list() {
  const auto both = std::make_shared<ListInFolder>();
  return {both, &both->list};
}

}  // namespace slalom
