#pragma once

#include <slalom/methods/method.h>

#include <mrpt/nav/reactive/CAbstractPTGBasedReactive.h>

#include <string>

namespace slalom {

/// Writes one .reactivenavlog per run, whole after every step: a worker may be ended at any time.
class NavigationLog {
 public:
  /// Files FOLDER/METHOD_SEED.reactivenavlog, with the seed that the method is given for the run.
  NavigationLog(std::string folder, std::string method);

  /// Makes the folder. Throws std::runtime_error when it cannot.
  void prepare() const;
  void start_run(const Task& task, mrpt::nav::CAbstractPTGBasedReactive& navigator);
  /// To be called after each step; writes the record that the step left, if it left one.
  void add(mrpt::nav::CAbstractPTGBasedReactive& navigator);

 private:
  std::string folder_, method_, path_;
  mrpt::system::TTimeStamp last_ = {};
  bool is_first_ = true;
};

}  // namespace slalom
