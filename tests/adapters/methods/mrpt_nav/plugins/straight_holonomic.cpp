// SPDX-License-Identifier: BSD-3-Clause
// An MRPT plug-in module with one holonomic method: straight to the goal at full speed.
#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/rtti/CObject.h>

#include <cmath>

namespace mine {

class CStraight : public mrpt::nav::CAbstractHolonomicReactiveMethod {
  DEFINE_SERIALIZABLE(CStraight, mine)
 public:
  CStraight() : CAbstractHolonomicReactiveMethod("CStraight") {}
  void initialize(const mrpt::config::CConfigFileBase&) override {}
  void saveConfigFile(mrpt::config::CConfigFileBase&) const override {}
  double getTargetApproachSlowDownDistance() const override { return 0; }
  void setTargetApproachSlowDownDistance(const double) override {}
  void navigate(const NavInput& in, NavOutput& out) override {
    const auto& goal = in.targets.back();
    out.desiredDirection = std::atan2(goal.y, goal.x);
    out.desiredSpeed = in.maxRobotSpeed;
  }
};

IMPLEMENTS_SERIALIZABLE(CStraight, mrpt::nav::CAbstractHolonomicReactiveMethod, mine)
uint8_t CStraight::serializeGetVersion() const {
  return 0;
}
void CStraight::serializeTo(mrpt::serialization::CArchive&) const {}
void CStraight::serializeFrom(mrpt::serialization::CArchive&, uint8_t) {}

}  // namespace mine

[[maybe_unused]] static const bool registered = [] {
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CStraight, mine));
  return true;
}();
