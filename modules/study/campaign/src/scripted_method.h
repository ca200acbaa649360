// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>

#include <utility>
#include <vector>

namespace slalom {

/// Replays given commands, then throws MethodError with the message `end`.
class ScriptedMethod : public Method {
 public:
  ScriptedMethod(std::vector<Command> commands, std::string end)
      : commands_(std::move(commands)), end_(std::move(end)) {}

  void reset(const NavigationTask&) override { next_ = 0; }
  Command step(const Observation&) override {
    if (next_ == commands_.size()) throw MethodError(end_);
    return commands_[next_++];
  }

 private:
  std::vector<Command> commands_;
  std::string end_;
  std::size_t next_ = 0;
};

}  // namespace slalom
