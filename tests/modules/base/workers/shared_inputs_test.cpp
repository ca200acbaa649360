// SPDX-License-Identifier: BSD-3-Clause
#include "manual_time.h"
#include "open_files.h"

#include <slalom/workers/worker_pool.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

constexpr std::size_t kItemsPerInput = 3;

/// Work items that answer with their input and process; three in a row use the same input, a text
/// with its number and the process that made it.
class Inputs : public testing::Test {
 protected:
  Inputs() {
    options_.schedule.ordered = false;
    options_.inputs.of = [](std::size_t i) {
      return std::optional<std::size_t>(i / kItemsPerInput);
    };
    options_.inputs.make = [this](std::size_t input, const ArrayWriter::Sink& sink) {
      made_.advance(1);
      const std::string text = "input " + std::to_string(input) + " by " + std::to_string(getpid());
      sink(text.data(), text.size());
    };
    options_.inputs.use = [this](std::size_t, const SharedArray<std::byte>& memory) {
      text_ = {reinterpret_cast<const char*>(memory.data()), memory.size()};
    };
  }

  /// The payloads of all work items.
  std::vector<std::string> run(std::size_t count, const WorkItem& item) {
    std::vector<std::string> payloads(count, "missing");
    EXPECT_TRUE(run_in_workers(
        count, options_, item,
        [&](std::size_t i, WorkResult&& result) {
          payloads[i] = result.payload + result.detail;
          most_open_ = std::max(most_open_, open_files().size());
        },
        nullptr));
    return payloads;
  }

  /// The input that a work item received, without the process.
  std::string received() {
    const std::string text = text_ ? text_->substr(0, text_->find(" by")) : "none";
    text_.reset();
    return text;
  }

  PoolOptions options_;
  ManualTime made_;  ///< seconds count the inputs that were made
  std::size_t most_open_ = 0;
  std::optional<std::string> text_;  ///< in a worker, of the current item
};

TEST_F(Inputs, AreMadeOnceForAllWorkItemsThatUseThem) {
  for (const int workers : {1, 2, 5, 40}) {
    options_.schedule.workers = workers;
    const double before = made_.clock()();
    const auto payloads = run(60, [&](std::size_t, SharedTaskLog&) { return received(); });
    for (std::size_t i = 0; i < payloads.size(); ++i)
      EXPECT_EQ(payloads[i], "input " + std::to_string(i / kItemsPerInput)) << workers;
    EXPECT_EQ(made_.clock()() - before, 20) << workers;
  }
}

TEST_F(Inputs, AreNotMadeByProcessesThatExecuteWorkItems) {
  options_.schedule.workers = 2;
  std::set<std::string> makers, others;
  for (const std::string& payload : run(60, [&](std::size_t, SharedTaskLog&) {
         return *text_ + "/" + std::to_string(getpid());
       })) {
    const std::size_t maker = payload.find("by ") + 3, slash = payload.find('/');
    makers.insert(payload.substr(maker, slash - maker));
    others.insert(payload.substr(slash + 1));
  }
  for (const std::string& maker : makers) {
    EXPECT_EQ(others.count(maker), 0U);
    EXPECT_NE(maker, std::to_string(getpid()));
  }
}

TEST_F(Inputs, LeaveAProcessWithNoDescriptorButItsSocketAndPipes) {
  for (const std::string& payload : run(6, [&](std::size_t, SharedTaskLog&) {
         return received() == "none" ? "no input" : std::to_string(open_files().size());
       }))
    EXPECT_EQ(payload, "6");
}

TEST_F(Inputs, AreThereForItemsOfReplacedProcesses) {
  ManualTime killed;
  const auto payloads = run(9, [&](std::size_t i, SharedTaskLog& log) {
    if (i == 1) log.retire_worker();
    if (i == 4 && killed.clock()() == 0) {
      killed.advance(1);
      std::raise(SIGKILL);
    }
    if (i == 6) std::_Exit(3);
    return received();
  });
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U})
    EXPECT_EQ(payloads[i], "input " + std::to_string(i / kItemsPerInput)) << i;
  EXPECT_EQ(payloads[6], "process exited with status 3");
}

