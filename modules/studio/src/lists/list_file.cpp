#include <slalom/core/error.h>
#include <slalom/studio/list_document.h>

#include <unistd.h>

namespace slalom {
namespace {

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_ino == b.st_ino && a.st_dev == b.st_dev;
}

/// Compares metadata only: opening and closing the file would release the locks that SQLite holds.
bool same_state(const struct stat& a, const struct stat& b) {
  return same_file(a, b) && a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec &&
         a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

}  // namespace

struct stat ListDocument::file_on_disk() const {
  struct stat found = {};
  if (stat(path_.c_str(), &found) != 0) found = {};
  return found;
}

ListDocument::FileState ListDocument::file_state() const {
  const struct stat now = file_on_disk();
  if (now.st_ino == 0) return FileState::Gone;
  if (!same_file(now, file_)) return FileState::Replaced;
  return same_state(now, file_) ? FileState::Same : FileState::Changed;
}

bool ListDocument::update_from_file() {
  const std::string old_notice = notice_;
  switch (file_state()) {
    case FileState::Same:
      return false;
    case FileState::Gone:
      notice_ = path_ + " was removed by another program; save the list to keep it";
      break;
    case FileState::Changed:
      file_ = file_on_disk();
      notice_ = "the list was changed by another program and was reloaded";
      refresh();
      return true;
    case FileState::Replaced:
      if (same_state(file_on_disk(), unreadable_file_)) return false;
      reopen();
      return true;
  }
  if (notice_ == old_notice) return false;
  notify(Change::View);
  return true;
}

void ListDocument::reopen() {
  const struct stat now = file_on_disk();
  try {
    auto list = std::make_shared<ScenarioList>(ScenarioList::open(path_));
    file_ = now;
    history_ = CommandHistory();
    list_ = std::move(list);
    notice_ = "the file was replaced by another program; earlier changes cannot be undone";
    refresh();
  } catch (const Error& e) {
    unreadable_file_ = now;
    notice_ = reason_of(e);
    notify(Change::View);
  }
}

std::string ListDocument::path_error() const {
  switch (file_state()) {
    case FileState::Gone:
      return "the file was removed by another program; save the list first";
    case FileState::Replaced:
      return "the file was replaced by another program and is not yet reloaded";
    case FileState::Same:
    case FileState::Changed:
      break;
  }
  return "";
}

std::string ListDocument::write_error() const {
  const std::string path = path_error();
  if (!path.empty()) return path;
  return access(path_.c_str(), W_OK) == 0 ? "" : "the file is read-only";
}

}  // namespace slalom
