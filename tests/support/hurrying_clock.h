// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/wall_clock.h>
#include <slalom/methods/method.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// The system's clock, advanced further at each reading while it hurries. A method misses its
/// deadline after a few readings, but never because the machine is slow.
class HurryingClock {
 public:
  explicit HurryingClock(double seconds_per_reading = 5) : seconds_(seconds_per_reading) {}
  double operator()() const {
    if (state_->hurries) state_->skipped += seconds_;
    return steady_seconds() + state_->skipped;
  }
  void hurry(bool on) const { state_->hurries = on; }

 private:
  struct State {
    bool hurries = false;
    double skipped = 0;  // s
  };
  double seconds_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

/// Calls functions before each step of a method and at the end of its runs.
class HookedMethod : public Method {
 public:
  HookedMethod(Method& method, std::function<void(const Observation&)> before_step,
               std::function<void()> on_finish)
      : method_(method), before_step_(std::move(before_step)), on_finish_(std::move(on_finish)) {}
  void reset(const NavigationTask& task) override { method_.reset(task); }
  void settle(const Observation& start) override { method_.settle(start); }
  Command step(const Observation& observation) override {
    before_step_(observation);
    return method_.step(observation);
  }
  void finish(const std::string& outcome) override {
    on_finish_();
    method_.finish(outcome);
  }

 private:
  Method& method_;
  std::function<void(const Observation&)> before_step_;
  std::function<void()> on_finish_;
};

/// Lets the clock hurry from this time of a run on, until the end of the run.
inline HookedMethod hurry_from(Method& method, const HurryingClock& clock, double time) {
  return {method,
          [=](const Observation& observation) { clock.hurry(observation.time > time - 1e-9); },
          [=] { clock.hurry(false); }};
}

}  // namespace slalom
