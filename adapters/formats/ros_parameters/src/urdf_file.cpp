// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_file.h"

#include <slalom/core/math.h>
#include <slalom/core/placement.h>
#include <slalom/core/text.h>
#include <slalom/robot/footprint.h>
#include <slalom/xml/xml_file.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace slalom::ros {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using tinyxml2::XMLElement;

constexpr std::size_t kMaxLinks = 10'000, kMaxLasers = 100;
constexpr double kLargest = 1000;  // m, rad, rad/s
constexpr int kCorners = 32;       // of a polygon around a circle, 0.5 % larger

/// A shape of a link, in its frame.
struct Shape {
  std::vector<TPoint3D> points;  ///< whose convex hull contains it; none of a sphere
  TPoint3D center;
  std::optional<double> radius;  ///< m, of a sphere or a cylinder that stands in the link
};

struct Link {
  const XMLElement* element = nullptr;
  std::vector<Shape> shapes;
};

struct Joint {
  const XMLElement* element = nullptr;
  std::string parent, child, type;
  Placement origin;
};

class UrdfReader {
 public:
  explicit UrdfReader(const std::string& path) : path_(path), xml_(XmlFile::read(path, kKind)) {}

  UrdfRobot read() {
    const XMLElement& robot = xml_.root();
    if (std::string(robot.Name()) != "robot")
      throw xml_.error(robot, "<" + std::string(robot.Name()) + "> is not a robot", kKind);
    expect_no_xacro(robot);
    robot_.name = xml_attribute(robot, "name");
    for (const XMLElement* link : xml_children(robot, "link")) read_link(*link);
    for (const XMLElement* joint : xml_children(robot, "joint")) read_joint(*joint);
    place_links();
    read_footprint();
    read_wheels();
    read_lasers(robot);
    return robot_;
  }

 private:
  static constexpr const char* kKind = "a robot in URDF";

  void expect_no_xacro(const XMLElement& robot) const {
    for (const XMLElement* child = robot.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement())
      if (starts_with(child->Name(), "xacro:"))
        throw xml_.error(*child, "is xacro", "its result: xacro FILE > robot.urdf");
  }

  std::vector<double> numbers(const XMLElement& element, const char* attribute,
                              std::size_t count) const {
    const std::string text = xml_attribute(element, attribute);
    if (text.empty())
      throw xml_.error(element, "<" + std::string(element.Name()) + "> has no " + attribute,
                       count_text(count, "number"));
    const std::vector<double> all = xml_.numbers(element, text, count);
    for (const double number : all)
      if (std::abs(number) > kLargest)
        throw xml_.error(element, std::string(attribute) + " has " + format_number(number),
                         "at most " + format_number(kLargest));
    return all;
  }

  double size(const XMLElement& element, const char* attribute) const {
    const double number = numbers(element, attribute, 1)[0];
    if (!(number > 0))
      throw xml_.error(element, std::string(attribute) + " = " + format_number(number),
                       "more than 0 m");
    return number;
  }

  /// The pose of <origin xyz rpy>: rotations about the fixed axes x, y, z in turn.
  Placement origin_of(const XMLElement& element) const {
    const XMLElement* origin = element.FirstChildElement("origin");
    const auto three = [&](const char* attribute) {
      return origin == nullptr || origin->Attribute(attribute) == nullptr
                 ? std::vector<double>{0, 0, 0}
                 : numbers(*origin, attribute, 3);
    };
    const auto xyz = three("xyz"), rpy = three("rpy");
    return {xyz[0], xyz[1], xyz[2], rpy[2], rpy[1], rpy[0]};
  }

  void read_link(const XMLElement& element) {
    const std::string name = xml_attribute(element, "name");
    Link link{&element, {}};
    for (const XMLElement* collision : xml_children(element, "collision")) {
      const XMLElement* geometry = collision->FirstChildElement("geometry");
      const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
      if (shape == nullptr)
        throw xml_.error(*collision, "has no geometry", "a box, a cylinder, a sphere or a mesh");
      const std::string kind = shape->Name();
      if (kind == "mesh") {
        robot_.meshes.push_back(path_ + ":" + std::to_string(shape->GetLineNum()) + ": " + name);
        continue;
      }
      link.shapes.push_back(shape_of(*shape, kind, origin_of(*collision)));
    }
    if (name.empty() || !links_.emplace(name, link).second)
      throw xml_.error(element, "'" + name + "' cannot name another link", "a name of its own");
    if (links_.size() > kMaxLinks)
      throw xml_.error(element, "has too many links", "at most " + std::to_string(kMaxLinks));
  }

