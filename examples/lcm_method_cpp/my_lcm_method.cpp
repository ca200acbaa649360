// An avoidance method as a process of its own: turns to the free direction that is nearest to the
// goal. Needs nothing of Slalom but the descriptions of the messages.
#include <slalom/command_t.hpp>
#include <slalom/error_t.hpp>
#include <slalom/hello_t.hpp>
#include <slalom/observation_t.hpp>
#include <slalom/ready_t.hpp>
#include <slalom/run_start_t.hpp>

#include <lcm/lcm-cpp.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace {

constexpr int kProtocolVersion = 1;

class MyMethod {
 public:
  MyMethod(const std::string& url, const std::string& channel) : channel_(channel), lcm_(url) {
    lcm_.subscribe(channel + "_HELLO", &MyMethod::greet, this);
    lcm_.subscribe(channel + "_RUN_START", &MyMethod::start, this);
    lcm_.subscribe(channel + "_OBSERVATION", &MyMethod::decide, this);
  }

  bool serve() {
    while (lcm_.good() && lcm_.handle() == 0) continue;
    return false;
  }

 private:
  void greet(const lcm::ReceiveBuffer*, const std::string&, const slalom::hello_t* hello) {
    if (hello->protocol_version != kProtocolVersion)
      return refuse(hello->id, "my_lcm_method is made for another version of the protocol");
    robot_ = *hello;
    for (int i = 0; i < hello->setting_count; ++i) {
      if (hello->keys[i] != "look_ahead") return refuse(hello->id, "I only know look_ahead");
      look_ahead_ = std::atof(hello->values[i].c_str());
    }
    ready(hello->id);
  }

  // A method that remembers something forgets it here.
  void start(const lcm::ReceiveBuffer*, const std::string&, const slalom::run_start_t* run) {
    ready(run->run_id);
  }

  void decide(const lcm::ReceiveBuffer*, const std::string&, const slalom::observation_t* o) {
    const double goal = std::atan2(o->goal_y, o->goal_x);
    const double wanted = std::min(look_ahead_, std::hypot(o->goal_x, o->goal_y));
    slalom::command_t command = {};
    command.run_id = o->run_id;
    command.sequence = o->sequence;
    command.w = robot_.max_w / 2;  // nothing is free: look round
    double best = HUGE_VAL;
    for (int i = 0; i < o->rays; ++i) {
      const double direction = robot_.aperture * (i / (o->rays - 1.0) - 0.5);
      if (std::abs(direction - goal) >= best || free_way(*o, direction) < wanted) continue;
      best = std::abs(direction - goal);
      command.w = std::clamp(2 * direction, -robot_.max_w, robot_.max_w);
      command.v =
          std::clamp(free_way(*o, 0) - 0.1, 0.0, robot_.max_v) * std::max(0.0, std::cos(direction));
    }
    lcm_.publish(channel_ + "_COMMAND", &command);
  }

  // How far the robot can go straight in a direction, m.
  double free_way(const slalom::observation_t& o, double direction) const {
    const double half_width = robot_.radius + 0.1;
    double free = robot_.max_range;
    for (int i = 0; i < o.rays; ++i) {
      const double angle = robot_.aperture * (i / (o.rays - 1.0) - 0.5) - direction;
      const bool in_the_way =
          std::cos(angle) > 0 && std::abs(o.ranges[i] * std::sin(angle)) < half_width;
      if (in_the_way) free = std::min(free, o.ranges[i] * std::cos(angle) - robot_.radius);
    }
    return free;
  }

  void ready(int64_t id) {
    slalom::ready_t answer = {};
    answer.protocol_version = kProtocolVersion;
    answer.id = id;
    answer.name = "my_lcm_method";
    lcm_.publish(channel_ + "_READY", &answer);
  }

  void refuse(int64_t id, const std::string& why) {
    slalom::error_t error = {};
    error.id = id;
    error.text = why;
    lcm_.publish(channel_ + "_ERROR", &error);
  }

  std::string channel_;
  lcm::LCM lcm_;
  slalom::hello_t robot_ = {};
  double look_ahead_ = 1.0;  // m
};

std::string variable(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

}  // namespace

int main() {
  MyMethod method(variable("SLALOM_LCM_URL", "udpm://239.255.76.67:7667?ttl=0"),
                  variable("SLALOM_LCM_CHANNEL", "SLALOM"));
  return method.serve() ? 0 : 1;
}
