#include <slalom/campaign/worker_pool.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <dirent.h>
#include <map>
#include <set>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

using Status = TaskResult::Status;

std::vector<TaskResult> run_all(std::size_t count, const PoolOptions& options,
                                const WorkerTask& task) {
  std::vector<TaskResult> results;
  const auto receive = [&](std::size_t index, TaskResult&& result) {
    EXPECT_EQ(index, results.size()) << "results must come in the order of the tasks";
    results.push_back(std::move(result));
  };
  EXPECT_TRUE(run_in_workers(count, options, task, receive, nullptr));
  return results;
}

PoolOptions with_workers(int workers) {
  PoolOptions options;
  options.workers = workers;
  return options;
}

TEST(WorkerPool, ResultsComeInOrderFromAnyNumberOfWorkers) {
  const WorkerTask task = [](std::size_t i, TaskNotes&) {
    usleep(i % 3 == 0 ? 3000 : 0);  // so that workers overtake each other
    return "task " + std::to_string(i);
  };
  for (const int workers : {1, 2, 5, 100}) {
    const auto results = run_all(40, with_workers(workers), task);
    ASSERT_EQ(results.size(), 40U);
    for (std::size_t i = 0; i < results.size(); ++i)
      EXPECT_EQ(results[i].payload, "task " + std::to_string(i));
  }
}

TEST(WorkerPool, NoTasksIsFine) {
  EXPECT_TRUE(run_all(0, with_workers(2), [](std::size_t, TaskNotes&) { return ""; }).empty());
}

TEST(WorkerPool, LargePayloadsArriveWhole) {
  const auto results = run_all(3, with_workers(2), [](std::size_t i, TaskNotes&) {
    return std::string(5'000'000, static_cast<char>('a' + i));
  });
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_TRUE(results[i].payload == std::string(5'000'000, static_cast<char>('a' + i)));
}

