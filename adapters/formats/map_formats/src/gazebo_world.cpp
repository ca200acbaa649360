// SPDX-License-Identifier: BSD-3-Clause
#include "gazebo_world.h"
#include "world_parts.h"

#include <slalom/core/text.h>
#include <slalom/xml/xml_file.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

constexpr int kMaxDepth = 12;                    // of models in models, and of frames
constexpr std::size_t kMaxElements = 2'000'000;  // models, links and shapes that are visited
constexpr std::size_t kMaxIncludes = 10'000;
constexpr double kActorRadius = 0.3;  // m: an actor has no shape but its mesh

std::string name_of(const XMLElement& element) {
  return xml_attribute(element, "name");
}

bool is_true(const std::string& text) {
  return text == "1" || text == "true" || text == "True";
}

/// A file of models with its folder.
struct SdfFile {
  const XmlFile& xml;
  fs::path folder;
};

/// An element whose children have poses in its frame.
struct Scope {
  const XMLElement& element;
  Placement frame;
  const SdfFile& file;
  int depth = 0;
};

/// The place where a model of Gazebo's model path is, relative to the file that includes it.
std::optional<fs::path> model_file(const fs::path& folder, std::string uri) {
  for (const std::string scheme : {"model://", "file://"})
    if (starts_with(uri, scheme)) uri = uri.substr(scheme.size());
  const fs::path name = fs::path(uri).relative_path();
  if (name.empty() || std::find(name.begin(), name.end(), "..") != name.end()) return std::nullopt;
  std::error_code error;
  for (const fs::path& place : {folder, folder / "models", folder / "..", folder / ".." / "models"})
    for (const fs::path& file : {place / name, place / name / "model.sdf"})
      if (fs::is_regular_file(file, error)) return file;
  return std::nullopt;
}

class GazeboReader {
 public:
  GazeboReader(const std::string& path, const WorldOptions& options) : parts_(path, options) {}

  ImportedWorld read(const SdfFile& file, const std::string& name) {
    const XMLElement& root = file.xml.root();
    const XMLElement* world = root.FirstChildElement("world");
    const Scope scope{world == nullptr ? root : *world, Placement(), file};
    if (world != nullptr) read_state(*world, file);
    add_models(scope);
    for (const XMLElement* actor : xml_children(scope.element, "actor")) add_actor(*actor, file);
    for (const char* kind : {"population", "road"})
      for (const XMLElement* other : xml_children(scope.element, kind))
        parts_.leave_out(std::string(kind) + "s", name_of(*other));
    return parts_.finish(name);
  }

 private:
  /// A saved world states where its models were at that time.
  void read_state(const XMLElement& world, const SdfFile& file) {
    for (const XMLElement* state : xml_children(world, "state"))
      for (const XMLElement* model : xml_children(*state, "model"))
        if (const XMLElement* pose = model->FirstChildElement("pose"))
          saved_poses_[name_of(*model)] = local_pose(*pose, file);
  }

  Placement local_pose(const XMLElement& pose, const SdfFile& file) const {
    const bool is_quaternion = xml_attribute(pose, "rotation_format") == "quat_xyzw";
    std::vector<double> v = file.xml.numbers(pose);
    if (v.empty()) return {};
    v = file.xml.numbers(pose, is_quaternion ? 7 : 6);
    if (is_quaternion) {
      const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
      if (!(std::abs(norm - 1) < 0.01))
        throw file.xml.error(pose, "the quaternion is not normalized", "a rotation");
      return Placement::of_quaternion({v[0], v[1], v[2]}, v[3] / norm, v[4] / norm, v[5] / norm,
                                      v[6] / norm);
    }
    if (is_true(xml_attribute(pose, "degrees")))
      for (std::size_t i = 3; i < 6; ++i) v[i] = mrpt::DEG2RAD(v[i]);
    return Placement(v[0], v[1], v[2], v[5], v[4], v[3]);
  }

  /// The pose of an element in the world; none if it is relative to something unknown.
  std::optional<Placement> pose_in(const Scope& scope, const XMLElement& element, int depth = 0) {
    const XMLElement* pose = element.FirstChildElement("pose");
    std::string relative_to = pose == nullptr ? "" : xml_attribute(*pose, "relative_to");
    if (relative_to.empty()) relative_to = xml_attribute(element, "attached_to");
    const auto base = frame_of(scope, relative_to, depth);
    if (!base) return std::nullopt;
    return pose == nullptr ? *base : *base + local_pose(*pose, scope.file);
  }

