// SPDX-License-Identifier: BSD-3-Clause
#include "ir_sim_world.h"
#include "world_parts.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kLineWidth = 0.02;  // m, of line strings
constexpr double kHeight = 1;        // m, of all shapes
constexpr int kMaxCopies = 10'000;

class IrSimReader {
 public:
  IrSimReader(const YAML::Node& root, const std::string& where, const WorldOptions& options)
      : root_(root), where_(where), parts_(where, options) {}

  ImportedWorld read(const std::string& name) {
    read_world(root_["world"]);
    for (const YAML::Node& robot : items(root_["robot"])) read_robot(robot);
    for (const YAML::Node& group : items(root_["obstacle"])) read_group(group);
    parts_.set_task(start_, goal_);
    return parts_.finish(name);
  }

 private:
  Error error(const YAML::Node& node, const std::string& what, const std::string& expected) const {
    const int line = node.Mark().line;
    return file_error(line < 0 ? where_ : where_ + ":" + std::to_string(line + 1), what, expected);
  }

  static std::vector<YAML::Node> items(const YAML::Node& node) {
    std::vector<YAML::Node> all;
    if (node && node.IsMap()) all.push_back(node);
    if (node && node.IsSequence())
      for (const YAML::Node& item : node)
        if (item.IsMap()) all.push_back(item);
    return all;
  }

  double number(const YAML::Node& node, const std::string& what) const {
    double value = 0;
    if (!node.IsScalar() || !parse_number(node.Scalar(), value))
      throw error(node, "the " + what + " is not a number", "a finite number");
    return value;
  }

  double number_in(const YAML::Node& map, const char* key, double otherwise) const {
    const YAML::Node node = map[key];
    return node && !node.IsNull() ? number(node, key) : otherwise;
  }

  double length_in(const YAML::Node& map, const char* key, double otherwise) const {
    const double value = number_in(map, key, otherwise);
    if (!(value > 0)) throw error(map, std::string("the ") + key + " is not above 0", "a length");
    return value;
  }

  /// The first numbers of a list; missing ones are 0.
  std::vector<double> list(const YAML::Node& node, std::size_t required, std::size_t count,
                           const std::string& what) const {
    if (!node.IsSequence() || node.size() < required)
      throw error(node, "the " + what + " is not a list of at least " + std::to_string(required),
                  "numbers in m and rad");
    std::vector<double> values(count, 0);
    for (std::size_t i = 0; i < std::min(count, node.size()); ++i)
      values[i] = number(node[i], what);
    return values;
  }

  void read_world(const YAML::Node& world) {
    if (!world || !world.IsMap()) throw error(root_, "has no map 'world'", "a world of ir-sim");
    const double width = length_in(world, "width", 10), height = length_in(world, "height", 10);
    std::vector<double> corner{0, 0};
    if (const YAML::Node offset = world["offset"]; offset && !offset.IsNull())
      corner = list(offset, 2, 2, "offset");
    parts_.set_bounds({corner[0], corner[1], corner[0] + width, corner[1] + height});
    if (const YAML::Node map = world["obstacle_map"]; map && !map.IsNull())
      parts_.leave_out("obstacle maps", map.IsScalar() ? map.Scalar() : "");
  }

  static std::string name_in(const YAML::Node& map, const char* key) {
    const YAML::Node node = map[key];
    if (!node) return "";
    if (node.IsScalar()) return node.Scalar();
    return node.IsMap() && node["name"] && node["name"].IsScalar() ? node["name"].Scalar() : "";
  }

  /// Whether a list is a list of lists, one for each copy.
  static bool is_nested(const YAML::Node& node) {
    return node && node.IsSequence() && node.size() > 0 && node[0].IsSequence();
  }

  static bool is_true(const YAML::Node& node) {
    return node && node.IsScalar() && lower_case(node.Scalar()) == "true";
  }

  void read_robot(const YAML::Node& robot) {
    const YAML::Node state = robot["state"], goal = robot["goal"];
    const bool has_pair = state && goal && state.IsSequence() && goal.IsSequence();
    if (start_ || !has_pair) return parts_.leave_out("robots", name_in(robot, "kinematics"));
    const auto s = list(is_nested(state) ? state[0] : state, 2, 3, "state of the robot");
    const auto g = list(is_nested(goal) ? goal[0] : goal, 2, 2, "goal of the robot");
    start_ = {s[0], s[1], s[2]};
    goal_ = {g[0], g[1]};
    if (is_nested(state) && state.size() > 1)
      parts_.leave_out("robots", name_in(robot, "kinematics"));
  }