  Shape shape_of(const XMLElement& element, const std::string& kind, const Placement& pose) const {
    Shape shape;
    shape.center = {pose.x(), pose.y(), pose.z()};
    if (kind == "box") {
      const auto size = numbers(element, "size", 3);
      if (!std::all_of(size.begin(), size.end(), [](double side) { return side > 0; }))
        throw xml_.error(element, "a side is not above 0", "three lengths > 0");
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          for (const double z : {-0.5, 0.5})
            shape.points.push_back(pose.point({x * size[0], y * size[1], z * size[2]}));
      return shape;
    }
    if (kind != "sphere" && kind != "cylinder")
      throw xml_.error(element, "<" + kind + "> is not a known shape",
                       "box, cylinder, sphere or mesh");
    const double radius = size(element, "radius");
    if (kind == "cylinder") {
      const double length = size(element, "length");
      for (const double side : {-0.5, 0.5})
        for (const TPoint2D& p : polygon_around(radius))
          shape.points.push_back(pose.point({p.x, p.y, side * length}));
    }
    if (kind == "sphere" || is_upright(pose)) shape.radius = radius;
    return shape;
  }

  /// A polygon around a circle.
  static std::vector<TPoint2D> polygon_around(double radius) {
    std::vector<TPoint2D> corners;
    for (int i = 0; i < kCorners; ++i) {
      const auto [s, c] = math::sin_cos(2 * M_PI * i / kCorners);
      const double distance = radius / math::cos(M_PI / kCorners);
      corners.emplace_back(distance * c, distance * s);
    }
    return corners;
  }
  static bool is_upright(const Placement& pose) {
    return std::abs(pose.cosine_of_tilt()) > 1 - 1e-9;
  }

  void read_joint(const XMLElement& element) {
    const auto link = [&](const char* name) {
      const XMLElement* end = element.FirstChildElement(name);
      const std::string found = end == nullptr ? "" : xml_attribute(*end, "link");
      if (links_.count(found) == 0)
        throw xml_.error(element, "its " + std::string(name) + " '" + found + "' is not a link",
                         "the name of a link");
      return found;
    };
    const Joint joint{&element, link("parent"), link("child"), xml_attribute(element, "type"),
                      origin_of(element)};
    if (!children_.insert(joint.child).second)
      throw xml_.error(element, "link '" + joint.child + "' has another joint", "one parent");
    joints_.push_back(joint);
  }

  /// The frame of each link in that of the root, then in that of the robot.
  void place_links() {
    std::map<std::string, std::vector<const Joint*>> below;
    for (const Joint& joint : joints_) below[joint.parent].push_back(&joint);
    std::vector<std::string> open;
    for (const auto& [name, link] : links_)
      if (children_.count(name) == 0) open.push_back(name);
    if (open.size() != 1)
      throw xml_.error(xml_.root(), "has " + count_text(open.size(), "root link"), "one");
    frames_[open[0]] = Placement();
    while (!open.empty()) {
      const std::string name = open.back();
      open.pop_back();
      for (const Joint* joint : below[name]) {
        frames_[joint->child] = frames_.at(name) + joint->origin;
        open.push_back(joint->child);
      }
    }
    if (frames_.size() != links_.size())
      throw xml_.error(xml_.root(), "has joints in a circle", "a tree of links");
    const auto base = frames_.find("base_link");
    if (base == frames_.end()) return;
    const Placement to_robot = base->second.inverse();
    for (auto& [name, frame] : frames_) frame = to_robot + frame;
  }

  /// To 0.1 mm, so that angles such as 1.5708 give straight sides.
  static double rounded(double length) { return std::round(length * 1e4) / 1e4 + 0.0; }

  void read_footprint() {
    constexpr double kSame = 1e-3;  // m
    std::vector<TPoint2D> points;
    double disc = 0, farthest = 0;
    for (const auto& [name, link] : links_) {
      for (const Shape& shape : link.shapes) {
        const Placement& frame = frames_.at(name);
        const TPoint3D center = frame.point(shape.center);
        const bool is_sphere = shape.points.empty();
        std::vector<TPoint2D> seen;  // from above
        for (const TPoint3D& point : shape.points) {
          const TPoint3D p = frame.point(point);
          seen.emplace_back(p.x, p.y);
        }
        if (is_sphere)
          for (const TPoint2D& p : polygon_around(*shape.radius))
            seen.emplace_back(center.x + p.x, center.y + p.y);
        const bool is_central = shape.radius && (is_sphere || is_upright(frame)) &&
                                math::hypot(center.x, center.y) < kSame;
        if (is_central) disc = std::max(disc, *shape.radius);
        for (const TPoint2D& p : seen) {
          points.emplace_back(rounded(p.x), rounded(p.y));
          if (!is_central) farthest = std::max(farthest, math::hypot(p.x, p.y));
        }
      }
    }
    if (points.empty()) return;
    if (disc > 0 && farthest <= disc + kSame)
      robot_.radius = disc;
    else
      robot_.footprint = convex_hull(points);
  }