  std::optional<Placement> frame_of(const Scope& scope, const std::string& name, int depth) {
    if (name.empty() || name == "__model__") return scope.frame;
    if (name == "world") return Placement();
    if (depth > kMaxDepth) return std::nullopt;
    const auto [found, is_new] = frames_.try_emplace(&scope.element);
    if (is_new)
      for (const char* kind : {"link", "frame", "model"})
        for (const XMLElement* child : xml_children(scope.element, kind))
          found->second.emplace(name_of(*child), child);
    const auto child = found->second.find(name);
    if (child == found->second.end()) return std::nullopt;
    return pose_in(scope, *child->second, depth + 1);
  }

  void visit() { parts_.count(elements_, kMaxElements, "models and links"); }

  void add_models(const Scope& scope) {
    for (const XMLElement* model : xml_children(scope.element, "model")) {
      visit();
      auto pose = pose_in(scope, *model);
      if (scope.depth == 0) use_saved(name_of(*model), pose);
      add_model(scope, *model, pose, name_of(*model));
    }
    for (const XMLElement* include : xml_children(scope.element, "include"))
      add_include(scope, *include);
  }

  void use_saved(const std::string& name, std::optional<Placement>& pose) const {
    const auto saved = saved_poses_.find(name);
    if (saved != saved_poses_.end()) pose = saved->second;
  }

  void add_model(const Scope& outer, const XMLElement& model, const std::optional<Placement>& pose,
                 const std::string& name) {
    if (model.FirstChildElement("plugin") != nullptr)
      return parts_.leave_out("models that plugins may move", name);
    if (!pose || !xml_attribute(model, "placement_frame").empty())
      return parts_.leave_out("models relative to other frames", name);
    if (outer.depth >= kMaxDepth) return parts_.leave_out("models nested too deeply", name);
    const Scope scope{model, *pose, outer.file, outer.depth + 1};
    for (const XMLElement* link : xml_children(model, "link")) {
      visit();
      const auto frame = pose_in(scope, *link);
      if (!frame) {
        parts_.leave_out("links relative to other frames", name + "::" + name_of(*link));
        continue;
      }
      const Scope in_link{*link, *frame, scope.file, scope.depth};
      for (const XMLElement* collision : xml_children(*link, "collision"))
        add_collision(in_link, *collision, name);
    }
    add_models(scope);
  }

  const XmlFile* included(const fs::path& file) {
    auto found = files_.find(file.string());
    if (found == files_.end())
      found =
          files_.emplace(file.string(), XmlFile::read(file.string(), "a model of Gazebo")).first;
    return &found->second;
  }

  void add_include(const Scope& scope, const XMLElement& include) {
    parts_.count(includes_, kMaxIncludes, "included models");
    const std::string uri = xml_text(include.FirstChildElement("uri"));
    if (uri == "model://sun" || uri == "model://ground_plane") return;
    const auto path = model_file(scope.file.folder, uri);
    if (!path) return parts_.leave_out("models without a file", uri);
    const SdfFile file{*included(*path), path->parent_path()};
    const XMLElement* model = file.xml.root().FirstChildElement("model");
    if (model == nullptr) throw file.xml.error(file.xml.root(), "has no <model>", "an SDF model");
    std::string name = xml_text(include.FirstChildElement("name"));
    if (name.empty()) name = name_of(*model);
    if (include.FirstChildElement("plugin") != nullptr)
      return parts_.leave_out("models that plugins may move", name);
    auto pose = include.FirstChildElement("pose") != nullptr
                    ? pose_in(scope, include)
                    : pose_in({scope.element, scope.frame, file, scope.depth}, *model);
    if (scope.depth == 0) use_saved(name, pose);
    add_model({scope.element, scope.frame, file, scope.depth}, *model, pose, name);
  }

  /// A length of a shape.
  static double length(const XmlFile& xml, const XMLElement& shape, const char* name) {
    const XMLElement* element = shape.FirstChildElement(name);
    if (element == nullptr)
      throw xml.error(shape, "<" + std::string(shape.Name()) + "> has no <" + name + ">",
                      "a length in m");
    const double value = xml.numbers(*element, 1)[0];
    if (!(value > 0)) throw xml.error(*element, "is " + format_number(value), "a length > 0");
    return value;
  }

