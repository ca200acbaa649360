// SPDX-License-Identifier: BSD-3-Clause
#include "manual_time.h"
#include "open_files.h"
#include "shared_count.h"
#include "temporary_folder.h"

#include <slalom/core/error.h>
#include <slalom/core/orphans.h>
#include <slalom/core/read_file.h>
#include <slalom/workers/worker_pool.h>
#include <slalom/workers/worker_sandbox.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <sched.h>
#include <set>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

using Status = WorkResult::Status;

std::vector<WorkResult> run_all(std::size_t count, const PoolOptions& options,
                                const WorkItem& item) {
  std::vector<WorkResult> results;
  const auto receive = [&](std::size_t index, WorkResult&& result) {
    EXPECT_EQ(index, results.size()) << "results must arrive in the order of the work items";
    results.push_back(std::move(result));
  };
  EXPECT_TRUE(run_in_workers(count, options, item, receive, nullptr));
  return results;
}

PoolOptions with_workers(int workers) {
  PoolOptions options;
  options.schedule.workers = workers;
  return options;
}

TEST(WorkerPool, UnorderedResultsArriveWhileAnEarlierWorkItemTakesLong) {
  ManualTime time;  // shared memory: 1 s when item 1 has arrived
  PoolOptions options = with_workers(2);
  options.schedule.ordered = false;
  const WallClock clock = time.clock();
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) {
    while (i == 0 && clock() < 1) usleep(500);
    return std::to_string(i);
  };
  std::vector<std::string> arrived;
  const auto receive = [&](std::size_t, WorkResult&& result) {
    arrived.push_back(result.payload);
    time.advance(1);
  };
  EXPECT_TRUE(run_in_workers(2, options, item, receive, nullptr));
  EXPECT_EQ(arrived, (std::vector<std::string>{"1", "0"}));
}

/// All work items count as short: the clock of the pool stands still.
PoolOptions with_short_items(int workers) {
  PoolOptions options = with_workers(workers);
  options.hooks.clock = [] { return 0.0; };
  return options;
}

/// The results of `count` work items in one worker, as they are stored: that of item `waiting` only
/// when item `awaited` has begun.
std::vector<std::string> stored_results(std::size_t count, std::size_t waiting,
                                        std::size_t awaited) {
  ManualTime begun;  // shared memory: 1 s when the awaited item has begun
  const WallClock clock = begun.clock();
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) {
    if (i == awaited) begun.advance(1);
    return std::to_string(i);
  };
  std::vector<std::string> stored;
  const auto store = [&](std::size_t i, WorkResult&& result) {
    while (i == waiting && clock() < 1) usleep(500);
    stored.push_back(result.payload);
  };
  EXPECT_TRUE(run_in_workers(count, with_short_items(1), item, store, nullptr));
  return stored;
}

TEST(WorkerPool, TheNextWorkItemBeginsBeforeAResultIsStored) {
  EXPECT_EQ(stored_results(2, 0, 1), (std::vector<std::string>{"0", "1"}));
}

TEST(WorkerPool, AWorkerBeginsAShortItemWithoutWaitingForTheParent) {
  // Item 5 begins after item 4, whose answer the parent reads only when result 3 is stored.
  EXPECT_EQ(stored_results(8, 3, 5),
            (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7"}));
}

TEST(WorkerPool, ItemsThatWaitInAWorkerKeepTheirOwnLogAndOutput) {
  PoolOptions options = with_short_items(2);
  options.log_size = 100;
  options.hooks.is_valid = [](std::size_t, const std::string& payload) { return payload != "bad"; };
  const auto results = run_all(300, options, [](std::size_t i, SharedTaskLog& log) -> std::string {
    const std::string number = std::to_string(i);
    log.append(number.data(), number.size());
    log.heartbeat();
    std::printf("%s", number.c_str());
    if (i % 17 == 5) std::fflush(stdout);
    if (i % 17 == 5) std::_Exit(3);
    return i % 17 == 9 ? "bad" : number;
  });
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool fails = i % 17 == 5 || i % 17 == 9;
    EXPECT_EQ(results[i].status, fails ? Status::Crashed : Status::Done) << i;
    EXPECT_EQ(results[i].payload, fails ? "" : std::to_string(i));
    EXPECT_EQ(results[i].log, fails ? std::to_string(i) : "");
    EXPECT_EQ(results[i].output, std::to_string(i));
  }
}

TEST(WorkerPool, ItemsThatWaitInAWorkerThatIsReplacedBeginOnceElsewhere) {
  ManualTime begun;  // shared memory: seconds count the items that have begun
  const auto results = run_all(300, with_short_items(2), [&](std::size_t i, SharedTaskLog& log) {
    begun.advance(1);
    if (i % 7 == 3) log.retire_worker();
    return "item " + std::to_string(i);
  });
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i].payload, "item " + std::to_string(i));
  EXPECT_EQ(begun.clock()(), 300);
}

TEST(WorkerPool, ResultsArriveInOrderForAnyNumberOfWorkers) {
  const WorkItem item = [](std::size_t i, SharedTaskLog&) {
    usleep(i % 3 == 0 ? 3000 : 0);  // so that workers overtake each other
    return "item " + std::to_string(i);
  };
  for (const int workers : {1, 2, 5, 100}) {
    const auto results = run_all(40, with_workers(workers), item);
    ASSERT_EQ(results.size(), 40U);
    for (std::size_t i = 0; i < results.size(); ++i)
      EXPECT_EQ(results[i].payload, "item " + std::to_string(i));
  }
}

TEST(WorkerPool, AcceptsZeroWorkItems) {
  EXPECT_TRUE(run_all(0, with_workers(2), [](std::size_t, SharedTaskLog&) { return ""; }).empty());
}

TEST(WorkerPool, LargePayloadsArriveComplete) {
  const auto results = run_all(3, with_workers(2), [](std::size_t i, SharedTaskLog&) {
    return std::string(5'000'000, static_cast<char>('a' + i));
  });
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_TRUE(results[i].payload == std::string(5'000'000, static_cast<char>('a' + i)));
}

