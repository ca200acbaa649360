// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"
#include "mvsim_world.h"
#include "world_parts.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/xml/xml_file.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using mrpt::math::TPoint2D;
using tinyxml2::XMLElement;

constexpr std::size_t kMaxWallEnds = 4000;  // each is compared with all others
constexpr int kMaxCorners = 1000;

/// An object with its class, whose values it overrides.
struct MvsimObject {
  const XMLElement& own;
  const XMLElement* of_class = nullptr;

  const XMLElement* child(const char* name) const {
    const XMLElement* found = own.FirstChildElement(name);
    return found == nullptr && of_class != nullptr ? of_class->FirstChildElement(name) : found;
  }
};

class MvsimReader {
 public:
  MvsimReader(const XmlFile& file, const std::string& path, const WorldOptions& options)
      : file_(file), folder_(fs::path(path).parent_path()), parts_(path, options) {}

  ImportedWorld read(const std::string& name) {
    for (const XMLElement* item = file_.root().FirstChildElement(); item != nullptr;
         item = item->NextSiblingElement())
      read_item(*item, item->Name());
    if (grid_) parts_.set_grid(without_border(std::move(*grid_)));
    parts_.set_task(start_, std::nullopt);
    return parts_.finish(name);
  }

 private:
  static constexpr std::size_t kMaxValue = 1000;
  static constexpr int kMaxDepth = 100;  ///< of values that name variables

  void read_item(const XMLElement& item, const std::string& kind) {
    const std::string name = xml_attribute(item, "name"), type = xml_attribute(item, "class");
    if (kind == "variable") {
      // Values of variables that name others grow exponentially.
      const std::string value = with_variables(xml_attribute(item, "value"));
      if (value.size() > kMaxValue)
        throw file_.error(item,
                          "the value of variable '" + name + "' has more than " +
                              std::to_string(kMaxValue) + " characters",
                          "a number, a name or a path");
      variables_[name] = value;
    } else if (kind == "block:class") {
      classes_[name] = &item;
    } else if (kind == "for" || kind == "if") {
      parts_.leave_out("objects of loops and conditions", xml_attribute(item, "var"));
    } else if (kind == "block" || kind == "element" || kind == "walls" || kind == "vehicle") {
      const auto found = classes_.find(type);
      const MvsimObject object{
          item, kind == "block" && found != classes_.end() ? found->second : nullptr};
      if (is_computed(item) || (object.of_class != nullptr && is_computed(*object.of_class)))
        parts_.leave_out("objects with formulas", name.empty() ? type : name);
      else
        read_object(object, kind, name.empty() ? type : name);
    } else if (kind == "actor") {
      parts_.leave_out("actors", name);
    } else if (kind == "include") {
      const std::string included = xml_attribute(item, "file");
      if (!ends_with(included, ".vehicle.xml") && !ends_with(included, ".sensor.xml"))
        parts_.leave_out("included files", included);
    }
  }

  void read_object(const MvsimObject& object, const std::string& kind, const std::string& name) {
    if (kind == "block") return add_block(object, name);
    if (kind == "walls") return add_walls(object, name);
    if (kind == "vehicle") {
      const XMLElement* pose = object.child("init_pose");
      if (pose == nullptr || start_) return parts_.leave_out("vehicles", name);
      const auto v = numbers(*pose, 3);
      start_ = {v[0], v[1], mrpt::DEG2RAD(v[2])};
      return;
    }
    if (name == "occupancy_grid") return read_grid(object);
    if (name == "vertical_plane") return add_vertical_plane(object);
    if (name == "horizontal_plane") {
      const double z = number(object, "z", 0);
      if (z <= 0)
        plane_ = Bounds{number(object, "x_min", -10), number(object, "y_min", -10),
                        number(object, "x_max", 10), number(object, "y_max", 10)};
    } else if (name != "ground_grid" && name != "skybox" && name != "property_region") {
      parts_.leave_out("elements", name);
    }
  }

  /// ${NAME} and $f{NAME} with their values, in which other variables may be named.
  std::string with_variables(const std::string& text) const {
    std::string result;
    append_with_variables(text, text.size() + 1000 * kMaxValue, 0, result);
    return result;
  }

