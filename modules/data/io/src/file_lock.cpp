// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/file_lock.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace slalom {
namespace {

using Holder = std::map<std::string, std::string>;

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// When the process was started, in clock ticks after the boot; "" if there is no such process, or
/// it has ended and nobody waits for it. A process id alone may have been given to another process.
std::string start_of(const std::string& pid) {
  const std::string stat = first_line("/proc/" + pid + "/stat");
  const std::size_t name_end = stat.rfind(')');  // the name may contain blanks
  if (name_end == std::string::npos) return "";
  constexpr std::size_t kStartAfterName = 19;
  const std::vector<std::string> fields = split_nonempty(stat.substr(name_end + 1), ' ');
  return fields.size() > kStartAfterName && fields[0] != "Z" ? fields[kStartAfterName] : "";
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string host_name() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

Holder this_process() {
  const std::string pid = std::to_string(getpid());
  return {{"host", host_name()},
          {"boot", first_line("/proc/sys/kernel/random/boot_id")},
          {"pid", pid},
          {"start", start_of(pid)},
          {"time", std::to_string(std::time(nullptr))},
          {"job", environment("SLURM_JOB_ID")},
          {"restart", environment("SLURM_RESTART_COUNT")}};
}

std::string text_of(const Holder& holder) {
  std::string text;
  for (const auto& [key, value] : holder) text += key + " = " + value + "\n";
  return text;
}

Holder parse_holder(const std::string& text) {
  Holder holder;
  for (const std::string& line : split(text, '\n')) {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
      holder[trim(line.substr(0, equals))] = trim(line.substr(equals + 1));
  }
  return holder;
}

bool on_this_host(const Holder& holder) {
  const auto host = holder.find("host");
  return host != holder.end() && host->second == host_name();
}

/// Whether the holder is known to be gone.
bool is_gone(Holder holder) {
  if (holder.count("pid") == 0) return false;  // just being written
  const Holder here = this_process();
  const std::string job = holder["job"];
  if (!job.empty() && job == here.at("job") && holder["restart"] != here.at("restart")) return true;
  if (!on_this_host(holder)) return false;
  return holder["boot"] != here.at("boot") || start_of(holder["pid"]) != holder["start"];
}

std::string name_of(Holder holder) {
  if (holder.count("pid") == 0) return "a program that is just starting";
  const std::string job = holder["job"];
  return "process " + holder["pid"] + " on " + holder["host"] + (job.empty() ? "" : ", job " + job);
}

/// An open lock file of another program. While it is locked by flock(), no other program that
/// finds it stale removes it or its successor.
class FoundLock {
 public:
  /// `notify` is told once when it takes long. Throws Error (Job) for what is not a regular file,
  /// and if another program keeps it locked, as flock(1) does.
  explicit FoundLock(const std::string& path, const LockNotice& notify = nullptr)
      : path_(path), file_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (file_ < 0) return;
    try {
      expect_regular_file();
      wait_for_flock(notify);
    } catch (...) {
      close(file_);
      throw;
    }
    read_holder();
  }
  ~FoundLock() {
    if (file_ >= 0) close(file_);
  }
  FoundLock(const FoundLock&) = delete;
  FoundLock& operator=(const FoundLock&) = delete;

  /// Whether it still is the file at the path.
  bool exists() const {
    struct stat mine = {}, there = {};
    return file_ >= 0 && fstat(file_, &mine) == 0 && stat(path_.c_str(), &there) == 0 &&
           mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
  }
  const Holder& holder() const { return holder_; }

  /// Until the program that has just created the lock has written itself, or had the time to.
  void await_holder() {
    constexpr std::time_t kPeriodMs = 20;
    // The end of the loop is for clocks that differ.
    for (std::time_t i = 0; i * kPeriodMs < 2 * kTimeToWrite * 1000; ++i) {
      if (!holder_.empty() || is_abandoned() || !exists()) return;
      usleep(kPeriodMs * 1000);
      read_holder();
    }
  }

  /// A program that was killed while it created the lock left it empty.
  bool is_abandoned() const {
    struct stat mine = {};
    return holder_.empty() && fstat(file_, &mine) == 0 &&
           std::time(nullptr) - mine.st_mtime > kTimeToWrite;
  }

 private:
  static constexpr std::time_t kTimeToWrite = 10;  // s

  void expect_regular_file() const {
    struct stat mine = {};
    if (fstat(file_, &mine) != 0 || !S_ISREG(mine.st_mode))
      throw job_error(path_, "is not a regular file", "a lock file of Slalom, or none");
  }

  /// Other programs of Slalom hold it while they wait for the content of an empty lock.
  void wait_for_flock(const LockNotice& notify) const {
    constexpr int kPeriodMs = 20, kNoticeMs = 500, kMaxWaitMs = 3 * kTimeToWrite * 1000;
    for (int waited = 0; flock(file_, LOCK_EX | LOCK_NB) != 0; waited += kPeriodMs) {
      if (errno != EWOULDBLOCK && errno != EINTR)
        throw job_error(path_,
                        std::string("cannot be locked (flock: ") + std::strerror(errno) + ")",
                        "a file system with locks");
      if (waited == kNoticeMs && notify)
        notify(path_ + ": waits for another program that has locked it (flock)");
      if (waited >= kMaxWaitMs)
        throw job_error(path_, "is locked by another program (flock)", "its end");
      usleep(kPeriodMs * 1000);
    }
  }

  void read_holder() {
    char bytes[4096];
    const ssize_t size = pread(file_, bytes, sizeof bytes, 0);
    if (size > 0) holder_ = parse_holder(std::string(bytes, static_cast<std::size_t>(size)));
  }

  std::string path_;
  int file_;
  Holder holder_;
};

Error failure(const std::string& path, const std::string& what) {
  return job_error(path, what + " (" + std::strerror(errno) + ")", "a writable path");
}

/// False if the file exists.
bool create_lock(const std::string& path, const std::string& text, const std::string& output) {
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0 && errno == EEXIST) return false;
  if (file < 0) throw failure(output, "cannot be created");
  const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int write_errno = errno;
  close(file);
  if (written) return true;
  unlink(path.c_str());
  errno = write_errno;
  throw failure(output, "cannot be written");
}