class CrashOfAWorker : public testing::TestWithParam<bool> {};

TEST_P(CrashOfAWorker, AffectsOnlyItsOwnWorkItem) {
  PoolOptions options = with_workers(2);
  options.schedule.trusted = GetParam();
  const auto results = run_all(6, options, [](std::size_t i, SharedTaskLog&) -> std::string {
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
  EXPECT_EQ(results[3].detail, "process exited with status 7");
  EXPECT_EQ(results[4].status, Status::Threw);
  EXPECT_EQ(results[4].detail, "no idea");
  EXPECT_EQ(results[5].payload, "fine");
}

INSTANTIATE_TEST_SUITE_P(Trusted, CrashOfAWorker, testing::Bool());

TEST(WorkerPool, AHangingWorkItemIsKilledAtTheTimeLimit) {
  ManualTime time;
  PoolOptions options = with_workers(1);
  options.hooks.clock = time.clock();
  options.limits.item_wall_time = 20;
  const auto results = run_all(4, options, [&time](std::size_t i, SharedTaskLog&) -> std::string {
    time.advance_observed(i == 1 ? 20.1 : 19.9);
    return "fine";
  });
  EXPECT_EQ(results[1].status, Status::TimedOut);
  EXPECT_EQ(results[1].detail, "run_wall_time = 20 s exceeded, a wall-clock limit on this machine");
  for (const std::size_t i : {0U, 2U, 3U}) EXPECT_EQ(results[i].payload, "fine");
}

TEST(WorkerPool, TheLogSurvivesTheProcess) {
  PoolOptions options = with_workers(2);
  options.log_size = 10;
  const auto results = run_all(3, options, [](std::size_t i, SharedTaskLog& log) -> std::string {
    log.append("note", 4);
    log.append(i == 1 ? "worthy" : "too much", i == 1 ? 6 : 8);
    std::_Exit(1);
  });
  EXPECT_EQ(results[0].log, "note") << "entries beyond the capacity are dropped";
  EXPECT_EQ(results[1].log, "noteworthy");
  EXPECT_EQ(results[2].log, "note") << "the log of the previous work item is cleared";
}

TEST(WorkerPool, AWorkItemWithoutHeartbeatIsKilled) {
  ManualTime time;
  PoolOptions options = with_workers(1);
  options.hooks.clock = time.clock();
  options.limits.heartbeat_timeout = 0.5;
  options.limits.item_wall_time = 20;
  const auto results =
      run_all(3, options, [&time](std::size_t i, SharedTaskLog& log) -> std::string {
        if (i == 0) time.advance_observed(19);  // no first heartbeat: no timeout
        for (int heartbeat = 0; i > 0 && heartbeat < 8; ++heartbeat) {
          time.advance_observed(i == 2 && heartbeat == 4 ? 0.51 : 0.49);
          log.heartbeat();
        }
        return "fine";
      });
  EXPECT_EQ(results[0].payload, "fine");
  EXPECT_EQ(results[1].payload, "fine");
  EXPECT_EQ(results[2].status, Status::TimedOut);
  EXPECT_EQ(results[2].detail, "no response within 0.5 s");
}

TEST(WorkerPool, AWorkItemIsKilledAtItsCpuTimeLimit) {
  PoolOptions options = with_workers(1);
  options.limits.item_cpu_time = 0.5;
  options.limits.item_wall_time = 60;
  const auto results = run_all(2, options, [](std::size_t i, SharedTaskLog&) -> std::string {
    volatile bool forever = i == 0;
    while (forever) {
    }
    return "fine";
  });
  EXPECT_EQ(results[0].status, Status::TimedOut);
  EXPECT_EQ(results[0].detail, "CPU time limit of 0.5 s exceeded");
  EXPECT_EQ(results[1].payload, "fine");
}

#if !defined(SLALOM_SANITIZE)
TEST(WorkerPool, ExhaustedMemoryAffectsOnlyItsOwnWorkItem) {
  PoolOptions options = with_workers(1);
  options.limits.memory_mb = 200;
  const auto results = run_all(2, options, [](std::size_t i, SharedTaskLog&) {
    return std::to_string(std::string(i == 0 ? 300 << 20 : 100 << 20, 'x').size());
  });
  EXPECT_EQ(results[0].status, Status::OutOfMemory);
  EXPECT_EQ(results[1].payload, std::to_string(100 << 20));
}
#endif

TEST(WorkerPool, ARetiredWorkerIsReplaced) {
  int executed = 0;
  const auto results = run_all(4, with_workers(1), [&executed](std::size_t i, SharedTaskLog& log) {
    if (i == 1) log.retire_worker();
    return std::to_string(++executed);
  });
  EXPECT_EQ(results[1].payload, "2");
  EXPECT_EQ(results[2].payload, "1") << "a new process";
  EXPECT_EQ(results[3].payload, "2");
}

TEST(WorkerPool, AWorkerWhosePayloadIsNotValidIsReplaced) {
  int executed = 0;
  PoolOptions options = with_workers(1);
  options.log_size = 10;
  std::vector<std::size_t> checked;
  options.hooks.is_valid = [&](std::size_t i, const std::string& payload) {
    checked.push_back(i);
    return payload != "2";
  };
  const WorkItem item = [&executed](std::size_t, SharedTaskLog& log) {
    log.append("log", 3);
    return std::to_string(++executed);
  };
  for (const bool in_process : {false, true}) {
    options.schedule.in_process = in_process;
    checked.clear();
    const auto results = run_all(3, options, item);
    EXPECT_EQ(checked, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(results[0].payload, "1");
    EXPECT_EQ(results[1].status, Status::Crashed);
    EXPECT_EQ(results[1].detail, kInvalidPayload);
    EXPECT_EQ(results[1].log, "log");
    EXPECT_EQ(results[1].payload, "");
    EXPECT_EQ(results[2].payload, in_process ? "3" : "1") << "a new process";
  }
}

TEST(WorkerPool, FreshProcessesDoNotShareState) {
  int state = 0;
  PoolOptions options = with_workers(2);
  const WorkItem item = [&state](std::size_t, SharedTaskLog&) { return std::to_string(++state); };
  options.schedule.process_per_item = true;
  for (const bool trusted : {false, true}) {
    options.schedule.trusted = trusted;
    for (const WorkResult& result : run_all(5, options, item)) EXPECT_EQ(result.payload, "1");
  }
  EXPECT_EQ(state, 0) << "work items must not run in the calling process";
}

TEST(WorkerPool, AProcessOnlyGetsWorkItemsOfOneGroup) {
  std::size_t group_before = 99;
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) {
    const bool mixed = group_before != 99 && group_before != i % 3;
    group_before = i % 3;
    return (mixed ? "mixed " : "") + std::to_string(getpid());
  };
  for (const int workers : {1, 2, 5}) {
    PoolOptions options = with_workers(workers);
    options.schedule.group = [](std::size_t i) { return i % 3; };
    options.schedule.groups = 3;
    std::map<std::size_t, std::set<std::string>> processes;
    const auto results = run_all(60, options, item);
    for (std::size_t i = 0; i < results.size(); ++i) processes[i % 3].insert(results[i].payload);
    for (const auto& [group, pids] : processes) {
      EXPECT_LE(pids.size(), static_cast<std::size_t>(workers)) << "they stay alive";
      for (const std::string& pid : pids) EXPECT_EQ(pid.find("mixed"), std::string::npos);
    }
  }
}

TEST(WorkerPool, AtMostOneWorkItemPerWorkerIsExecutedAtATime) {
  ManualTime busy;  // seconds count the work items that are being executed
  PoolOptions options = with_workers(1);
  options.schedule.group = [](std::size_t i) { return i; };
  options.schedule.groups = 10;
  const auto results = run_all(10, options, [&](std::size_t, SharedTaskLog&) {
    busy.advance(1);
    usleep(1000);
    const double most = busy.clock()();
    busy.advance(-1);
    return std::to_string(static_cast<int>(most));
  });
  for (const WorkResult& result : results) EXPECT_EQ(result.payload, "1");
}

TEST(WorkerPool, IdleProcessesOfManyGroupsAreEnded) {
  PoolOptions options = with_workers(1);
  options.schedule.group = [](std::size_t i) { return i; };
  options.schedule.groups = 2;  // three processes are kept
  ManualTime ended;
  options.hooks.at_end = [&] { ended.advance(1); };
  const auto results = run_all(10, options, [&](std::size_t, SharedTaskLog&) {
    return std::to_string(static_cast<int>(ended.clock()()));
  });
  EXPECT_EQ(results[2].payload, "0");
  EXPECT_EQ(results[3].payload, "1");
  EXPECT_EQ(results[9].payload, "7");
  EXPECT_EQ(ended.clock()(), 10) << "all are ended when the pool is done";
}

TEST(WorkerPool, AProcessThatDoesNotEndIsKilled) {
  PoolOptions options = with_workers(1);
  options.hooks.at_end = [] {
    while (true) pause();
  };
  EXPECT_EQ(run_all(1, options, [](std::size_t, SharedTaskLog&) { return "fine"; })[0].payload,
            "fine");
}

TEST(WorkerPool, StandardOutputOfWorkersIsDiscarded) {
  testing::internal::CaptureStdout();
  run_all(2, with_workers(1), [](std::size_t, SharedTaskLog&) {
    const char text[] = "noise";
    return std::to_string(write(STDOUT_FILENO, text, sizeof text));
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(WorkerPool, AnInterruptKeepsTheResultsSoFar) {
  std::size_t received = 0;
  const bool complete = run_in_workers(
      1000, with_workers(2),
      [](std::size_t, SharedTaskLog&) {
        usleep(1000);
        return std::string();
      },
      [&](std::size_t, WorkResult&&) { ++received; }, [&] { return received >= 10; });
  EXPECT_FALSE(complete);
  EXPECT_GE(received, 10U);
  EXPECT_LT(received, 1000U);
}

TEST(WorkerPool, OrderedResultsAfterAnItemThatAnInterruptKillsAreDropped) {
  for (const std::size_t stuck : {std::size_t{0}, std::size_t{3}}) {
    for (const int workers : {2, 3}) {
      const SharedCount begun;
      std::vector<std::size_t> received;
      const bool complete = run_in_workers(
          1000, with_workers(workers),
          [&](std::size_t i, SharedTaskLog&) {
            if (i == stuck) pause();
            ++*begun;
            return std::string();
          },
          [&](std::size_t i, WorkResult&&) { received.push_back(i); },
          // Then many later ones have been answered: a worker has one item ahead at most.
          [&] { return *begun >= 40 && received.size() >= stuck; });
      EXPECT_FALSE(complete);
      std::vector<std::size_t> expected(stuck);
      std::iota(expected.begin(), expected.end(), std::size_t{0});
      EXPECT_EQ(received, expected) << workers;
    }
  }
}

/// In a worker.
int own_socket() {
  for (const int file : open_files()) {
    struct stat status = {};
    if (fstat(file, &status) == 0 && S_ISSOCK(status.st_mode)) return file;
  }
  return -1;
}

/// Starts a process that has left the worker's process group, session and children.
pid_t start_daemon() {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  if (fork() == 0) {
    setsid();
    const pid_t daemon = fork();
    if (daemon > 0 && write(ends[1], &daemon, sizeof daemon) > 0) _exit(0);
    prctl(PR_SET_PTRACER, PR_SET_PTRACER_ANY);
    while (true) pause();
  }
  pid_t daemon = 0;
  EXPECT_GT(read(ends[0], &daemon, sizeof daemon), 0);
  return daemon;
}

TEST(WorkerPool, AProcessHasNoDescriptorsButItsSocketAndPipes) {
  const int files[] = {open("/dev/null", O_RDONLY), open("/dev/null", O_RDONLY)};
  const auto results = run_all(4, with_workers(2), [](std::size_t, SharedTaskLog&) {
    char input[64] = {};
    const auto length = readlink("/proc/self/fd/0", input, sizeof input - 1);
    return std::to_string(open_files().size()) + " " +
           std::string(input, static_cast<std::size_t>(length));
  });
  for (const int file : files) close(file);
  for (const WorkResult& result : results) EXPECT_EQ(result.payload, "6 /dev/null");
}

TEST(WorkerPool, OnlyTheAnswerToARequestIsTakenForIt) {
  // Also where the next work item is in the worker already.
  const auto results = run_all(60, with_short_items(1), [](std::size_t i, SharedTaskLog&) {
    const std::uint64_t forged[] = {1, i, 0, 'D'};  // the nonce, index, size and kind of an answer
    if (i % 10 == 1) send(own_socket(), forged, sizeof forged, 0);
    if (i % 10 == 3) send(own_socket(), std::string(99, 'x').data(), 99, 0);
    return "item " + std::to_string(i);
  });
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].status, i % 10 == 1 || i % 10 == 3 ? Status::Crashed : Status::Done);
    EXPECT_EQ(results[i].detail, i % 10 == 1   ? "sent an unsolicited reply"
                                 : i % 10 == 3 ? "wrote invalid data to the worker's socket"
                                               : "");
    EXPECT_EQ(results[i].payload, results[i].detail.empty() ? "item " + std::to_string(i) : "");
  }
}

TEST(WorkerPool, AWorkItemThatForksAnswersOnce) {
  const auto results = run_all(6, with_workers(2), [](std::size_t i, SharedTaskLog&) {
    if (i % 2 == 0 && fork() < 0) return std::string("cannot fork");
    return "item " + std::to_string(i);
  });
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i].payload, "item " + std::to_string(i));
}