  /// Obstacles of one entry; each has the state and the shape of its number, the last ones those of
  /// the last in the lists.
  void read_group(const YAML::Node& group) {
    const double copies = number_in(group, "number", 1);
    if (!(copies >= 0 && copies <= kMaxCopies))
      throw error(group, "the number is " + format_number(copies), "0 to 10000");
    const std::string distribution = name_in(group, "distribution"),
                      moves = name_in(group, "behavior");
    const std::vector<YAML::Node> shapes = items(group["shape"]);
    const std::string shape = shapes.empty() ? "circle" : name_in(shapes[0], "name");
    if (!distribution.empty() && distribution != "manual")
      return parts_.leave_out("obstacles at drawn places", shape);
    const bool has_behaviors = group["behavior"] && group["behavior"].IsSequence();
    const bool moves_itself =
        !name_in(group, "kinematics").empty() && (!moves.empty() || has_behaviors);
    if (moves_itself) return parts_.leave_out("obstacles with a behavior", shape);
    // Neither its robots nor its lasers meet them.
    if (is_true(group["unobstructed"])) return parts_.leave_out("unobstructed objects", shape);
    const YAML::Node state = group["state"];
    for (std::size_t i = 0; i < static_cast<std::size_t>(copies); ++i) {
      std::vector<double> pose(3, 0);
      if (is_nested(state))
        pose = list(state[std::min(i, state.size() - 1)], 2, 3, "state");
      else if (state && !state.IsNull())
        pose = list(state, 2, 3, "state");
      const YAML::Node form =
          shapes.empty() ? YAML::Node(YAML::NodeType::Map) : shapes[std::min(i, shapes.size() - 1)];
      add(form, Placement(pose[0], pose[1], kHeight / 2, pose[2], 0, 0));
    }
  }

  void add(const YAML::Node& shape, const Placement& pose) {
    const std::string kind = name_in(shape, "name");
    if (is_true(shape["random_shape"])) return parts_.leave_out("shapes drawn at random", kind);
    if (kind.empty() || kind == "circle") {
      std::vector<double> center(2, 0);
      if (const YAML::Node given = shape["center"]; given && !given.IsNull())
        center = list(given, 2, 2, "center");
      parts_.add_cylinder(pose + Placement(center[0], center[1], 0, 0, 0, 0),
                          length_in(shape, "radius", 0.2), kHeight);
    } else if (kind == "rectangle") {
      parts_.add_box(pose, length_in(shape, "length", 0.2), length_in(shape, "width", 0.1),
                     kHeight);
    } else if (kind == "polygon" || kind == "linestring") {
      const std::vector<TPoint2D> points = vertices_of(shape);
      if (kind == "linestring") return add_lines(points, pose);
      const Polygon outline{points};
      if (!is_simple(outline)) return parts_.leave_out("polygons that cross themselves", kind);
      parts_.add_prism(pose, outline, -kHeight / 2, kHeight / 2);
    } else {
      parts_.leave_out("shapes", kind);
    }
  }

  std::vector<TPoint2D> vertices_of(const YAML::Node& shape) const {
    const YAML::Node vertices = shape["vertices"];
    if (!vertices || !vertices.IsSequence())
      throw error(shape, "has no list 'vertices'", "pairs of numbers in m");
    std::vector<TPoint2D> points;
    for (const YAML::Node& vertex : vertices) {
      const auto xy = list(vertex, 2, 2, "vertex");
      points.emplace_back(xy[0], xy[1]);
    }
    if (points.size() > 1 && points.front() == points.back() && name_in(shape, "name") == "polygon")
      points.pop_back();
    return points;
  }

  void add_lines(const std::vector<TPoint2D>& points, const Placement& pose) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const TPoint2D along = points[i] - points[i - 1], middle = (points[i] + points[i - 1]) * 0.5;
      if (!(along.norm() > 0)) continue;
      const Placement segment(middle.x, middle.y, 0, math::atan2(along.y, along.x), 0, 0);
      parts_.add_box(pose + segment, along.norm() + kLineWidth, kLineWidth, kHeight);
    }
  }

  const YAML::Node root_;
  std::string where_;
  WorldParts parts_;
  std::optional<mrpt::math::TPose2D> start_;
  std::optional<TPoint2D> goal_;
};

}  // namespace

bool is_ir_sim(const std::string& path) {
  if (!ends_with(path, ".yaml") && !ends_with(path, ".yml")) return false;
  try {
    const YAML::Node root = YAML::Load(read_text(path, "a YAML file", kMaxConfigSize));
    return root.IsMap() && root["world"] && !root["image"];
  } catch (const YAML::Exception&) {
    return false;
  }
}

ImportedWorld ir_sim_world(const std::string& path, const WorldOptions& options) {
  try {
    const YAML::Node root = YAML::Load(read_utf8(path, "a world of ir-sim", kMaxConfigSize));
    if (!root.IsMap()) throw file_error(path, "is not a map", "a world of ir-sim");
    return IrSimReader(root, path, options).read(std::filesystem::path(path).stem().string());
  } catch (const YAML::Exception& e) {
    throw file_error(path + ":" + std::to_string(e.mark.line + 1), "is not YAML (" + e.msg + ")",
                     "a world of ir-sim");
  }
}

}  // namespace slalom
