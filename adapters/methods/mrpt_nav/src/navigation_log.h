// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>

#include <mrpt/nav/reactive/CAbstractPTGBasedReactive.h>

#include <string>

namespace slalom {

/// Writes one .reactivenavlog per run. The file is complete after every step, because a worker may
/// be killed at any time.
class NavigationLog {
 public:
  /// Writes FOLDER/METHOD_SEED.reactivenavlog, with the method's seed of the run.
  NavigationLog(std::string folder, std::string method);

  /// Creates the folder. Throws std::runtime_error on failure.
  void prepare() const;
  void start_run(const NavigationTask& task, mrpt::nav::CAbstractPTGBasedReactive& navigator);
  /// To be called after each step; writes the record of the step, if any.
  void add(mrpt::nav::CAbstractPTGBasedReactive& navigator);

 private:
  std::string folder_, method_, path_;
  mrpt::system::TTimeStamp last_ = {};
  bool is_first_ = true;
};

}  // namespace slalom
