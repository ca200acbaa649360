// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/io/file_lock.h>
#include <slalom/io/result_file.h>

#include <gtest/gtest.h>

#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

class FileLockTest : public testing::Test {
 protected:
  void write_lock(const std::string& text) const { write_file_atomically(lock_path(path_), text); }
  /// The content of the lock of a process of this host that has ended.
  std::string lock_of_dead_process() const {
    const pid_t child = fork();
    if (child == 0) {
      const FileLock lock(path_);
      _exit(0);  // as if it was killed
    }
    waitpid(child, nullptr, 0);
    return read_file(lock_path(path_));
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "runs.results";
};

TEST_F(FileLockTest, ExistsUntilItsHolderReleasesIt) {
  {
    const FileLock lock(path_);
    EXPECT_TRUE(mentions(lock_holder(path_), {"process " + std::to_string(getpid()) + " on "}));
  }
  EXPECT_EQ(lock_holder(path_), "");
  EXPECT_FALSE(std::filesystem::exists(lock_path(path_)));
}

TEST_F(FileLockTest, ASecondProgramIsRefusedAndToldWhoHoldsIt) {
  const FileLock lock(path_);
  EXPECT_TRUE(throws_error(ErrorKind::Job, path_ + ": is being written by process ",
                           {std::to_string(getpid())}, [&] { FileLock second(path_); }));
  EXPECT_TRUE(throws_error(ErrorKind::Job, path_, {}, [&] { FileLock second(path_, true); }));
}

TEST_F(FileLockTest, OfAProcessThatIsGoneIsReplaced) {
  const std::string stale = lock_of_dead_process();
  EXPECT_EQ(lock_holder(path_), "");
  const FileLock lock(path_);
  EXPECT_NE(read_file(lock_path(path_)), stale);
}

/// A zombie, as in a container whose first process waits for no others.
TEST_F(FileLockTest, OfAProcessThatHasEndedWhileNobodyWaitsForItIsReplaced) {
  const pid_t child = fork();
  if (child == 0) {
    const FileLock lock(path_);
    _exit(0);
  }
  siginfo_t ended = {};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
  EXPECT_EQ(lock_holder(path_), "");
  { const FileLock lock(path_); }
  waitpid(child, nullptr, 0);
}

TEST_F(FileLockTest, OfAnotherHostIsTakenOverOnRequestOnly) {
  write_lock("host = elsewhere\npid = 1\nstart = 2\nboot = x\njob = 12\n");
  EXPECT_EQ(lock_holder(path_), "process 1 on elsewhere, job 12");
  EXPECT_TRUE(throws_error(ErrorKind::Job, path_, {"process 1 on elsewhere, job 12", "--take-over"},
                           [&] { FileLock lock(path_); }));
  const FileLock lock(path_, true);
  EXPECT_TRUE(mentions(lock_holder(path_), {std::to_string(getpid())}));
}

TEST_F(FileLockTest, OfAProgramThatWasKilledWhileItCreatedTheLockIsReplacedAfterAWhile) {
  using namespace std::chrono_literals;
  write_lock("");
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(lock_path(path_), now - 9s);
  const FileLock lock(path_);
  EXPECT_TRUE(mentions(lock_holder(path_), {std::to_string(getpid())}));
}

TEST_F(FileLockTest, AProgramThatIsJustCreatingTheLockIsAwaitedAndNamed) {
  write_lock("");
  const pid_t child = fork();
  if (child == 0) {
    usleep(100'000);
    std::ofstream(lock_path(path_)) << "host = elsewhere\npid = 1\n";
    _exit(0);
  }
  EXPECT_TRUE(throws_error(ErrorKind::Job, path_, {"process 1 on elsewhere"},
                           [&] { FileLock lock(path_); }));
  waitpid(child, nullptr, 0);
}

TEST_F(FileLockTest, OfAJobThatWasStartedAgainIsReplaced) {
  write_lock("host = elsewhere\npid = 1\nstart = 2\nboot = x\njob = 12\nrestart =\n");
  setenv("SLURM_JOB_ID", "12", 1);
  setenv("SLURM_RESTART_COUNT", "1", 1);
  EXPECT_EQ(lock_holder(path_), "");
  { const FileLock lock(path_); }
  unsetenv("SLURM_JOB_ID");
  unsetenv("SLURM_RESTART_COUNT");
}

TEST_F(FileLockTest, AForkedProcessDoesNotReleaseIt) {
  const FileLock lock(path_);
  const pid_t child = fork();
  if (child == 0) {
    lock.~FileLock();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_NE(lock_holder(path_), "");
}

TEST_F(FileLockTest, ALockThatWasTakenOverIsNotReleasedByItsFirstHolder) {
  {
    const FileLock lock(path_);
    write_lock("host = elsewhere\npid = 1\n");
  }
  EXPECT_EQ(lock_holder(path_), "process 1 on elsewhere");
}

TEST_F(FileLockTest, APipeInItsPlaceIsRefusedWithoutWaiting) {
  ASSERT_EQ(mkfifo(lock_path(path_).c_str(), 0600), 0);
  EXPECT_TRUE(throws_error(ErrorKind::Job, lock_path(path_) + ": is not a regular file", {},
                           [&] { FileLock lock(path_); }));
}

TEST_F(FileLockTest, WaitsForAProgramThatHasLockedTheLockFileAndSaysSo) {
  write_lock(lock_of_dead_process());
  int other = open(lock_path(path_).c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  std::vector<std::string> notices;
  {
    const FileLock lock(path_, false, [&](const std::string& notice) {
      notices.push_back(notice);
      close(other);
      other = -1;
    });
    EXPECT_EQ(other, -1);
  }
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_TRUE(mentions(notices[0], {lock_path(path_), "flock"}));
}

TEST_F(FileLockTest, AReaderOfTheLockFileDoesNotDelayItsEnd) {
  auto lock = std::make_unique<FileLock>(path_);
  const int reader = open(lock_path(path_).c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(reader, LOCK_SH), 0);
  lock.reset();
  EXPECT_FALSE(std::filesystem::exists(lock_path(path_)));
  close(reader);
}

}  // namespace
}  // namespace slalom