  /// m, of the wheel that a link is: its only shape, round.
  std::optional<double> wheel_radius(const std::string& link) const {
    const std::vector<Shape>& shapes = links_.at(link).shapes;
    const XMLElement* shape = nullptr;
    for (const XMLElement* collision : xml_children(*links_.at(link).element, "collision"))
      shape = collision->FirstChildElement("geometry")->FirstChildElement();
    if (shapes.size() != 1 || shape == nullptr || shape->Attribute("radius") == nullptr)
      return std::nullopt;
    return size(*shape, "radius");
  }

  void read_wheels() {
    struct Wheel {
      double side, speed;  // m, m/s
    };
    std::vector<Wheel> wheels;
    for (const Joint& joint : joints_) {
      const XMLElement* limit = joint.element->FirstChildElement("limit");
      if (joint.type != "continuous" || limit == nullptr || limit->Attribute("velocity") == nullptr)
        continue;
      TPoint3D axis(1, 0, 0);  // the default of URDF
      if (const XMLElement* given = joint.element->FirstChildElement("axis")) {
        const auto xyz = numbers(*given, "xyz", 3);
        axis = {xyz[0], xyz[1], xyz[2]};
      }
      const Placement& frame = frames_.at(joint.child);
      const TPoint3D turned = frame.turned(axis);
      const auto radius = wheel_radius(joint.child);
      const double speed = numbers(*limit, "velocity", 1)[0];
      const bool is_lateral = std::abs(turned.y) > 0.999 * turned.norm();
      if (radius && is_lateral && speed > 0) wheels.push_back({frame.y(), speed * *radius});
    }
    if (wheels.size() != 2 || !(wheels[0].side * wheels[1].side < 0)) return;
    robot_.max_v = std::min(wheels[0].speed, wheels[1].speed);
    robot_.max_w = 2 * *robot_.max_v / std::abs(wheels[0].side - wheels[1].side);
  }

  UrdfLaser laser_at(const std::string& link) const {
    const Placement& frame = frames_.at(link);
    UrdfLaser laser;
    laser.name = link;
    for (char& c : laser.name)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    laser.pose = {frame.x(), frame.y(), frame.yaw()};
    laser.upside_down = frame.cosine_of_tilt() < 0;
    return laser;
  }

  /// Sensors of Gazebo that measure ranges, in their links.
  void read_lasers(const XMLElement& robot) {
    for (const XMLElement* gazebo : xml_children(robot, "gazebo")) {
      const std::string link = xml_attribute(*gazebo, "reference");
      for (const XMLElement* sensor : xml_children(*gazebo, "sensor")) {
        const std::string type = xml_attribute(*sensor, "type");
        if (!contains({"ray", "gpu_ray", "lidar", "gpu_lidar"}, type)) continue;
        if (links_.count(link) == 0)
          throw xml_.error(*gazebo, "its reference '" + link + "' is not a link",
                           "the name of a link");
        if (robot_.lasers.size() == kMaxLasers)
          throw xml_.error(*sensor, "is one laser too many",
                           "at most " + std::to_string(kMaxLasers));
        robot_.lasers.push_back(laser_at(link));
        const XMLElement* ray = sensor->FirstChildElement("ray");
        if (ray == nullptr) ray = sensor->FirstChildElement("lidar");
        if (ray != nullptr) read_rays(*ray, robot_.lasers.back());
      }
    }
  }

  /// <scan><horizontal> and <range>; a scan is symmetric to the direction of a laser.
  void read_rays(const XMLElement& ray, UrdfLaser& laser) const {
    const auto number = [&](const XMLElement* parent, const char* name) -> std::optional<double> {
      const XMLElement* found = parent == nullptr ? nullptr : parent->FirstChildElement(name);
      if (found == nullptr) return std::nullopt;
      return xml_.numbers(*found, 1)[0];
    };
    const XMLElement* scan = ray.FirstChildElement("scan");
    const XMLElement* horizontal =
        scan == nullptr ? nullptr : scan->FirstChildElement("horizontal");
    const auto from = number(horizontal, "min_angle"), to = number(horizontal, "max_angle");
    if (from && to) {
      // Takes 3.1416 for half a turn.
      laser.aperture =
          *to - *from < 2 * M_PI + 1e-3 ? std::min(*to - *from, 2 * M_PI) : *to - *from;
      const double middle = 0.5 * (*from + *to);
      laser.pose.phi =
          mrpt::math::wrapToPi(laser.pose.phi + (laser.upside_down ? -middle : middle));
    }
    laser.rays = number(horizontal, "samples");
    laser.max_range = number(ray.FirstChildElement("range"), "max");
  }

  std::string path_;
  XmlFile xml_;
  UrdfRobot robot_;
  std::map<std::string, Link> links_;
  std::vector<Joint> joints_;
  std::set<std::string> children_;  // of joints
  std::map<std::string, Placement> frames_;
};

}  // namespace

UrdfRobot UrdfRobot::read(const std::string& path) {
  return UrdfReader(path).read();
}

}  // namespace slalom::ros
