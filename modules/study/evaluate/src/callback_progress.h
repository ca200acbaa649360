// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>
#include <slalom/evaluate.h>

namespace slalom {

/// Passes progress on to Options::progress.
class CallbackProgress : public Progress {
 public:
  explicit CallbackProgress(const Options& options) : options_(options) {}

  void start(const std::string& what, std::size_t total) override {
    phase_ = what;
    total_ = total;
    advance(0);
  }
  void advance(std::size_t done) override {
    if (options_.progress) options_.progress(phase_, done, total_);
  }
  void finish() override {}

 private:
  const Options& options_;
  std::string phase_;
  std::size_t total_ = 0;
};

}  // namespace slalom