/// Removes the lock of a program that is gone, or that may be taken over.
void remove_stale_lock(const std::string& path, const std::string& output, bool take_over,
                       const LockNotice& notify) {
  FoundLock found(path, notify);
  found.await_holder();
  if (!found.exists()) return;  // released or replaced meanwhile
  const bool elsewhere = !found.holder().empty() && !on_this_host(found.holder());
  if (!is_gone(found.holder()) && !found.is_abandoned() && !(take_over && elsewhere))
    throw job_error(output, "is being written by " + name_of(found.holder()),
                    elsewhere ? "its end, or --take-over if that program is gone" : "its end");
  if (unlink(path.c_str()) != 0 && errno != ENOENT)
    throw failure(output, "its stale lock cannot be removed");
}

}  // namespace

std::string lock_path(const std::string& path) {
  return path + ".lock";
}

std::string lock_holder(const std::string& path) {
  const FoundLock found(lock_path(path));
  if (!found.exists() || is_gone(found.holder()) || found.is_abandoned()) return "";
  return name_of(found.holder());
}

FileLock::FileLock(const std::string& path, bool take_over, const LockNotice& notify)
    : path_(lock_path(path)), text_(text_of(this_process())), owner_(getpid()) {
  constexpr int kTries = 100;  // each failed one means that another program had the lock meanwhile
  for (int i = 0; i < kTries; ++i) {
    if (create_lock(path_, text_, path)) return;
    remove_stale_lock(path_, path, take_over, notify);
  }
  throw job_error(path, "is locked by other programs all the time", "their end");
}

FileLock::~FileLock() {
  if (getpid() != owner_) return;  // a forked process
  // Another program may have taken it over. It is not locked by flock(): nobody removes the lock of
  // a living process, and a program that reads it must not delay the end of this one.
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_, ignored)) return;
  std::ifstream file(path_);
  if (std::string(std::istreambuf_iterator<char>(file), {}) == text_) unlink(path_.c_str());
}

}  // namespace slalom
