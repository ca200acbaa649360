// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.h"
#include "parameter_files.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>

namespace slalom::ros {
namespace {

const std::string kKind = "parameters of Nav2 or move_base (.yaml)";
// Aliases make files whose values are many times their size, or without an end.
constexpr std::size_t kMaxValues = 5000;
constexpr int kMaxDepth = 20;

/// The names of a key: "/robot/local_costmap" and "BaseObstacle.scale" have two.
std::vector<std::string> names_of(std::string key) {
  std::replace(key.begin(), key.end(), '/', '.');
  return split_nonempty(key, '.');
}

/// Reads the values of a file in its order; of a key that is given twice the last one, as ROS.
class YamlFlattener {
 public:
  YamlFlattener(std::string path, std::vector<RosParameter>& parameters)
      : path_(std::move(path)), parameters_(parameters) {}

  void read(const YAML::Node& root) {
    if (!root.IsMap()) throw error(root, "has no keys", kKind);
    read_map(root, {}, 0);
  }

 private:
  Error error(const YAML::Node& node, const std::string& what, const std::string& expected) const {
    return file_error(position(node), what, expected);
  }

  std::string position(const YAML::Node& node) const {
    const int line = node.Mark().line + 1;
    return line > 0 ? path_ + ":" + std::to_string(line) : path_;
  }

  void count(const YAML::Node& node, int depth) {
    if (++values_ > kMaxValues || depth > kMaxDepth)
      throw error(node,
                  "has more than " + std::to_string(kMaxValues) + " values or " +
                      std::to_string(kMaxDepth) + " levels",
                  kKind);
  }

  void read_map(const YAML::Node& map, const std::vector<std::string>& path, int depth) {
    for (const auto& entry : map) {
      count(entry.first, depth);
      if (!entry.first.IsScalar()) throw error(entry.first, "a key is not a text", kKind);
      std::vector<std::string> names = path;
      for (const std::string& name : names_of(entry.first.Scalar()))
        // Nodes of costmaps are in a namespace of their own name.
        if (name != "ros__parameters" && name != "**" && (names.empty() || names.back() != name))
          names.push_back(name);
      if (entry.second.IsMap())
        read_map(entry.second, names, depth + 1);
      else
        add(join(names, "."), entry.first, entry.second);
    }
  }

  void add(const std::string& key, const YAML::Node& at, const YAML::Node& node) {
    RosParameter parameter{key, "", std::nullopt, position(at) + ": " + key, ""};
    parameter.file = path_;
    parameter.line = node.Mark().line;
    parameter.column = node.Mark().column;
    if (node.IsScalar()) parameter.text = node.Scalar();
    if (node.IsSequence()) {
      parameter.items.emplace();
      read_items(node, *parameter.items, 0);
    }
    const auto [known, is_new] = keys_.insert({key, parameters_.size()});
    if (is_new) {
      parameters_.push_back(std::move(parameter));
    } else {
      RosParameter& replaced = parameters_[known->second];
      parameter.replaced_line = replaced.line;
      replaced = std::move(parameter);
    }
  }

  void read_items(const YAML::Node& sequence, std::vector<std::string>& items, int depth) {
    for (const auto& item : sequence) {
      count(item, depth);
      if (item.IsSequence())
        read_items(item, items, depth + 1);
      else
        items.push_back(item.IsScalar() ? item.Scalar() : "");
    }
  }