TEST(WorkerPool, ACrashIsSeenWhileAChildHoldsTheSocket) {
  const auto results =
      run_all(2, with_workers(1), [](std::size_t i, SharedTaskLog&) -> std::string {
        if (i == 0 && fork() == 0)
          while (true) pause();
        if (i == 0) std::_Exit(3);
        return "fine";
      });
  EXPECT_EQ(results[0].detail, "process exited with status 3");
  EXPECT_EQ(results[1].payload, "fine");
}

TEST(WorkerPool, WhateverAProcessStartedDiesWithIt) {
  PoolOptions options = with_workers(2);
  options.log_size = sizeof(pid_t);
  const auto results = run_all(2, options, [](std::size_t i, SharedTaskLog& log) {
    const pid_t daemon = start_daemon();
    log.append(&daemon, sizeof daemon);
    if (i == 0) std::_Exit(1);
    return std::string(reinterpret_cast<const char*>(&daemon), sizeof daemon);
  });
  for (const std::string& bytes : {results[0].log, results[1].payload}) {
    pid_t daemon = 0;
    ASSERT_EQ(bytes.size(), sizeof daemon);
    std::memcpy(&daemon, bytes.data(), sizeof daemon);
    EXPECT_EQ(kill(daemon, 0), -1) << "process " << daemon;
  }
}