TEST_F(Inputs, ThatCannotBeMadeAreNone) {
  options_.schedule.workers = 2;
  options_.inputs.make = [](std::size_t input, const ArrayWriter::Sink& sink) {
    sink("text", 4);
    if (input == 1) throw std::runtime_error("too large");
    if (input == 2) std::_Exit(1);
    if (input == 3) std::raise(SIGKILL);
  };
  const auto payloads = run(15, [&](std::size_t, SharedTaskLog&) { return received(); });
  for (std::size_t i = 0; i < payloads.size(); ++i)
    EXPECT_EQ(payloads[i], i < 3 || i >= 12 ? "text" : "none") << i;
}

TEST_F(Inputs, AreOnlyMadeForWorkItemsThatUseOne) {
  options_.inputs.of = [](std::size_t i) {
    return i % 10 < 5 ? std::nullopt : std::optional<std::size_t>(i / 10);
  };
  options_.schedule.workers = 3;
  const auto payloads = run(35, [&](std::size_t, SharedTaskLog&) { return received(); });
  for (std::size_t i = 0; i < payloads.size(); ++i)
    EXPECT_EQ(payloads[i], i % 10 < 5 ? "none" : "input " + std::to_string(i / 10)) << i;
  EXPECT_EQ(made_.clock()(), 3);
}

TEST_F(Inputs, OfAnySizeFollowEachOther) {
  options_.inputs.make = [](std::size_t input, const ArrayWriter::Sink& sink) {
    const std::string text(1 + input * 7919 % 200000, static_cast<char>('a' + input % 26));
    sink(text.data(), text.size() / 2);
    sink(text.data() + text.size() / 2, text.size() - text.size() / 2);
  };
  for (const int workers : {1, 3}) {
    options_.schedule.workers = workers;
    options_.schedule.groups = 3;
    options_.schedule.group = [](std::size_t i) { return i % 3; };
    const auto payloads = run(100 * kItemsPerInput, [&](std::size_t, SharedTaskLog&) {
      return text_ ? *std::exchange(text_, std::nullopt) : "none";
    });
    for (std::size_t i = 0; i < payloads.size(); ++i) {
      const std::size_t input = i / kItemsPerInput;
      EXPECT_EQ(payloads[i],
                std::string(1 + input * 7919 % 200000, static_cast<char>('a' + input % 26)))
          << i;
    }
  }
}

TEST_F(Inputs, OfAnInterruptedPoolAreReleased) {
  const std::size_t before = open_files().size();
  std::size_t finished = 0;
  EXPECT_FALSE(run_in_workers(
      300, options_, [&](std::size_t, SharedTaskLog&) { return received(); },
      [&](std::size_t, WorkResult&&) { ++finished; }, [&] { return finished >= 10; }));
  EXPECT_EQ(open_files().size(), before);
}

TEST_F(Inputs, AreReleasedWhenTheirWorkItemsAreFinished) {
  options_.schedule.workers = 2;
  const std::size_t before = open_files().size();
  const auto payloads =
      run(2000 * kItemsPerInput, [&](std::size_t, SharedTaskLog&) { return received(); });
  EXPECT_EQ(payloads.back(), "input 1999");
  EXPECT_EQ(made_.clock()(), 2000);
  EXPECT_EQ(open_files().size(), before);
  // A socket of the keeper; two of each of 2 makers and at most 3 workers, which have two pipes,
  // too. Two inputs are made ahead of those of the 2 busy workers and of the items that these have
  // next.
  EXPECT_LE(most_open_ - before, 1 + 2 * 2 + 3 * (2 + 2) + 2 + 2 + 2U);
}

}  // namespace
}  // namespace slalom
