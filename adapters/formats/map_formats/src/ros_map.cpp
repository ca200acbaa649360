// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"
#include "rotated_grid.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace slalom {
namespace {

enum class RosMapMode { Trinary, Scale, Raw };
constexpr auto enum_names(RosMapMode) {
  return std::array{"trinary", "scale", "raw"};
}

/// The validated keys of a ROS map_server YAML (wiki.ros.org/map_server).
struct RosMap {
  std::string image;
  double resolution = 0;  // m
  double x = 0, y = 0, yaw = 0;
  bool negate = false;
  double occupied_threshold = 0.65, free_threshold = 0.196;
  RosMapMode mode = RosMapMode::Trinary;
};

class RosMapReader {
 public:
  RosMapReader(const YAML::Node& root, const std::string& path) : root_(root), path_(path) {}

  RosMap read() const {
    RosMap map;
    if (!root_.IsMap()) throw malformed(root_, "is not a map_server YAML", "keys and values");
    map.image = text("image", required("image"));
    read_resolution(required("resolution"), map);
    read_origin(required("origin"), map);
    if (const YAML::Node node = root_["negate"]) map.negate = flag("negate", node);
    if (const YAML::Node node = root_["occupied_thresh"])
      map.occupied_threshold = number("occupied_thresh", node);
    if (const YAML::Node node = root_["free_thresh"])
      map.free_threshold = number("free_thresh", node);
    if (const YAML::Node node = root_["mode"]) map.mode = mode(node);
    if (map.free_threshold > map.occupied_threshold)
      throw malformed(root_, "free_thresh is above occupied_thresh",
                      "free_thresh <= occupied_thresh");
    return map;
  }

 private:
  Error malformed(const YAML::Node& node, const std::string& what,
                  const std::string& expected) const {
    const int line = node.Mark().line + 1;
    return file_error(line > 0 ? path_ + ":" + std::to_string(line) : path_, what, expected);
  }

  YAML::Node required(const std::string& key) const {
    const YAML::Node node = root_[key];
    if (!node) throw malformed(root_, "missing key '" + key + "'", "a ROS map_server YAML");
    return node;
  }

  std::string text(const std::string& key, const YAML::Node& node) const {
    if (!node.IsScalar()) throw malformed(node, "invalid " + key, "a text");
    return node.Scalar();
  }

  double number(const std::string& key, const YAML::Node& node) const {
    double value = 0;
    if (!node.IsScalar() || !parse_number(node.Scalar(), value))
      throw malformed(node, "invalid " + key, "a finite number");
    return value;
  }

  RosMapMode mode(const YAML::Node& node) const {
    const std::string name = text("mode", node);
    if (const auto mode = from_name<RosMapMode>(lower_case(name))) return *mode;
    throw malformed(node, "unknown mode '" + name + "'", "trinary, scale or raw");
  }

  /// Reads a flag like nav2's map_io: an integer (0 is false), else a YAML boolean.
  bool flag(const std::string& key, const YAML::Node& node) const {
    int integer = 0;
    bool value = false;
    if (YAML::convert<int>::decode(node, integer)) return integer != 0;
    if (!YAML::convert<bool>::decode(node, value))
      throw malformed(node, "invalid " + key, "0, 1, true or false");
    return value;
  }

  /// MRPT stores lengths in single precision, so the resolution must be valid as float.
  void read_resolution(const YAML::Node& node, RosMap& map) const {
    map.resolution = number("resolution", node);
    const auto value = static_cast<float>(map.resolution);
    if (!(value > 0) || !std::isfinite(value))
      throw malformed(node, "invalid resolution " + node.Scalar(), "meters, > 0");
  }

  void read_origin(const YAML::Node& origin, RosMap& map) const {
    if (!origin.IsSequence() || origin.size() < 2 || origin.size() > 3)
      throw malformed(origin, "malformed origin", "[x, y, yaw]");
    map.x = number("origin", origin[0]);
    map.y = number("origin", origin[1]);
    if (origin.size() == 3) map.yaw = number("origin", origin[2]);
    if (!std::isfinite(static_cast<float>(map.x)) || !std::isfinite(static_cast<float>(map.y)))
      throw malformed(origin, "origin out of range", "[x, y, yaw] in meters");
  }