  void append_with_variables(const std::string& text, std::size_t max_size, int depth,
                             std::string& result) const {
    std::size_t next = 0;
    for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1)) {
      const std::size_t open = at + (text.compare(at, 2, "$f") == 0 ? 2 : 1);
      if (open >= text.size() || text[open] != '{') continue;
      const std::string name = text.substr(open + 1, kMaxValue);
      const auto variable = variables_.find(name.substr(0, name.find('}')));
      if (variable == variables_.end() || name.find('}') == std::string::npos) continue;
      result.append(text, next, at - next);
      if (depth == kMaxDepth || result.size() > max_size)
        throw file_.error(file_.root(), "values of variables name each other",
                          "values without names of variables");
      append_with_variables(variable->second, max_size, depth + 1, result);
      at = open + 1 + name.find('}');
      next = at + 1;
    }
    result.append(text, next, std::string::npos);
  }

  /// Whether a value needs mvsim's evaluation of formulas; ${NAME} is the name of the object, which
  /// only topics use.
  bool is_computed(const XMLElement& element) const {
    tinyxml2::XMLPrinter printer(nullptr, true);
    element.Accept(&printer);
    const std::string text = with_variables(printer.CStr());
    for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1))
      if (text.compare(at, 7, "${NAME}") != 0 && text.compare(at, 9, "${PARENT_") != 0) return true;
    return false;
  }

  std::vector<double> numbers(const XMLElement& element, std::size_t count) const {
    return file_.numbers(element, with_variables(xml_text(&element)), count);
  }

  /// A child or an attribute of an object.
  double number(const MvsimObject& object, const char* name, double otherwise) const {
    if (const XMLElement* child = object.child(name)) return numbers(*child, 1)[0];
    const std::string value = xml_attribute(object.own, name);
    return value.empty() ? otherwise : file_.numbers(object.own, with_variables(value), 1)[0];
  }

  Polygon points_of(const XMLElement& shape) const {
    Polygon points;
    for (const XMLElement* point = shape.FirstChildElement("pt"); point != nullptr;
         point = point->NextSiblingElement("pt")) {
      const auto v = numbers(*point, 2);
      points.vertices.emplace_back(v[0], v[1]);
    }
    return points;
  }

  void read_grid(const MvsimObject& object) {
    const XMLElement* element = object.child("file");
    if (element == nullptr)
      throw file_.error(object.own, "the occupancy grid has no <file>", "a map");
    const std::string name = with_variables(xml_text(element));
    if (grid_) return parts_.leave_out("further occupancy grids", name);
    MapImportOptions options;
    options.image.resolution = number(object, "resolution", 0.1);
    const double x = number(object, "centerpixel_x", -1), y = number(object, "centerpixel_y", -1);
    const std::string path = (folder_ / name).string();
    grid_ = load_map(path, options);
    const bool is_image = !ends_with(name, ".gridmap") && !ends_with(name, ".gridmap.gz") &&
                          !ends_with(name, ".yaml");
    if (!is_image) return;
    auto moved = make_grid_map(static_cast<int>(grid_->getSizeX()),
                               static_cast<int>(grid_->getSizeY()), options.image.resolution,
                               {-x * options.image.resolution, -y * options.image.resolution});
    for (int cy = 0; cy < static_cast<int>(grid_->getSizeY()); ++cy)
      for (int cx = 0; cx < static_cast<int>(grid_->getSizeX()); ++cx)
        moved.setCell(cx, cy, grid_->getCell(cx, cy));
    grid_ = std::move(moved);
  }

  /// The grid inside the wall that an export by Slalom adds around the workspace, its
  /// horizontal_plane.
  mrpt::maps::COccupancyGridMap2D without_border(mrpt::maps::COccupancyGridMap2D grid) const {
    const int size_x = static_cast<int>(grid.getSizeX()),
              size_y = static_cast<int>(grid.getSizeY());
    const double cell = grid.getResolution();
    const auto is_one_cell = [&](double distance) {
      return std::abs(distance - cell) < 0.01 * cell;
    };
    if (!plane_ || size_x < 3 || size_y < 3 || !is_one_cell(plane_->x_min - grid.getXMin()) ||
        !is_one_cell(plane_->y_min - grid.getYMin()) ||
        !is_one_cell(grid.getXMax() - plane_->x_max) ||
        !is_one_cell(grid.getYMax() - plane_->y_max))
      return grid;
    auto inner = make_grid_map(size_x - 2, size_y - 2, cell, {plane_->x_min, plane_->y_min});
    for (int y = 0; y < size_y; ++y)
      for (int x = 0; x < size_x; ++x) {
        if (x > 0 && y > 0 && x + 1 < size_x && y + 1 < size_y)
          inner.setCell(x - 1, y - 1, grid.getCell(x, y));
        else if (grid.getCell(x, y) > 0.5F)
          return grid;
      }
    return inner;
  }

  void add_wall(const TPoint2D& a, const TPoint2D& b, double thickness, double low, double high) {
    const double length = (b - a).norm();
    if (!(length > 0)) return;
    const Placement pose((a.x + b.x) / 2, (a.y + b.y) / 2, (low + high) / 2,
                         math::atan2(b.y - a.y, b.x - a.x), 0, 0);
    parts_.add_box(pose, length, thickness, high - low);
  }

  void add_vertical_plane(const MvsimObject& object) {
    const TPoint2D a(number(object, "x0", -10), number(object, "y0", -10)),
        b(number(object, "x1", -10), number(object, "y1", 10));
    const double thickness = number(object, "thickness", 0.02), z = number(object, "z", 0),
                 height = number(object, "height", 3), length = (b - a).norm();
    require_positive(object.own, "thickness", thickness);
    require_positive(object.own, "height", height);
    std::vector<std::pair<double, double>> doors{{length, length}};
    for (const XMLElement* door = object.own.FirstChildElement("door"); door != nullptr;
         door = door->NextSiblingElement("door")) {
      const double middle = length * number({*door}, "position", 0.5),
                   width = number({*door}, "width", 1);
      doors.emplace_back(middle - width / 2, middle + width / 2);
    }
    std::sort(doors.begin(), doors.end());
    double begin = 0;
    for (const auto& [from, to] : doors) {
      if (from > begin && length > 0)
        add_wall(a + (b - a) * (begin / length), a + (b - a) * (std::min(from, length) / length),
                 thickness, z, z + height);
      begin = std::max(begin, to);
    }
  }

  void require_positive(const XMLElement& element, const char* name, double value) const {
    if (!(value > 0))
      throw file_.error(element, std::string(name) + " is " + format_number(value), "a length > 0");
  }

  /// Pairs of ends; as in mvsim, ends near earlier ones are extended so that corners are closed.
  void add_walls(const MvsimObject& walls, const std::string& name) {
    const XMLElement* shape = walls.child("shape");
    if (shape == nullptr || walls.child("transformation") != nullptr)
      return parts_.leave_out("walls of files or with a transformation", name);
    const double thickness = number(walls, "wallThickness", 0.1),
                 height = number(walls, "wallHeight", 2);
    require_positive(walls.own, "wallThickness", thickness);
    require_positive(walls.own, "wallHeight", height);
    const std::vector<TPoint2D> ends = points_of(*shape).vertices;
    if (ends.size() % 2 != 0 || ends.size() > kMaxWallEnds)
      throw file_.error(*shape, "has " + count_text(ends.size(), "point"),
                        "pairs, at most " + std::to_string(kMaxWallEnds) + " points");
    const auto meets = [&](std::size_t end, std::size_t count) {
      return std::any_of(
          ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count),
          [&](const TPoint2D& other) { return (other - ends[end]).norm() < 1.01 * thickness; });
    };
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      const TPoint2D along = ends[i + 1] - ends[i];
      if (!(along.norm() > 0)) continue;
      const TPoint2D extension = along * (thickness / 2 / along.norm());
      add_wall(meets(i, i) ? ends[i] - extension : ends[i],
               meets(i + 1, i) ? ends[i + 1] + extension : ends[i + 1], thickness, 0, height);
    }
  }

  void add_block(const MvsimObject& block, const std::string& name) {
    const std::string intangible = xml_text(block.child("intangible"));
    if (intangible == "true" || intangible == "1")
      return parts_.leave_out("intangible blocks", name);
    if (block.child("animation") != nullptr)
      return parts_.leave_out("blocks with animations", name);
    const XMLElement *plain = block.child("init_pose"), *spatial = block.child("init_pose3d");
    if (plain == nullptr && spatial == nullptr)
      throw file_.error(block.own, "the block '" + name.substr(0, 60) + "' has no pose",
                        "<init_pose> or <init_pose3d>");
    std::vector<double> v(6, 0);
    if (plain != nullptr) {
      const auto xy = numbers(*plain, 3);
      v[0] = xy[0], v[1] = xy[1], v[3] = xy[2];
    } else {
      v = numbers(*spatial, 6);
    }
    const Placement pose(v[0], v[1], v[2], mrpt::DEG2RAD(v[3]), mrpt::DEG2RAD(v[4]),
                         mrpt::DEG2RAD(v[5]));
    if (const XMLElement* shape = block.child("shape"))
      add_shape(block, name, pose, points_of(*shape), 1);
    else if (const XMLElement* geometry = block.child("geometry"))
      add_geometry(block, name, pose, *geometry);
    else if (block.child("shape_from_visual") != nullptr)
      parts_.leave_out("meshes of", name);
    else
      add_shape(block, name, pose, {{{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}}, 1);
  }

  void add_shape(const MvsimObject& block, const std::string& name, const Placement& pose,
                 const Polygon& outline, double height) {
    const bool is_own = block.child("shape_from_visual") != nullptr;
    const double low = is_own ? 0 : number(block, "zmin", 0),
                 high = is_own ? height : number(block, "zmax", height);
    if (!is_simple(outline) || !parts_.add_prism(pose, outline, low, high))
      parts_.leave_out("shapes that cross themselves or are tilted of", name);
  }

  void add_geometry(const MvsimObject& block, const std::string& name, const Placement& pose,
                    const XMLElement& geometry) {
    const MvsimObject values{geometry};
    const std::string type = lower_case(xml_attribute(geometry, "type"));
    const auto length = [&](const char* key) {
      const double value = number(values, key, 0);
      require_positive(geometry, key, value);
      return value;
    };
    if (type == "cylinder") {
      const double corners = number(values, "vertex_count", 10), radius = length("radius");
      if (!(corners >= 3 && corners <= kMaxCorners))
        throw file_.error(geometry, "vertex_count is " + format_number(corners), "3 to 1000");
      Polygon outline;
      for (int i = 0; i < static_cast<int>(corners); ++i) {
        const double angle = 2 * M_PI * i / std::floor(corners);
        outline.vertices.emplace_back(radius * math::cos(angle), radius * math::sin(angle));
      }
      add_shape(block, name, pose, outline, length("length"));
    } else if (type == "box") {
      const double x = length("lx"), y = length("ly");
      add_shape(block, name, pose, {{{0, 0}, {x, 0}, {x, y}, {0, y}}}, length("lz"));
    } else if (type == "sphere") {
      parts_.add_sphere(pose, length("radius"));
    } else {
      parts_.leave_out("shapes '" + type.substr(0, 40) + "' of", name);
    }
  }

  const XmlFile& file_;
  fs::path folder_;
  WorldParts parts_;
  std::map<std::string, std::string> variables_;
  std::map<std::string, const XMLElement*> classes_;
  std::optional<mrpt::maps::COccupancyGridMap2D> grid_;
  std::optional<Bounds> plane_;
  std::optional<mrpt::math::TPose2D> start_;
};

}  // namespace

ImportedWorld mvsim_world(const XmlFile& file, const std::string& path,
                          const WorldOptions& options) {
  std::string name = fs::path(path).filename().string();
  name.erase(name.find('.') == 0 ? name.size() : std::min(name.find('.'), name.size()));
  return MvsimReader(file, path, options).read(name);
}

}  // namespace slalom
