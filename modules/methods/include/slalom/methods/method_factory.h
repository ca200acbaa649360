#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/methods/method.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// Creates a method for a robot and its sensor; called once in each worker process. Throws Error
/// (Usage) for an invalid option, or a missing class, library or symbol.
using MethodFactory =
    std::function<std::unique_ptr<Method>(const RobotModel& robot, const SensorModel& sensor)>;

/// A method of a campaign.
struct NamedMethod {
  std::string name;
  MethodFactory make;
  std::string where;  ///< its origin for messages, e.g. "campaign.ini:7: [method.nd]"
};

/// The origin of a method's option for messages, by its key; by "" that of all options.
using OptionLocation = std::function<std::string(const std::string& key)>;

/// "FILE:LINE: [SECTION] KEY", for options read from an .ini.
OptionLocation location_in(const IniFile& ini, const std::string& section);

/// "MAKER.KEY", for options from C++; `maker` is the function that has them as parameter.
OptionLocation location_of(const std::string& maker);

}  // namespace slalom
