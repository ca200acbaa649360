// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/sectors.h"

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <stdexcept>

namespace reactive {

/// MRPT holonomic method for an algorithm `A` with `Parameters`, whose `visit()` declares the
/// options (with `target_slow_down`, in meters as MRPT's), and `decide(sectors, target)`. Its .ini
/// section has their keys; an invalid value throws slalom::Error.
template <typename A>
class Holonomic : public mrpt::nav::CAbstractHolonomicReactiveMethod {
 public:
  explicit Holonomic(const std::string& section) : CAbstractHolonomicReactiveMethod(section) {}

  void initialize(const mrpt::config::CConfigFileBase& c) override {
    const std::string section = getConfigFileSectionName();
    typename A::Parameters parameters;
    slalom::for_each_option(parameters, [&](const slalom::Option& option) {
      const std::string text = c.read_string(section, option.key, "");
      if (!text.empty()) option.set(text, option.key);
    });
    algorithm_ = A(parameters);
  }

  void saveConfigFile(mrpt::config::CConfigFileBase& c) const override {
    slalom::write_options(algorithm_.parameters,
                          [&](const std::string& key, const std::string& text) {
                            c.write(getConfigFileSectionName(), key, text);
                          });
  }

  double getTargetApproachSlowDownDistance() const override {
    return algorithm_.parameters.target_slow_down;
  }
  void setTargetApproachSlowDownDistance(const double distance) override {
    algorithm_.parameters.target_slow_down = distance;
  }

  void navigate(const NavInput& in, NavOutput& out) override {
    const auto* paths = getAssociatedPTG();
    const double meter = paths == nullptr ? 1 : 1 / paths->getRefDistance();
    const Sectors sectors{in.obstacles, in.maxObstacleDist, meter};
    if (sectors.free_distances.empty() || in.targets.empty())
      throw std::invalid_argument("no obstacle distances or no target");
    const auto& target = in.targets.back();
    const Decision decision = algorithm_.decide(sectors, {target.x, target.y});
    out.desiredDirection = wrapped(decision.direction);
    out.desiredSpeed = std::clamp(decision.speed, 0.0, 1.0) * in.maxRobotSpeed;
  }

 protected:
  A algorithm_;
};

}  // namespace reactive

// NOLINTBEGIN(bugprone-macro-parentheses): names of classes cannot stand in parentheses
/// Defines the class slalom::NAME, which MRPT creates by name, with its default .ini section. It is
/// registered by a variable after its class id: MRPT_INITIALIZER() may run before the id is
/// initialized.
#define SLALOM_HOLONOMIC_METHOD(NAME, ALGORITHM, SECTION)                                     \
  namespace slalom {                                                                          \
  class NAME : public reactive::Holonomic<ALGORITHM> {                                        \
    DEFINE_SERIALIZABLE(NAME, slalom)                                                         \
   public:                                                                                    \
    NAME() : Holonomic(SECTION) {}                                                            \
  };                                                                                          \
  IMPLEMENTS_SERIALIZABLE(NAME, mrpt::nav::CAbstractHolonomicReactiveMethod, slalom)          \
  uint8_t NAME::serializeGetVersion() const {                                                 \
    return 0;                                                                                 \
  }                                                                                           \
  void NAME::serializeTo(mrpt::serialization::CArchive& out) const {                          \
    slalom::write_options(algorithm_.parameters,                                              \
                          [&](const std::string&, const std::string& text) { out << text; }); \
  }                                                                                           \
  void NAME::serializeFrom(mrpt::serialization::CArchive& in, uint8_t) {                      \
    slalom::for_each_option(algorithm_.parameters, [&](const slalom::Option& option) {        \
      std::string text;                                                                       \
      in >> text;                                                                             \
      option.set(text, option.key);                                                           \
    });                                                                                       \
  }                                                                                           \
  }                                                                                           \
  [[maybe_unused]] static const bool registered_##NAME = [] {                                 \
    mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(NAME, slalom));                              \
    return true;                                                                              \
  }();                                                                                        \
  static_assert(true)
// NOLINTEND(bugprone-macro-parentheses)