TEST(WorkerPool, ATaskThatKillsItsProcessCostsOnlyItself) {
  const auto results = run_all(6, with_workers(2), [](std::size_t i, TaskNotes&) -> std::string {
    if (i == 1) {
      std::signal(SIGSEGV, SIG_DFL);  // sanitizers would catch it and exit
      std::raise(SIGSEGV);
    }
    if (i == 2) std::abort();
    if (i == 3) std::_Exit(7);
    if (i == 4) throw std::runtime_error("no idea");
    return "fine";
  });
  ASSERT_EQ(results.size(), 6U);
  EXPECT_EQ(results[0].payload, "fine");
  EXPECT_EQ(results[1].status, Status::Crashed);
  EXPECT_EQ(results[1].detail, "killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(results[2].detail, "killed by signal 6 (Aborted)");
  EXPECT_EQ(results[3].detail, "ended its process with exit status 7");
  EXPECT_EQ(results[4].status, Status::Threw);
  EXPECT_EQ(results[4].detail, "no idea");
  EXPECT_EQ(results[5].payload, "fine");
}

TEST(WorkerPool, ATaskThatHangsIsKilledAfterTheLimit) {
  PoolOptions options = with_workers(2);
  options.task_wall_time = 0.2;
  const auto results = run_all(4, options, [](std::size_t i, TaskNotes&) -> std::string {
    volatile bool forever = i == 1;
    while (forever) {
    }
    return "fine";
  });
  EXPECT_EQ(results[1].status, Status::TimedOut);
  for (const std::size_t i : {0U, 2U, 3U}) EXPECT_EQ(results[i].payload, "fine");
}

TEST(WorkerPool, WhatATaskNotedSurvivesItsDeath) {
  PoolOptions options = with_workers(2);
  options.notes_size = 10;
  const auto results = run_all(3, options, [](std::size_t i, TaskNotes& notes) -> std::string {
    notes.append("note", 4);
    notes.append(i == 1 ? "worthy" : "too much", i == 1 ? 6 : 8);
    std::_Exit(1);
  });
  EXPECT_EQ(results[0].notes, "note") << "what does not fit is left out";
  EXPECT_EQ(results[1].notes, "noteworthy");
  EXPECT_EQ(results[2].notes, "note") << "notes of the task before are gone";
}

TEST(WorkerPool, ATaskThatFallsSilentIsKilled) {
  PoolOptions options = with_workers(1);
  options.silence = 0.5;
  options.task_wall_time = 20;
  const auto results = run_all(3, options, [](std::size_t i, TaskNotes& notes) -> std::string {
    if (i == 0) usleep(800000);  // never beat: it may take its time
    for (int beat = 0; i > 0 && beat < 8; ++beat) {
      usleep(i == 2 && beat == 4 ? 5000000 : 30000);
      notes.beat();
    }
    return "fine";
  });
  EXPECT_EQ(results[0].payload, "fine");
  EXPECT_EQ(results[1].payload, "fine");
  EXPECT_EQ(results[2].status, Status::TimedOut);
  EXPECT_EQ(results[2].detail, "no answer within 0.5 s of a cycle");
}

TEST(WorkerPool, ATaskThatUsesUpItsProcessorTimeIsKilled) {
  PoolOptions options = with_workers(1);
  options.task_cpu_time = 0.5;
  options.task_wall_time = 60;
  const auto results = run_all(2, options, [](std::size_t i, TaskNotes&) -> std::string {
    volatile bool forever = i == 0;
    while (forever) {
    }
    return "fine";
  });
  EXPECT_EQ(results[0].status, Status::TimedOut);
  EXPECT_EQ(results[0].detail, "used up 0.5 s of processor time");
  EXPECT_EQ(results[1].payload, "fine");
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(WorkerPool, ATaskThatTakesTooMuchMemoryEndsOnlyItself) {
  PoolOptions options = with_workers(1);
  options.memory_mb = 200;
  const auto results = run_all(2, options, [](std::size_t i, TaskNotes&) {
    return std::to_string(std::string(i == 0 ? 300 << 20 : 100 << 20, 'x').size());
  });
  EXPECT_EQ(results[0].status, Status::OutOfMemory);
  EXPECT_EQ(results[1].payload, std::to_string(100 << 20));
}
#endif

TEST(WorkerPool, ARetiredWorkerIsReplaced) {
  int tasks_here = 0;
  const auto results = run_all(4, with_workers(1), [&tasks_here](std::size_t i, TaskNotes& notes) {
    if (i == 1) notes.retire_worker();
    return std::to_string(++tasks_here);
  });
  EXPECT_EQ(results[1].payload, "2");
  EXPECT_EQ(results[2].payload, "1") << "a fresh process";
  EXPECT_EQ(results[3].payload, "2");
}

TEST(WorkerPool, FreshProcessesShareNothing) {
  int state = 0;
  PoolOptions options = with_workers(2);
  const WorkerTask task = [&state](std::size_t, TaskNotes&) { return std::to_string(++state); };
  options.fresh_process = true;
  for (const TaskResult& result : run_all(5, options, task)) EXPECT_EQ(result.payload, "1");
  EXPECT_EQ(state, 0) << "tasks must not run in the caller's process";
}

TEST(WorkerPool, StandardOutputOfTasksIsDiscarded) {
  testing::internal::CaptureStdout();
  run_all(2, with_workers(1), [](std::size_t, TaskNotes&) {
    const char text[] = "noise";
    return std::to_string(write(STDOUT_FILENO, text, sizeof text));
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(WorkerPool, AnInterruptEndsTheWorkAndKeepsWhatIsThere) {
  std::size_t received = 0;
  const bool complete = run_in_workers(
      1000, with_workers(2),
      [](std::size_t, TaskNotes&) {
        usleep(1000);
        return std::string();
      },
      [&](std::size_t, TaskResult&&) { ++received; }, [&] { return received >= 10; });
  EXPECT_FALSE(complete);
  EXPECT_GE(received, 10U);
  EXPECT_LT(received, 1000U);
}

std::size_t open_files() {
  std::size_t count = 0;
  DIR* folder = opendir("/proc/self/fd");
  while (readdir(folder) != nullptr) ++count;
  closedir(folder);
  return count;
}

TEST(WorkerPool, LeavesNoOpenFilesBehind) {
  const std::size_t before = open_files();
  run_all(50, with_workers(3), [](std::size_t i, TaskNotes&) -> std::string {
    if (i % 2 == 0) std::_Exit(1);
    return "";
  });
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace slalom