  std::string path_;
  std::vector<RosParameter>& parameters_;
  std::map<std::string, std::size_t> keys_;  ///< indices of parameters
  std::size_t values_ = 0;
};

std::vector<RosParameter> read_parameters(const std::string& path) {
  const std::string bytes = read_utf8(path, kKind, kMaxConfigSize);
  std::vector<RosParameter> parameters;
  try {
    YamlFlattener(path, parameters).read(YAML::Load(bytes));
  } catch (const YAML::Exception& e) {
    throw file_error(path + ":" + std::to_string(e.mark.line + 1), "is not YAML (" + e.msg + ")",
                     kKind);
  }
  return parameters;
}

/// The class of a controller without its package, as move_base names its section.
bool is_section_of_move_base(const std::string& name) {
  const auto family = from_name<RosFamily>(name);
  return family && *family >= RosFamily::DwaPlanner && *family <= RosFamily::TebPlanner;
}

std::string last_name(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

/// The path up to a name, or "".
std::string path_to(const std::string& path, const std::string& name) {
  std::vector<std::string> names = split(path, '.');
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() || found + 1 == names.end()) return "";
  names.erase(found + 1, names.end());
  return join(names, ".");
}

/// Whether ROS 1 loads it without a section: parameters of move_base, and those of costmaps that
/// the local and the global one have in common.
bool may_lack_section(RosFamily family, const std::string& key) {
  if (family != RosFamily::MoveBase && family != RosFamily::LocalCostmap) return false;
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ||
         (family == RosFamily::LocalCostmap && ends_with(key.substr(0, dot), "layer"));
}

}  // namespace

ParameterFiles ParameterFiles::load(const std::vector<std::string>& paths) {
  ParameterFiles files;
  for (const std::string& path : paths)
    for (RosParameter& parameter : read_parameters(path)) {
      auto& known = files.parameters_;
      known.erase(std::remove_if(known.begin(), known.end(),
                                 [&](const RosParameter& p) { return p.key == parameter.key; }),
                  known.end());
      known.push_back(std::move(parameter));
    }
  return files;
}

std::vector<Controller> ParameterFiles::controllers() const {
  std::vector<Controller> controllers;
  const auto add = [&](const std::string& path, const std::string& kind, const std::string& where) {
    for (const Controller& known : controllers)
      if (known.path == path) return;
    controllers.push_back({last_name(path), path, kind, where});
  };
  std::vector<std::string> listed;
  for (const RosParameter& p : parameters_)
    if (last_name(p.key) == "controller_plugins" && p.items) listed = *p.items;
  for (const RosParameter& p : parameters_) {
    for (const std::string& name : split(p.key, '.'))
      if (is_section_of_move_base(name) && !path_to(p.key, name).empty())
        add(path_to(p.key, name), name, p.where);
    if (!ends_with(p.key, ".plugin") || p.items) continue;
    const std::string path = p.key.substr(0, p.key.size() - std::string(".plugin").size());
    if (contains(listed, last_name(path)) || from_name<RosFamily>(p.text))
      add(path, p.text, p.where);
  }
  return controllers;
}

std::vector<RosParameter> ParameterFiles::below(const std::string& path) const {
  std::vector<RosParameter> found;
  for (const RosParameter& p : parameters_)
    if (starts_with(p.key, path + ".")) {
      found.push_back(p);
      found.back().key = p.key.substr(path.size() + 1);
    }
  return found;
}

std::vector<RosParameter> ParameterFiles::of_node(RosFamily family) const {
  const std::string node = to_string(family);
  std::string path;
  for (const RosParameter& p : parameters_) {
    const std::string candidate = path_to(p.key, node);
    if (!path.empty() && !candidate.empty() && candidate != path)
      throw usage_error(p.where, "there is also " + path, "the parameters of one robot");
    if (!candidate.empty()) path = candidate;
  }
  std::vector<RosParameter> found;
  if (!path.empty()) found = below(path);
  const std::string above = to_string(RosFamily::MoveBase) + std::string(".");
  for (RosParameter p : parameters_) {
    // Costmaps look for their parameters in the namespace of move_base, too.
    if (family == RosFamily::LocalCostmap && starts_with(p.key, above))
      p.key.erase(0, above.size());
    const bool is_given = std::any_of(
        found.begin(), found.end(), [&](const RosParameter& other) { return other.key == p.key; });
    if (may_lack_section(family, p.key) && !is_given && !find_mappings(family, p.key).empty())
      found.push_back(std::move(p));
  }
  return found;
}

}  // namespace slalom::ros
