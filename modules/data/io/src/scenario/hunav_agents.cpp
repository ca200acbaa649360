// SPDX-License-Identifier: BSD-3-Clause
#include "hunav_agents.h"
#include "yaml_reader.h"

#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr const char* kRoot = "hunav_loader:";
constexpr std::size_t kMaxWaypoints = 1'000'000;  ///< agents may share goals

/// The values of one agent or pose.
class AgentReader : public YamlReader {
 public:
  using YamlReader::YamlReader;

  YamlReader part(const std::string& key) const { return {required(key), where()}; }
  TPoint2D position(const std::string& key) const {
    const YamlReader pose = part(key);
    return {pose.number(pose.required("x")), pose.number(pose.required("y"))};
  }
  double positive(const std::string& key) const {
    const double value = number(required(key));
    expect(value > 0, required(key), key + " is " + format_number(value), "above 0");
    return value;
  }
  bool is_true(const std::string& key) const {
    const YAML::Node node = root()[key];
    return node && node.IsScalar() && lower_case(node.Scalar()) == "true";
  }
  std::vector<std::string> names(const std::string& key) const {
    std::vector<std::string> names;
    for (const YAML::Node& item : sequence(key)) names.push_back(item.as<std::string>());
    return names;
  }
};

Mover mover_of(const std::string& name, const AgentReader& agent) {
  Mover mover{name, agent.positive("radius"), {}, MoverEnd::Stop};
  const TPoint2D begin = agent.position("init_pose");
  mover.waypoints = {{0, begin}};
  const auto go_to = [&](const TPoint2D& next) {
    if (next != mover.waypoints.back().position) mover.waypoints.push_back({0, next});
  };
  for (const std::string& goal : agent.names("goals")) go_to(agent.position(goal));
  if (mover.waypoints.size() == 1) return mover;
  if (agent.is_true("cyclic_goals")) {
    go_to(begin);
    mover.after = MoverEnd::Loop;
  }
  set_speed(mover, agent.positive("max_vel"));
  return mover;
}

}  // namespace

bool is_hunav(const std::string& text) {
  return starts_with(text, kRoot) || text.find(std::string("\n") + kRoot) != std::string::npos;
}

Movers hunav_agents(const std::string& text, const std::string& where) {
  expect_utf8(text, where, "agents of HuNavSim");
  try {
    const AgentReader file(YAML::Load(text), where);
    const AgentReader root(file.part("hunav_loader").required("ros__parameters"), where);
    Movers movers;
    std::size_t waypoints = 0;
    for (const std::string& name : root.names("agents")) {
      movers.push_back(mover_of(name, {root.required(name), where}));
      waypoints += movers.back().waypoints.size();
      if (waypoints > kMaxWaypoints) throw file_error(where, "too many goals", "at most a million");
    }
    if (movers.empty()) throw file_error(where, "has no agents", "an agents.yaml of HuNavSim");
    check_movers(where, movers);
    return movers;
  } catch (const YAML::Exception& e) {
    throw file_error(where + ":" + std::to_string(e.mark.line + 1), e.msg,
                     "an agents.yaml of HuNavSim");
  }
}

}  // namespace slalom
