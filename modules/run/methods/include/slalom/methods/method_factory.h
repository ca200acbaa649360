// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// Creates a method for a robot and its sensor; called once in each worker process. Throws Error
/// (Usage) for an invalid option, or a missing class, library or symbol.
using MethodFactory =
    std::function<std::unique_ptr<Method>(const RobotModel& robot, const SensorModel& sensor)>;

/// The steps of `inner`, whose parameters the method of `outer`, which adapts(), sets before each
/// of them. Each run begins with those that `inner` was made with. Needs the tracks and the map
/// that either of them needs. Throws Error (Usage) with the location `where` if `outer` does not
/// adapt.
MethodFactory adaptive_method(MethodFactory outer, MethodFactory inner, const std::string& where);

/// A method of a campaign.
struct NamedMethod {
  std::string name;
  MethodFactory make;
  std::string where;  ///< its origin for messages, e.g. "campaign.ini:7: [method.nd]"
};

}  // namespace slalom
