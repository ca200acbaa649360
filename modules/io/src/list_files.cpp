#include "list_schema.h"
#include "scenario_list_impl.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sqlite3.h>
#include <unistd.h>

namespace slalom {
namespace {

/// A name beside `path` under which a new list is made; gone unless it took the path's place.
class Draft {
 public:
  explicit Draft(const std::string& path) : path_(path), name_(path + ".XXXXXX") {
    const int file = mkstemp(name_.data());
    if (file < 0) throw failure("cannot be made");
    fchmod(file, 0644);
    close(file);
  }
  ~Draft() {
    for (const char* suffix : {"", "-journal"}) unlink((name_ + suffix).c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::string& name() const { return name_; }

  /// The old list is kept from being written while the new one takes its place: a program that
  /// waits for it then finds another file at the path, and refuses to write.
  void publish() {
    sync(name_);
    const auto old = lock_old();
    for (const char* suffix : {"-journal", "-wal", "-shm"}) unlink((path_ + suffix).c_str());
    if (std::rename(name_.c_str(), path_.c_str()) != 0) throw failure("cannot be replaced");
    const auto folder = std::filesystem::path(path_).parent_path();
    sync(folder.empty() ? "." : folder.string());
  }

 private:
  Error failure(const std::string& what) const {
    return job_error(path_, what + " (" + std::strerror(errno) + ")",
                     "a place that can be written");
  }

  void sync(const std::string& path) const {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool done = file >= 0 && fsync(file) == 0;
    if (file >= 0) close(file);
    if (!done) throw failure("cannot be written");
  }

  /// Locked, and what a killed program left half done undone; none where there is no SQLite file.
  std::unique_ptr<SQLite::Database> lock_old() const {
    constexpr int kPatienceMs = 10000;
    if (access(path_.c_str(), F_OK) != 0) return nullptr;
    try {
      auto old = std::make_unique<SQLite::Database>(path_, SQLite::OPEN_READWRITE, kPatienceMs);
      old->exec("BEGIN EXCLUSIVE");
      return old;
    } catch (const SQLite::Exception& e) {
      if (e.getErrorCode() == SQLITE_BUSY)
        throw job_error(path_, "is being written by another program", "that it comes to an end");
      return nullptr;
    }
  }

  std::string path_, name_;
};

struct stat stat_of(const std::string& path) {
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0) found.st_ino = 0;
  return found;
}

}  // namespace

ScenarioList ScenarioList::create(const std::string& path) {
  write(path, [](ScenarioList&) {});
  return open(path);
}

void ScenarioList::write(const std::string& path, const std::function<void(ScenarioList&)>& fill) {
  Draft draft(path);
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = create_database(draft.name(), kScenarioList);
  // Nobody sees the draft, so it need not be whole until it is published.
  impl->database->exec("PRAGMA synchronous = OFF");
  impl->database->exec("PRAGMA journal_mode = MEMORY");
  impl->draft = true;
  {
    ScenarioList list(std::move(impl));
    list.in_one_step([&] { fill(list); });
  }
  draft.publish();
}

ScenarioList ScenarioList::open(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->file = stat_of(path);
  impl->database = open_database(path, kScenarioList);
  try {
    impl->database->exec("PRAGMA trusted_schema = OFF");
    refuse_foreign_schema(*impl->database, path);
    upgrade_list(*impl->database, path);
  } catch (const SQLite::Exception& e) {
    throw_read_error(path, e);
  }
  return ScenarioList(std::move(impl));
}

void ScenarioList::save_as(const std::string& path) {
  Draft draft(path);
  writing(path, [&] {
    SQLite::Statement copy(*impl_->database, "VACUUM INTO ?");
    unlink(draft.name().c_str());
    copy.bind(1, draft.name());
    copy.exec();
  });
  chmod(draft.name().c_str(), 0644);
  draft.publish();
}

void ScenarioList::remove_file(const std::string& path) {
  open(path);  // only what is a list, and what a killed program left behind is undone
  for (const char* suffix : {"", "-journal"})
    if (unlink((path + suffix).c_str()) != 0 && errno != ENOENT)
      throw job_error(path, std::string("cannot be removed (") + std::strerror(errno) + ")");
}

void ScenarioList::Impl::expect_same_file() const {
  if (draft) return;
  const struct stat now = stat_of(path);
  if (now.st_ino == file.st_ino && now.st_dev == file.st_dev) return;
  throw job_error(
      path, now.st_ino == 0 ? "was removed by another program" : "was replaced by another program",
      "that the list is opened again");
}

}  // namespace slalom