  void add_collision(const Scope& link, const XMLElement& collision, const std::string& model) {
    visit();
    const XMLElement* geometry = collision.FirstChildElement("geometry");
    const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
    if (shape == nullptr) return;
    const auto pose = pose_in(link, collision);
    if (!pose) return parts_.leave_out("shapes relative to other frames", model);
    const XmlFile& xml = link.file.xml;
    const std::string kind = shape->Name();
    if (kind == "box") {
      add_box(*pose, *shape, xml);
    } else if (kind == "cylinder") {
      parts_.add_cylinder(*pose, length(xml, *shape, "radius"), length(xml, *shape, "length"));
    } else if (kind == "sphere") {
      parts_.add_sphere(*pose, length(xml, *shape, "radius"));
    } else if (kind == "polyline") {
      add_polyline(*pose, *shape, xml, model);
    } else if (kind == "mesh") {
      parts_.leave_out("meshes of", model);
    } else if (kind != "plane" && kind != "empty") {
      parts_.leave_out("shapes <" + kind.substr(0, 40) + "> of", model);
    } else if (kind == "plane" && !is_ground(*pose, *shape, xml)) {
      parts_.leave_out("planes of", model);
    }
  }

  void add_box(const Placement& pose, const XMLElement& box, const XmlFile& xml) {
    const XMLElement* element = box.FirstChildElement("size");
    if (element == nullptr) throw xml.error(box, "<box> has no <size>", "three lengths in m");
    const auto size = xml.numbers(*element, 3);
    if (!std::all_of(size.begin(), size.end(), [](double side) { return side > 0; }))
      throw xml.error(*element, "a side is not above 0", "three lengths > 0");
    parts_.add_box(pose, size[0], size[1], size[2]);
  }

  void add_polyline(const Placement& pose, const XMLElement& polyline, const XmlFile& xml,
                    const std::string& model) {
    Polygon outline;
    for (const XMLElement* point : xml_children(polyline, "point")) {
      const auto xy = xml.numbers(*point, 2);
      outline.vertices.emplace_back(xy[0], xy[1]);
    }
    auto& corners = outline.vertices;
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    const double height = length(xml, polyline, "height");
    if (!is_simple(outline) || !parts_.add_prism(pose, outline, 0, height))
      parts_.leave_out("polylines that cross themselves or are tilted of", model);
  }

  static bool is_ground(const Placement& pose, const XMLElement& plane, const XmlFile& xml) {
    mrpt::math::TPoint3D normal(0, 0, 1);
    if (const XMLElement* element = plane.FirstChildElement("normal")) {
      const auto v = xml.numbers(*element, 3);
      normal = {v[0], v[1], v[2]};
    }
    return std::abs(pose.turned(normal).z) > 0.99 * normal.norm();
  }

  void add_actor(const XMLElement& actor, const SdfFile& file) {
    visit();
    const XMLElement* script = actor.FirstChildElement("script");
    const XMLElement* path = script == nullptr ? nullptr : script->FirstChildElement("trajectory");
    Mover mover;
    mover.id = name_of(actor).substr(0, 100);
    mover.radius = kActorRadius;
    if (path != nullptr) {
      const XMLElement* delay = script->FirstChildElement("delay_start");
      const double begin = delay == nullptr ? 0 : file.xml.numbers(*delay, 1)[0];
      for (const XMLElement* waypoint : xml_children(*path, "waypoint"))
        mover.waypoints.push_back(waypoint_of(*waypoint, begin, file));
    }
    if (mover.waypoints.empty()) return parts_.leave_out("actors without waypoints", mover.id);
    const std::string loop = xml_text(script->FirstChildElement("loop"));
    const bool is_closed = mover.waypoints.size() > 1 &&
                           mover.waypoints.front().position == mover.waypoints.back().position;
    if (is_closed && (loop.empty() || is_true(loop))) mover.after = MoverEnd::Loop;
    parts_.add_mover(std::move(mover));
  }

  Waypoint waypoint_of(const XMLElement& waypoint, double begin, const SdfFile& file) const {
    const XMLElement* time = waypoint.FirstChildElement("time");
    const XMLElement* pose = waypoint.FirstChildElement("pose");
    if (time == nullptr || pose == nullptr)
      throw file.xml.error(waypoint, "an incomplete waypoint", "<time> and <pose>");
    const Placement at = local_pose(*pose, file);
    return {begin + file.xml.numbers(*time, 1)[0], {at.x(), at.y()}};
  }

  WorldParts parts_;
  std::map<std::string, XmlFile> files_;
  /// The first child of each name that is a frame, by element.
  std::map<const XMLElement*, std::map<std::string, const XMLElement*>> frames_;
  std::map<std::string, Placement> saved_poses_;
  std::size_t elements_ = 0, includes_ = 0;
};

}  // namespace

ImportedWorld gazebo_world(const XmlFile& file, const std::string& path,
                           const WorldOptions& options) {
  return GazeboReader(path, options)
      .read({file, fs::path(path).parent_path()}, fs::path(path).stem().string());
}

}  // namespace slalom