TEST(WorkerPool, ReplacedProcessesAreOfTheSameKeeper) {
  PoolOptions options = with_workers(1);
  options.schedule.process_per_item = true;
  std::set<std::string> keepers;
  for (const WorkResult& result : run_all(3, options, [](std::size_t i, SharedTaskLog&) {
         if (i == 1) std::_Exit(1);
         return std::to_string(getppid());
       }))
    if (result.status == Status::Done) keepers.insert(result.payload);
  EXPECT_EQ(keepers.size(), 1U);
  EXPECT_EQ(keepers.count(std::to_string(getpid())), 0U);
}

TEST(WorkerPool, AWorkItemThatKillsItsKeeperHarmsNoOther) {
  const auto results = run_all(9, with_workers(3), [](std::size_t i, SharedTaskLog&) {
    if (i == 4 && kill(getppid(), SIGKILL) == 0) pause();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return std::string("fine");
  });
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i].payload, i == 4 ? "" : "fine") << i << ": " << results[i].detail;
  EXPECT_EQ(results[4].status, Status::Crashed);
  EXPECT_EQ(results[4].detail,
            "its supervising process was stopped or killed twice, the second time alone");
}

TEST(WorkerPool, AWorkItemThatKillsItsKeeperAndGoesOnHarmsNoOther) {
  for (int repetition = 0; repetition < 20; ++repetition) {
    const auto results = run_all(12, with_workers(2), [](std::size_t i, SharedTaskLog&) {
      if (i % 6 == 3) kill(getppid(), SIGKILL);
      return std::string("fine");
    });
    for (std::size_t i = 0; i < results.size(); ++i)
      ASSERT_EQ(results[i].payload, i % 6 == 3 ? "" : "fine") << i << ": " << results[i].detail;
  }
}

TEST(WorkerPool, WhatAWorkItemPrintsIsItsOwn) {
  const auto results = run_all(6, with_workers(1), [](std::size_t i, SharedTaskLog&) {
    std::printf("out %zu", i);  // without a line's end
    std::fprintf(stderr, "|error %zu|", i);
    std::cout << "stream " << i;
    if (i == 2) throw std::runtime_error("thrown");
    if (i == 3) std::printf("\n"), std::abort();
    return std::string();
  });
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string n = std::to_string(i), out = "out " + n + "stream " + n;
    EXPECT_EQ(results[i].output, "|error " + n + "|" + out + (i == 3 ? "\n" : ""));
  }
}

