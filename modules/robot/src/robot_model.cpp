#include <slalom/robot/robot_model.h>

#include <mrpt/core/bits_math.h>

namespace slalom {

void RobotModel::visit(OptionVisitor& v) {
  v.option("kinematics", kinematics, "how the robot moves", {"diff_drive"});
  v.option("radius", radius, "m", "radius of the disc footprint", Range::positive());
  v.option("max_v", max_v, "m/s", "largest forward speed", Range::positive());
  v.option("max_w", max_w, "rad/s", "largest turning speed", Range::positive());
  v.option("max_accel_v", max_accel_v, "m/s^2", "largest linear acceleration", Range::positive());
  v.option("max_accel_w", max_accel_w, "rad/s^2", "largest angular acceleration",
           Range::positive());
  v.option("forward_only", forward_only, "the robot never drives backwards");
}

void SensorModel::visit(OptionVisitor& v) {
  v.option("aperture_deg", aperture_deg, "deg", "angle between the first and the last ray",
           Range::between(1, 360));
  v.option("rays", rays, "-", "rays of one scan", Range::between(2, 100000));
  v.option("max_range", max_range, "m", "largest range that is measured", Range::positive());
}

double SensorModel::aperture() const {
  return mrpt::DEG2RAD(aperture_deg);
}

}  // namespace slalom