  const YAML::Node& root_;
  const std::string& path_;
};

/// The probability of being free: 1 free, 0 occupied, 0.5 unknown. `shade` is 0 for black, 1 for
/// white; the formulas are those of map_io in nav2 1.5, also their single precision, which decides
/// where a shade equals a threshold.
float free_probability(const RosMap& map, float shade) {
  if (map.mode == RosMapMode::Raw) {  // of 255, the occupancy in percent; beyond 100 is unknown
    const float percent = std::round(shade * 255);
    return percent > 100 ? 0.5F : 1.0F - percent / 100.0F;
  }
  const float occupied = map.negate ? shade : 1 - shade;
  const auto free_from = static_cast<float>(map.free_threshold);
  const auto occupied_from = static_cast<float>(map.occupied_threshold);
  if (occupied <= free_from) return 1.0F;
  if (occupied >= occupied_from) return 0.0F;
  if (map.mode == RosMapMode::Trinary) return 0.5F;
  return 1 - (occupied - free_from) / (occupied_from - free_from);
}

/// Transparent pixels are unknown but in mode raw, which ignores alpha.
float free_probability(const RosMap& map, const GrayImage& image, std::size_t pixel) {
  if (map.mode != RosMapMode::Raw && image.is_transparent(pixel)) return 0.5F;
  return free_probability(
      map, static_cast<float>(image.pixels[pixel]) / static_cast<float>(image.white));
}

/// The image of a map; if it is not where the map says, as on another computer, the file of its
/// name beside the map.
std::string image_path(const std::string& path, const std::string& image,
                       std::vector<std::string>& notes) {
  namespace fs = std::filesystem;
  if (image.empty()) return image;
  std::string name = image;
  for (const std::string scheme : {"file://", "package://"})
    if (starts_with(name, scheme)) name = name.substr(scheme.size());
  const char* home = std::getenv("HOME");
  if (starts_with(name, "~/") && home != nullptr) name = home + name.substr(1);
  const fs::path folder = fs::path(path).parent_path(), stated = folder / name;
  std::error_code error;
  if (fs::exists(stated, error)) return stated.string();
  const fs::path beside = folder / fs::path(name).filename();
  if (!fs::exists(beside, error)) return stated.string();
  notes.push_back("image '" + printable_line(image) + "' is missing; '" +
                  printable_line(fs::path(name).filename().string()) + "' beside the map is read");
  return beside.string();
}

/// Notes about values that are valid and often not meant.
void note_suspicions(const RosMap& map, const GrayImage& image, std::vector<std::string>& notes) {
  if (std::abs(map.yaw) > 2 * M_PI)
    notes.push_back("a yaw of " + format_number(map.yaw) + " rad: degrees?");
  constexpr int kUnknown = 205;  // of 255, as map_saver writes unknown cells
  const auto is_unknown = [&](std::size_t i) {
    return image.white == 255 && image.pixels[i] == kUnknown && !image.is_transparent(i);
  };
  std::size_t free = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    free += is_unknown(i) && free_probability(map, image, i) == 1 ? 1 : 0;
  if (free > 0 && map.mode != RosMapMode::Raw)
    notes.push_back(count_text(free, "cell") +
                    " of gray 205, which map_saver writes for unknown, " +
                    (free == 1 ? "is" : "are") + " free with free_thresh " +
                    format_number(map.free_threshold) + ", as in nav2");
}

RosMap parse(const std::string& path) {
  const std::string bytes = read_utf8(path, "a ROS map (.yaml)", kMaxConfigSize);
  try {
    const YAML::Node root = YAML::Load(bytes);
    return RosMapReader(root, path).read();
  } catch (const YAML::Exception& e) {
    throw file_error(path + ":" + std::to_string(e.mark.line + 1), "is not YAML (" + e.msg + ")",
                     "a ROS map_server YAML");
  }
}

}  // namespace

mrpt::maps::COccupancyGridMap2D read_ros_map(const std::string& path,
                                             std::vector<std::string>* notes) {
  const RosMap ros = parse(path);
  std::vector<std::string> found;
  const GrayImage image = read_gray_image(image_path(path, ros.image, found));
  note_suspicions(ros, image, found);
  if (notes != nullptr) notes->insert(notes->end(), found.begin(), found.end());
  auto map = make_grid_map(image.width, image.height, ros.resolution, {ros.x, ros.y});
  std::size_t i = 0;
  for (int row = 0; row < image.height; ++row)
    for (int x = 0; x < image.width; ++x, ++i)
      map.setCell(x, image.height - 1 - row, free_probability(ros, image, i));
  return ros.yaw == 0 ? map : rotated_grid(map, ros.yaw, path);
}

}  // namespace slalom
