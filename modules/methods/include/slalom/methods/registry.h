#pragma once

#include <slalom/methods/method.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Builds a method. Reads its options from context.ini, section context.section, the key `adapter`
/// included; throws Error (Usage) for a wrong or unknown key, a class, library or symbol that is
/// not there.
using MethodFactory = std::function<std::unique_ptr<Method>(const MethodContext& context)>;

/// The adapters by which methods come in, by name ("mrpt_holonomic", "library", ...). Programs fill
/// it.
class MethodRegistry {
 public:
  void add(const std::string& adapter, MethodFactory factory);
  std::vector<std::string> adapters() const;

  /// Builds the method of section "method.NAME". Throws Error (Usage) for a missing section, a
  /// missing or unknown adapter (naming those that exist), and whatever the factory throws.
  std::unique_ptr<Method> create(const std::string& name, const MethodContext& context) const;

 private:
  std::map<std::string, MethodFactory> factories_;
};

/// Whether both speeds are finite and within the robot's limits (with a tolerance of 1e-9);
/// otherwise `why` says which is not.
bool is_valid_command(const Command& command, const RobotModel& robot, std::string& why);

}  // namespace slalom
