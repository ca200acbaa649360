#include "map_readers.h"
#include "turned_grid.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <yaml-cpp/yaml.h>

#include <cmath>

namespace slalom {
namespace {

/// The keys of a ROS map_server YAML (wiki.ros.org/map_server), checked.
struct RosMap {
  std::string image;
  double resolution = 0;  // m
  double x = 0, y = 0, yaw = 0;
  bool negate = false;
  double occupied_threshold = 0.65, free_threshold = 0.196;
  std::string mode = "trinary";
};

class RosMapReader {
 public:
  RosMapReader(const YAML::Node& root, const std::string& path) : root_(root), path_(path) {}

  RosMap read() const {
    RosMap map;
    if (!root_.IsMap()) throw broken(root_, "is no map", "keys and values");
    map.image = text("image", required("image"));
    read_resolution(required("resolution"), map);
    read_origin(required("origin"), map);
    if (const YAML::Node node = root_["negate"]) map.negate = number("negate", node) != 0;
    if (const YAML::Node node = root_["occupied_thresh"])
      map.occupied_threshold = number("occupied_thresh", node);
    if (const YAML::Node node = root_["free_thresh"])
      map.free_threshold = number("free_thresh", node);
    if (const YAML::Node node = root_["mode"]) map.mode = text("mode", node);
    if (map.mode != "trinary" && map.mode != "scale" && map.mode != "raw")
      throw broken(root_["mode"], "mode '" + map.mode + "' is unknown", "trinary, scale or raw");
    if (map.free_threshold > map.occupied_threshold)
      throw broken(root_, "free_thresh is above occupied_thresh", "free_thresh <= occupied_thresh");
    return map;
  }

 private:
  Error broken(const YAML::Node& node, const std::string& what, const std::string& expected) const {
    const int line = node.Mark().line + 1;
    return file_error(line > 0 ? path_ + ":" + std::to_string(line) : path_, what, expected);
  }

  YAML::Node required(const std::string& key) const {
    const YAML::Node node = root_[key];
    if (!node) throw broken(root_, "key '" + key + "' is missing", "a ROS map_server YAML");
    return node;
  }

  std::string text(const std::string& key, const YAML::Node& node) const {
    if (!node.IsScalar()) throw broken(node, key + " is of the wrong kind", "a text");
    return node.Scalar();
  }

  double number(const std::string& key, const YAML::Node& node) const {
    double value = 0;
    if (!node.IsScalar() || !parse_number(node.Scalar(), value))
      throw broken(node, key + " is not a finite number", "a number");
    return value;
  }

  /// MRPT keeps lengths in single precision: what is beyond it is no cell either.
  void read_resolution(const YAML::Node& node, RosMap& map) const {
    map.resolution = number("resolution", node);
    const auto kept = static_cast<float>(map.resolution);
    if (!(kept > 0) || !std::isfinite(kept))
      throw broken(node, "resolution " + node.Scalar() + " is no size of a cell", "metres, > 0");
  }

  void read_origin(const YAML::Node& origin, RosMap& map) const {
    if (!origin.IsSequence() || origin.size() < 2 || origin.size() > 3)
      throw broken(origin, "origin has not the right form", "[x, y, yaw]");
    map.x = number("origin", origin[0]);
    map.y = number("origin", origin[1]);
    if (origin.size() == 3) map.yaw = number("origin", origin[2]);
    if (!std::isfinite(static_cast<float>(map.x)) || !std::isfinite(static_cast<float>(map.y)))
      throw broken(origin, "origin is too far away", "[x, y, yaw] in metres");
  }

  const YAML::Node& root_;
  const std::string& path_;
};

/// Probability of being free, as a cell keeps it: 1 free, 0 occupied, 0.5 unknown.
float free_probability(const RosMap& map, std::uint8_t pixel) {
  if (map.mode == "raw")  // the value itself is the occupancy in percent; beyond 100 is unknown
    return pixel > 100 ? 0.5F : 1.0F - static_cast<float>(pixel) / 100.0F;
  const double occupied = map.negate ? pixel / 255.0 : (255 - pixel) / 255.0;
  if (occupied > map.occupied_threshold) return 0.0F;
  if (occupied < map.free_threshold) return 1.0F;
  if (map.mode == "trinary") return 0.5F;
  const double share =
      (occupied - map.free_threshold) / (map.occupied_threshold - map.free_threshold);
  return static_cast<float>(1 - share);
}

std::string beside(const std::string& path, const std::string& image) {
  const std::size_t slash = path.find_last_of('/');
  if (image.empty() || image[0] == '/' || slash == std::string::npos) return image;
  return path.substr(0, slash + 1) + image;
}

RosMap parse(const std::string& path) {
  const std::string bytes = read_bytes(path);
  try {
    const YAML::Node root = YAML::Load(bytes);
    return RosMapReader(root, path).read();
  } catch (const YAML::Exception& e) {
    throw file_error(path + ":" + std::to_string(e.mark.line + 1), "is not YAML (" + e.msg + ")",
                     "a ROS map_server YAML");
  }
}

}  // namespace

mrpt::maps::COccupancyGridMap2D read_ros_map(const std::string& path) {
  const RosMap ros = parse(path);
  const GreyImage image = read_grey_image(beside(path, ros.image));
  auto map = make_grid_map(image.width, image.height, ros.resolution, {ros.x, ros.y});
  std::size_t i = 0;
  for (int row = 0; row < image.height; ++row)
    for (int x = 0; x < image.width; ++x, ++i)
      map.setCell(x, image.height - 1 - row, free_probability(ros, image.pixels[i]));
  return ros.yaw == 0 ? map : turned_grid(map, ros.yaw, path);
}

}  // namespace slalom