TEST(WorkerPool, OfMuchThatIsPrintedTheBeginningAndTheEndAreKept) {
  constexpr std::size_t kLines = 1'000'000;  // more than a pipe holds
  const auto results = run_all(1, with_workers(1), [](std::size_t, SharedTaskLog&) {
    for (std::size_t i = 0; i < kLines; ++i) std::printf("%07zu\n", i);
    return std::string("fine");
  });
  EXPECT_EQ(results[0].payload, "fine");
  const std::string& text = results[0].output;
  const std::size_t left_out = 8 * kLines - kMaxOutput;
  EXPECT_EQ(text.substr(0, 16), "0000000\n0000001\n");
  EXPECT_EQ(text.substr(text.size() - 8), "0999999\n");
  EXPECT_NE(text.find("... " + std::to_string(left_out) + " bytes left out ..."),
            std::string::npos);
  EXPECT_LT(text.size(), kMaxOutput + 100);
}

TEST(WorkerPool, WhatTheProgramHasNotYetPrintedIsOfNoWorkItem) {
  testing::internal::CaptureStdout();
  std::printf("of the program");
  const auto results = run_all(2, with_workers(1), [](std::size_t, SharedTaskLog&) {
    std::printf("own");
    return std::string();
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "of the program");
  EXPECT_EQ(results[0].output, "own");
  EXPECT_EQ(results[1].output, "own");
}

enum class Hold { Stop, Trace, TraceByDaemon };

/// Whether the keeper does not go on.
bool hold_keeper(Hold how, pid_t keeper) {
  if (how == Hold::Stop) return kill(keeper, SIGSTOP) == 0;
  if (how == Hold::Trace) return ptrace(PTRACE_ATTACH, keeper, nullptr, nullptr) == 0;
  int ends[2];
  if (pipe(ends) != 0) return false;
  if (fork() == 0) {
    setsid();
    if (fork() > 0) _exit(0);
    const char held = hold_keeper(Hold::Trace, keeper) ? 1 : 0;
    if (write(ends[1], &held, 1) < 1) _exit(1);
    while (true) pause();
  }
  char held = 0;
  return read(ends[0], &held, 1) == 1 && held == 1;
}

class HeldKeeper : public ::testing::TestWithParam<std::tuple<Hold, bool>> {};

TEST_P(HeldKeeper, OnlyTheWorkItemThatDoesItFails) {
  const pid_t program = fork();
  if (program == 0) {
    become_subreaper();  // so that daemons end, too
    const auto [how, goes_on] = GetParam();
    const auto results =
        run_all(8, with_workers(2), [how = how, goes_on = goes_on](std::size_t i, SharedTaskLog&) {
          if (i == 3 && !hold_keeper(how, getppid())) return std::string("cannot");
          if (i == 3 && !goes_on) pause();
          return std::string("fine");
        });
    if (results[3].payload == "cannot") _exit(2);
    for (std::size_t i = 0; i < results.size(); ++i)
      EXPECT_EQ(results[i].payload, i == 3 ? "" : "fine") << i << ": " << results[i].detail;
    EXPECT_EQ(results[3].detail,
              "its supervising process was stopped or killed twice, the second time alone");
    EXPECT_EQ(child_processes(), std::vector<pid_t>());
    _exit(HasFailure() ? 1 : 0);
  }
  int status = -1;
  waitpid(program, &status, 0);
  if (WEXITSTATUS(status) == 2) GTEST_SKIP() << "processes must not be traced here";
  EXPECT_EQ(status, 0);
}

INSTANTIATE_TEST_SUITE_P(WorkerPool, HeldKeeper,
                         ::testing::Combine(::testing::Values(Hold::Stop, Hold::Trace,
                                                              Hold::TraceByDaemon),
                                            ::testing::Bool()));

TEST(WorkerPool, AStoppedKeeperEndsWithItsProgram) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // the parent of the keeper when the program has ended
  SharedTaskLog log(sizeof(pid_t));
  const pid_t program = fork();
  if (program == 0)
    run_all(1, with_workers(1), [&, program = getpid()](std::size_t, SharedTaskLog&) {
      const pid_t keeper = getppid();
      log.append(&keeper, sizeof keeper);
      kill(keeper, SIGSTOP);
      kill(program, SIGKILL);
      pause();
      return std::string();
    });
  waitpid(program, nullptr, 0);
  const std::string bytes = log.contents();
  pid_t keeper = 0;
  ASSERT_EQ(bytes.size(), sizeof keeper);
  std::memcpy(&keeper, bytes.data(), sizeof keeper);
  EXPECT_EQ(waitpid(keeper, nullptr, 0), keeper);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

/// Traces the process whose number is in the log until `is_over`: when that is killed it does not
/// disappear before. `is_tracing` has 1 s when it does, 2 s if it must not.
pid_t start_tracer(const SharedTaskLog& log, ManualTime& is_tracing,
                   const std::function<bool()>& is_over) {
  const pid_t tracer = fork();
  if (tracer != 0) return tracer;
  pid_t traced = 0;
  while (log.contents().size() < sizeof traced) usleep(500);
  std::memcpy(&traced, log.contents().data(), sizeof traced);
  const bool traces = ptrace(PTRACE_SEIZE, traced, nullptr, nullptr) == 0;
  is_tracing.advance(traces ? 1 : 2);
  while (traces && !is_over()) usleep(500);
  _exit(traces ? 0 : 1);
}

TEST(WorkerPool, OthersGoOnWhileWhatAProcessStartedIsKilled) {
  constexpr std::size_t kCount = 10;
  SharedTaskLog daemons(sizeof(pid_t));
  ManualTime received, is_tracing;  // the seconds of the first are the results received
  const auto are_others_received = [clock = received.clock()] { return clock() >= kCount - 1; };
  const pid_t tracer = start_tracer(daemons, is_tracing, are_others_received);
  PoolOptions options = with_workers(2);
  options.schedule.ordered = false;
  std::vector<std::size_t> order;
  const auto receive = [&](std::size_t i, WorkResult&&) {
    order.push_back(i);
    received.advance(1);
  };
  run_in_workers(
      kCount, options,
      [&, clock = is_tracing.clock()](std::size_t i, SharedTaskLog&) -> std::string {
        if (i > 0) return "fine";
        const pid_t daemon = start_daemon();
        daemons.append(&daemon, sizeof daemon);
        while (clock() == 0) usleep(500);
        std::_Exit(1);
      },
      receive, nullptr);
  int status = 0;
  waitpid(tracer, &status, 0);
  if (status != 0) GTEST_SKIP() << "processes must not be traced here";
  ASSERT_EQ(order.size(), kCount);
  EXPECT_EQ(order.back(), 0U);
}

TEST(WorkerPool, InAProgramWhateverAProcessStartedDiesWithAKilledKeeper) {
  SharedTaskLog daemons(2 * sizeof(pid_t));  // of both times that it is executed
  const pid_t program = fork();
  if (program == 0) {
    become_subreaper();
    run_all(1, with_workers(1), [&](std::size_t, SharedTaskLog&) -> std::string {
      const pid_t daemon = start_daemon();
      daemons.append(&daemon, sizeof daemon);
      kill(getppid(), SIGKILL);
      pause();
      return "";
    });
    std::_Exit(child_processes().empty() ? 0 : 1);
  }
  int status = -1;
  waitpid(program, &status, 0);
  EXPECT_EQ(status, 0);
  const std::string bytes = daemons.contents();
  ASSERT_EQ(bytes.size(), 2 * sizeof(pid_t));
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(pid_t)) {
    pid_t daemon = 0;
    std::memcpy(&daemon, &bytes[at], sizeof daemon);
    EXPECT_EQ(kill(daemon, 0), -1) << "process " << daemon;
  }
}

