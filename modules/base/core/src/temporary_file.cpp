// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <unistd.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// The name of a temporary file in memory that a signal handler can read.
struct Slot {
  std::atomic<pid_t> owner{0};  ///< 0: free
  std::array<char, 4096> name{};
};

constexpr std::size_t kSlots = 64;
std::array<Slot, kSlots> slots;

/// Further files than slots are not removed when the program is interrupted.
std::size_t take_slot(const std::string& name) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  for (std::size_t i = 0; i < kSlots && name.size() < slots[i].name.size(); ++i) {
    if (slots[i].owner == getpid()) continue;  // those of a parent process are free in its children
    slots[i].owner = 0;
    std::memcpy(slots[i].name.data(), name.c_str(), name.size() + 1);
    slots[i].owner = getpid();
    return i;
  }
  return kSlots;
}

/// ".tmp-" and digits for the host and its process numbers, which containers have their own of.
std::string host_mark() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  std::error_code ignored;
  const std::string processes = fs::read_symlink("/proc/self/ns/pid", ignored).string();
  return ".tmp-" + Hasher().add(std::string(host.data())).add(processes).hex().substr(0, 8) + "-";
}

/// The process that writes the temporary file of this name; 0 if it is none of this host.
pid_t writer_of(const std::string& name, const std::string& mark) {
  const std::size_t begin = name.rfind(mark);
  if (begin == std::string::npos) return 0;
  const std::size_t number = begin + mark.size(), end = name.find('-', number);
  long long process = 0;
  if (end == std::string::npos || !parse_integer(name.substr(number, end - number), process))
    return 0;
  return static_cast<pid_t>(process);
}

/// Removes what killed programs left in a folder; once for each folder.
void remove_stale_files(const fs::path& folder, const std::string& mark) {
  static std::mutex mutex;
  static std::set<fs::path> cleaned;
  const std::lock_guard lock(mutex);
  if (!cleaned.insert(folder).second) return;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const pid_t writer = writer_of(entry.path().filename().string(), mark);
    if (writer > 0 && kill(writer, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& path, const std::string& ending) : path_(path) {
  static std::atomic<unsigned> count{0};
  const std::string mark = host_mark();
  const fs::path folder = fs::path(path).parent_path();
  remove_stale_files(folder.empty() ? "." : folder, mark);
  name_ = path + mark + std::to_string(getpid()) + "-" + std::to_string(count++) + ending;
  slot_ = take_slot(name_);
}

TemporaryFile::~TemporaryFile() {
  for (const char* suffix : {"", "-journal"}) unlink((name_ + suffix).c_str());
  if (slot_ < kSlots) slots[slot_].owner = 0;
}

void TemporaryFile::publish() {
  if (std::rename(name_.c_str(), path_.c_str()) != 0)
    throw job_error(path_, std::string("cannot be replaced (") + std::strerror(errno) + ")",
                    "a writable path");
}

void remove_temporary_files() noexcept {
  for (const Slot& slot : slots)
    if (slot.owner == getpid()) unlink(slot.name.data());
}

}  // namespace slalom
