// SPDX-License-Identifier: BSD-3-Clause
#include "isolated_trials.h"

#include <slalom/campaign/method_pool.h>
#include <slalom/core/byte_stream.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/results/method_failures.h>

namespace slalom {
namespace {

constexpr std::size_t kLogSize = 4U << 20U;  // bytes
constexpr std::size_t kMaxLogged = kLogSize / 2;
constexpr char kLogName[] = "log of trials";

std::string key_of(const Scenario& scenario, std::size_t method) {
  return scenario.hash() + "/" + std::to_string(method);
}

/// Trials as they were begun and ended: a key, and then the trial itself.
void append(SharedTaskLog& log, const std::string& text, std::size_t& logged) {
  const std::string bytes = ByteWriter().text(text).take();
  log.append(bytes.data(), bytes.size());
  logged += bytes.size();
}

struct LogIsFull {};

class JournaledTrials : public TrialSource {
 public:
  JournaledTrials(const FalsificationSetup& setup, std::map<std::string, Trial> known,
                  SharedTaskLog& log, SharedTaskLog& begun)
      : methods_(setup), known_(std::move(known)), log_(log), begun_(begun) {}

  const Trial& trial(const World& world, std::size_t method) override {
    const std::string key = key_of(world.scenario(), method);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    if (logged_ > kMaxLogged) throw LogIsFull();
    log_.heartbeat();
    begun_.heartbeat();
    append(log_, key, logged_);
    const Trial& result = known_[key] = methods_.run(world, method);
    append(log_, to_bytes(result), logged_);
    return result;
  }

 private:
  MethodPool methods_;
  std::map<std::string, Trial> known_;
  SharedTaskLog &log_, &begun_;
  std::size_t logged_ = 0;
};

class CachedTrials : public TrialSource {
 public:
  explicit CachedTrials(const std::map<std::string, Trial>& known) : known_(known) {}
  const Trial& trial(const World& world, std::size_t method) override {
    return known_.at(key_of(world.scenario(), method));
  }

 private:
  const std::map<std::string, Trial>& known_;
};

}  // namespace

PoolOptions pool_of_trials(const FalsificationSetup& setup) {
  PoolOptions pool = method_pool(setup.limits, setup.run.clock);
  pool.limits.heartbeat_timeout = setup.limits.run_wall_time;
  pool.log_size = kLogSize;
  return pool;
}

Method& MethodPool::method(std::size_t index) {
  std::unique_ptr<Method>& method = methods_[index];
  if (!method) method = setup_.method_at(index).make(setup_.run.robot, setup_.run.sensor);
  return *method;
}

Trial MethodPool::run(const World& world, std::size_t index) {
  // All tables before a method can change the floating-point environment.
  world.distance_field();
  world.ray_caster();
  Trial trial;
  try {
    if (index == setup_.unnoticed_index()) {
      FalsificationSetup unnoticed = setup_;
      unnoticed.run.people.notices = 0;
      trial = run_trial(world, unnoticed, method(index));
    } else {
      trial = run_trial(world, setup_, method(index));
    }
  } catch (const Error& error) {
    trial.outcome = Outcome::MethodError;
    trial.detail = error.what();
  }
  if (is_method_failure(to_string(trial.outcome))) methods_.erase(index);
  return trial;
}

bool IsolatedTrials::execute(const TrialJob& job) {
  for (bool complete = false; !complete;)
    if (!extend(job, complete)) return false;
  CachedTrials known(known_);
  job(known);
  return true;
}

/// Executes the job in a worker as far as it gets.
bool IsolatedTrials::extend(const TrialJob& job, bool& complete) {
  const WorkItem item = [&](std::size_t, SharedTaskLog& log) -> std::string {
    JournaledTrials trials(setup_, known_, log, begun_);
    try {
      job(trials);
    } catch (const LogIsFull&) {
      return "again" + log.contents();
    }
    return "done." + log.contents();
  };
  return run_in_workers(
      1, pool_of_trials(setup_), item,
      [&](std::size_t, WorkResult&& result) {
        const bool done = result.status == WorkResult::Status::Done;
        complete = done && starts_with(result.payload, "done.");
        read_log(done ? result.payload.substr(5) : result.log, result);
      },
      interrupted_);
}

void IsolatedTrials::read_log(const std::string& log, const WorkResult& result) {
  ByteReader reader(log, kLogName);
  std::string begun;
  for (std::size_t position = 0; position < log.size();) {
    const std::string text = reader.text();
    position += sizeof(std::uint64_t) + text.size();
    if (begun.empty()) {
      begun = text;
    } else {
      known_[begun] = trial_from_bytes(text, kLogName);
      begun.clear();
    }
  }
  if (result.status == WorkResult::Status::Done) return;
  Trial trial = trial_of_dead_process(result);
  if (begun.empty()) throw job_error("a run of the method", result.detail);
  known_[begun] = std::move(trial);
}

Trial trial_of_dead_process(const WorkResult& result) {
  using Status = WorkResult::Status;
  if (result.status == Status::Threw) throw Error(ErrorKind::Job, result.detail);
  if (result.status == Status::Killed) throw job_error("a run of the method", result.detail);
  Trial trial;
  trial.outcome =
      result.status == Status::TimedOut ? Outcome::MethodDeadline : Outcome::MethodCrash;
  trial.detail = result.detail;
  if (result.status == Status::TimedOut)
    trial.detail += " (run_wall_time), a wall-clock limit on this machine";
  return trial;
}

Trial run_alone(const FalsificationSetup& setup, const Scenario& scenario, std::size_t method) {
  const World world(scenario, setup.run.simulation.resolution);
  Trial trial;
  IsolatedTrials(setup, nullptr).execute([&](TrialSource& source) {
    trial = source.trial(world, method);
  });
  return trial;
}

}  // namespace slalom