TEST(WorkerPool, AWorkItemWhoseProcessIsKilledIsExecutedOnceMore) {
  ManualTime killed;  // its seconds count
  const auto results = run_all(3, with_workers(1), [&](std::size_t i, SharedTaskLog& log) {
    log.heartbeat();
    if (i == 2 || (i == 1 && killed.clock()() == 0)) {
      killed.advance(1);
      kill(0, SIGKILL);
    }
    return std::string("fine");
  });
  EXPECT_EQ(results[1].payload, "fine");
  EXPECT_EQ(results[2].status, Status::Crashed);
  EXPECT_EQ(results[2].detail, "killed by signal 9 (Killed) twice, the second time alone");
  EXPECT_EQ(killed.clock()(), 3);
}

TEST(WorkerPool, AProcessThatIsKilledWhileTheSystemIsOutOfMemoryHasNotCrashed) {
  ManualTime killed;
  PoolOptions options = with_workers(1);
  options.hooks.memory_kills = [&] { return static_cast<std::uint64_t>(killed.clock()()); };
  const auto results = run_all(2, options, [&](std::size_t i, SharedTaskLog&) {
    if (i == 0) killed.advance(1);
    std::raise(SIGKILL);
    return std::string();
  });
  EXPECT_EQ(results[0].status, Status::Killed);
  EXPECT_EQ(results[0].detail,
            "killed by signal 9 (Killed) twice, the second time alone; the system was out of "
            "memory");
  EXPECT_EQ(results[1].status, Status::Crashed) << "memory was short only before";
}

TEST(WorkerPool, ADeathBetweenTwoWorkItemsIsOfNeither) {
  ManualTime executions;  // its seconds count those of item 3
  int executed = 0;
  const auto results = run_all(5, with_workers(1), [&](std::size_t i, SharedTaskLog& log) {
    if (i == 3) executions.advance(1);
    if (i == 3 || (i == 1 && executed > 0)) std::_Exit(1);
    log.heartbeat();
    return std::to_string(++executed);
  });
  EXPECT_EQ(results[1].payload, "1") << "in a new process";
  EXPECT_EQ(results[3].status, Status::Crashed) << "its own: also in a new process";
  EXPECT_EQ(executions.clock()(), 2);
  EXPECT_EQ(results[4].payload, "1");
}

TEST(WorkerPool, ACrashAfterAHeartbeatIsNotRepeated) {
  ManualTime executions;
  const auto results = run_all(3, with_workers(1), [&](std::size_t i, SharedTaskLog& log) {
    log.heartbeat();
    if (i == 1) executions.advance(1);
    if (i == 1) std::_Exit(1);
    return std::string("fine");
  });
  EXPECT_EQ(results[1].status, Status::Crashed);
  EXPECT_EQ(executions.clock()(), 1);
}

