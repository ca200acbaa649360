#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// Is told how far a long job is. Implementations must be cheap to call.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void start(const std::string& what, std::size_t total) = 0;
  virtual void advance(std::size_t done) = 0;  ///< `done` of `total` so far
  virtual void finish() = 0;
};

/// Says nothing.
std::unique_ptr<Progress> make_silent_progress();

/// A bar on standard error when it is a terminal and `quiet` is false; otherwise one line per
/// stage, or nothing when quiet.
std::unique_ptr<Progress> make_terminal_progress(bool quiet);

}  // namespace slalom