TEST(WorkerPool, AnItemThatClosesItsDescriptorsIsNamed) {
  const auto results = run_all(2, with_workers(1), [](std::size_t i, SharedTaskLog&) {
    if (i == 0)
      for (const int file : open_files()) close(file);
    return std::string("fine");
  });
  EXPECT_EQ(results[0].status, Status::Crashed);
  EXPECT_EQ(results[0].detail, "closed the worker's connection to the simulator");
  EXPECT_EQ(results[1].payload, "fine");
}

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_sandbox()) GTEST_SKIP() << "needs a kernel with Landlock (Linux 5.13)";
  }

  /// The result of one work item in a sandbox.
  static WorkResult run_confined(const WorkItem& item,
                                 const std::vector<std::string>& writable = {}) {
    PoolOptions options = with_workers(1);
    options.limits.sandbox = true;
    options.limits.writable = writable;
    return run_all(1, options, item)[0];
  }

  /// "" or why the file cannot be opened in the way of fopen().
  static std::string cannot_open(const std::string& path, const char* mode) {
    FILE* file = fopen(path.c_str(), mode);
    if (file == nullptr) return std::strerror(errno);
    fclose(file);
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(Sandbox, FilesOutsideAreReadButNotChanged) {
  const std::string kept = folder_ / "kept";
  std::ofstream(kept) << "content";
  for (const char* mode : {"w", "a", "r+"})
    EXPECT_EQ(
        run_confined([&](std::size_t, SharedTaskLog&) { return cannot_open(kept, mode); }).payload,
        std::strerror(EACCES));
  const WorkResult others = run_confined([&](std::size_t, SharedTaskLog&) {
    std::string done;
    if (unlink(kept.c_str()) == 0) done += "unlink ";
    if (rename(kept.c_str(), (kept + "2").c_str()) == 0) done += "rename ";
    if (mkdir((kept + "3").c_str(), 0700) == 0) done += "mkdir ";
    if (symlink("/", (kept + "4").c_str()) == 0) done += "symlink ";
    if (std::system(("rm -f " + kept).c_str()) == 0) done += "rm ";
    return done + cannot_open(kept, "r") + cannot_open("/dev/null", "w");
  });
  EXPECT_EQ(others.payload, "");
  EXPECT_EQ(read_file(kept), "content");
}

/// The names of the attempts that were not refused with EPERM.
class Attempts {
 public:
  void add(const char* name, long status) {
    if (status == 0 || errno != EPERM) names_ += std::string(name) + " ";
  }
  const std::string& names() const { return names_; }

 private:
  std::string names_;
};

TEST_F(Sandbox, PermissionsOwnersTimesAndAttributesOfFilesAreNotChanged) {
  const std::string kept = folder_ / "kept";
  std::ofstream(kept) << "content";
  chmod(kept.c_str(), 0640);
  struct stat before = {}, after = {};
  ASSERT_EQ(stat(kept.c_str(), &before), 0);
  const WorkResult result = run_confined([&](std::size_t, SharedTaskLog&) {
    Attempts attempts;
    const int file = open(kept.c_str(), O_RDONLY | O_CLOEXEC);
    const timespec times[2] = {{1, 0}, {1, 0}};
    const timeval old[2] = {{1, 0}, {1, 0}};
    attempts.add("chmod", chmod(kept.c_str(), 0777));
    attempts.add("fchmod", fchmod(file, 0777));
    attempts.add("fchmodat", fchmodat(AT_FDCWD, kept.c_str(), 0777, 0));
    attempts.add("chown", chown(kept.c_str(), 1, 1));
    attempts.add("lchown", lchown(kept.c_str(), 1, 1));
    attempts.add("fchown", fchown(file, 1, 1));
    attempts.add("utimes", utimes(kept.c_str(), old));
    attempts.add("utimensat", utimensat(AT_FDCWD, kept.c_str(), times, 0));
    attempts.add("futimens", futimens(file, times));
    attempts.add("setxattr", setxattr(kept.c_str(), "user.a", "b", 1, 0));
    attempts.add("fsetxattr", fsetxattr(file, "user.a", "b", 1, 0));
    attempts.add(
        "chmod by a program",
        std::system(("chmod 777 " + kept + " 2>/dev/null").c_str()) == 0 ? 0 : (errno = EPERM, -1));
    return attempts.names();
  });
  EXPECT_EQ(result.payload, "");
  ASSERT_EQ(stat(kept.c_str(), &after), 0);
  EXPECT_EQ(after.st_mode, before.st_mode);
  EXPECT_EQ(after.st_uid, before.st_uid);
  EXPECT_EQ(after.st_mtime, before.st_mtime);
}

TEST_F(Sandbox, NothingOfOtherProcessesAndOfTheMachineIsSet) {
  const pid_t campaign = getpid();
  const WorkResult result = run_confined([&](std::size_t, SharedTaskLog&) {
    Attempts attempts;
    constexpr int kIoProcess = 1, kIoUser = 3;
    const sched_param ordinary = {};
    cpu_set_t all;
    sched_getaffinity(0, sizeof all, &all);
    int node = 0;
    void* page = &node;
    for (const pid_t other : {campaign, getppid(), getpid()}) {  // the filter knows no numbers
      rlimit limit = {};
      getrlimit(RLIMIT_NOFILE, &limit);
      attempts.add("prlimit", prlimit(other, RLIMIT_NOFILE, &limit, nullptr));
      attempts.add("setpriority", setpriority(PRIO_PROCESS, static_cast<id_t>(other), 0));
      attempts.add("affinity", sched_setaffinity(other, sizeof all, &all));
      attempts.add("scheduler", sched_setscheduler(other, SCHED_OTHER, &ordinary));
      attempts.add("parameters", sched_setparam(other, &ordinary));
      attempts.add("ioprio", syscall(SYS_ioprio_set, kIoProcess, other, 0));
      attempts.add("pages", syscall(SYS_move_pages, other, 1UL, &page, &node, &node, 0));
    }
    attempts.add("priority of the user", setpriority(PRIO_USER, 0, 0));
    attempts.add("ioprio of the user", syscall(SYS_ioprio_set, kIoUser, 0, 0));
    attempts.add("name", sethostname("slalom", 6));
    attempts.add("domain", setdomainname("slalom", 6));
    const timeval time = {1, 0};
    attempts.add("time", syscall(SYS_settimeofday, &time, nullptr));
    attempts.add("kernel module", syscall(SYS_delete_module, "slalom", 0));
    return attempts.names();
  });
  EXPECT_EQ(result.payload, "");
}

TEST_F(Sandbox, AProcessSetsItsOwnLimitsAndPriorities) {
  const WorkResult result = run_confined([&](std::size_t, SharedTaskLog&) {
    std::string refused;
    const auto attempt = [&](const char* name, long status) {
      if (status != 0) refused += std::string(name) + " ";
    };
    rlimit limit = {};
    getrlimit(RLIMIT_NOFILE, &limit);
    cpu_set_t all;
    sched_getaffinity(0, sizeof all, &all);
    const sched_param ordinary = {};
    attempt("setrlimit", setrlimit(RLIMIT_NOFILE, &limit));
    attempt("setpriority", setpriority(PRIO_PROCESS, 0, 1));
    attempt("priority of the group", setpriority(PRIO_PGRP, 0, 1));
    attempt("affinity", sched_setaffinity(0, sizeof all, &all));
    attempt("scheduler", sched_setscheduler(0, SCHED_OTHER, &ordinary));
    attempt("ioprio", syscall(SYS_ioprio_set, 1, 0, 0));
    return refused;
  });
  EXPECT_EQ(result.payload, "");
}

/// Ends this process after `check`, which has no rights of root: these raise any limit again.
template <typename Check>
void exit_as_ordinary_user(const Check& check) {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) _exit(3);
  _exit(check() ? 0 : 1);
}

TEST(WorkerPool, AnItemThatLowersALimitOfItsSupervisorIsCharged) {
  for (const auto resource : {RLIMIT_NOFILE, RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE})
    EXPECT_EXIT(exit_as_ordinary_user([&] {
                  const rlimit none = {1, 1};
                  const auto results =
                      run_all(6, with_workers(2), [&](std::size_t i, SharedTaskLog&) {
                        if (i == 2) prlimit(getppid(), resource, &none, nullptr);
                        return std::string("fine");
                      });
                  bool others_are_fine = true;
                  for (std::size_t i = 0; i < results.size(); ++i)
                    others_are_fine = others_are_fine && (i == 2 || results[i].payload == "fine");
                  return others_are_fine && results[2].status == Status::Crashed;
                }),
                testing::ExitedWithCode(0), "")
        << resource;
}

TEST(WorkerPool, AnItemThatLowersALimitOfTheProgramEndsItWithTheReason) {
  EXPECT_EXIT(exit_as_ordinary_user([&] {
                const pid_t self = getpid();
                const rlimit none = {1, 1};
                try {
                  run_all(2, with_workers(1), [&](std::size_t, SharedTaskLog&) {
                    prlimit(self, RLIMIT_MEMLOCK, &none, nullptr);
                    return std::string("fine");
                  });
                } catch (const Error& error) {
                  return std::string(error.what()).find("RLIMIT_MEMLOCK") != std::string::npos;
                }
                return false;
              }),
              testing::ExitedWithCode(0), "");
}

TEST_F(Sandbox, ItsFolderIsRemovedWhateverTheMethodDoesToItsPermissions) {
  const WorkResult result = run_confined([&](std::size_t, SharedTaskLog&) {
    const std::string own = std::filesystem::temp_directory_path().string();
    std::ofstream(own + "/file") << "content";
    chmod(own.c_str(), 0);
    return own;
  });
  EXPECT_NE(result.payload, "");
  EXPECT_FALSE(std::filesystem::exists(result.payload));
}

TEST_F(Sandbox, ItsOwnFolderAndThoseAllowedCanBeWrittenTo) {
  const std::string allowed = folder_ / "allowed";
  const std::string here = std::filesystem::temp_directory_path().string();
  const WorkResult result = run_confined(
      [&](std::size_t, SharedTaskLog&) {
        const std::string own = std::filesystem::temp_directory_path().string();
        return cannot_open(own + "/a", "w") + cannot_open(allowed, "w") + own;
      },
      {folder_ / ""});
  EXPECT_EQ(result.payload.rfind(here + "/slalom-worker-", 0), 0U) << result.payload;
  EXPECT_FALSE(std::filesystem::exists(result.payload)) << "it is removed with its worker";
  EXPECT_TRUE(std::filesystem::exists(allowed));
}

TEST_F(Sandbox, OfAWorkerThatIsKilledIsRemoved) {
  PoolOptions options = with_workers(1);
  options.limits.sandbox = true;
  options.log_size = 200;
  const WorkResult result = run_all(1, options, [](std::size_t, SharedTaskLog& log) -> std::string {
    const std::string own = std::filesystem::temp_directory_path().string();
    log.append(own.data(), own.size());
    std::abort();
  })[0];
  EXPECT_NE(result.log, "");
  EXPECT_FALSE(std::filesystem::exists(result.log)) << result.log;
}

TEST(WorkerPool, WithoutNetworkItsWorkersMakeSocketsWithinTheMachineOnly) {
  const auto refused = [](std::size_t, SharedTaskLog&) {
    std::string kinds;
    for (const int family : {AF_UNIX, AF_INET, AF_INET6, AF_NETLINK, AF_PACKET}) {
      const int made = socket(family, SOCK_DGRAM, 0);
      if (made < 0 && errno == EPERM) kinds += std::to_string(family) + " ";
      if (made >= 0) close(made);
    }
    const int status = std::system("bash -c 'echo >/dev/udp/127.0.0.1/9' 2>/dev/null");
    return kinds + (status == 0 ? "sent" : "not sent");
  };
  PoolOptions options = with_workers(1);
  // Packets need a right that the tests may not have.
  const std::string open = run_all(1, options, refused)[0].payload;
  EXPECT_EQ(open.find("2 "), std::string::npos) << open;
  options.limits.network = false;
  const WorkResult closed = run_all(1, options, refused)[0];
  EXPECT_EQ(closed.payload, std::to_string(AF_INET) + " " + std::to_string(AF_INET6) + " " +
                                std::to_string(AF_NETLINK) + " " + std::to_string(AF_PACKET) +
                                " not sent");
}

TEST(WorkerPool, SignalsThatEndTheProgramDoNotEndItsWorkItems) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    EXPECT_EQ(run_all(1, with_workers(1),
                      [=](std::size_t, SharedTaskLog&) {
                        kill(0, signal);  // its whole process group, which is not the program's
                        return "fine";
                      })[0]
                  .payload,
              "fine");
}

TEST(WorkerPool, LeavesNoOpenFilesBehind) {
  const std::vector<int> before = open_files();
  run_all(50, with_workers(3), [](std::size_t i, SharedTaskLog&) -> std::string {
    if (i % 2 == 0) std::_Exit(1);
    return "";
  });
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace slalom
