// An avoidance method as a separate process: turns to the free direction closest to the goal. From
// Slalom it requires only the message definitions.
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
    lcm_.subscribe(channel + "_HELLO", &MyMethod::handle_hello, this);
    lcm_.subscribe(channel + "_RUN_START", &MyMethod::handle_run_start, this);
    lcm_.subscribe(channel + "_OBSERVATION", &MyMethod::handle_observation, this);
  }

  bool serve() {
    while (lcm_.good() && lcm_.handle() == 0) continue;
    return false;
  }

 private:
  void handle_hello(const lcm::ReceiveBuffer*, const std::string&, const slalom::hello_t* hello) {
    if (hello->protocol_version != kProtocolVersion)
      return refuse(hello->id, "my_lcm_method requires another protocol version");
    robot_ = *hello;
    for (int i = 0; i < hello->setting_count; ++i) {
      if (hello->keys[i] != "look_ahead")
        return refuse(hello->id, "unknown setting; expected look_ahead");
      look_ahead_ = std::atof(hello->values[i].c_str());
    }
    ready(hello->id);
  }

  // A method with state must clear it here.
  void handle_run_start(const lcm::ReceiveBuffer*, const std::string&,
                        const slalom::run_start_t* run) {
    ready(run->run_id);
  }

  void handle_observation(const lcm::ReceiveBuffer*, const std::string&,
                          const slalom::observation_t* o) {
    const double goal = std::atan2(o->goal_y, o->goal_x);
    const double desired_distance = std::min(look_ahead_, std::hypot(o->goal_x, o->goal_y));
    slalom::command_t command = {};
    command.run_id = o->run_id;
    command.sequence = o->sequence;
    command.w = robot_.max_w / 2;  // no free direction: rotate
    double best = HUGE_VAL;
    for (int i = 0; i < o->rays; ++i) {
      const double direction = robot_.aperture * (i / (o->rays - 1.0) - 0.5);
      if (std::abs(direction - goal) >= best || free_distance(*o, direction) < desired_distance)
        continue;
      best = std::abs(direction - goal);
      command.w = std::clamp(2 * direction, -robot_.max_w, robot_.max_w);
      command.v = std::clamp(free_distance(*o, 0) - 0.1, 0.0, robot_.max_v) *
                  std::max(0.0, std::cos(direction));
    }
    lcm_.publish(channel_ + "_COMMAND", &command);
  }

  // Free distance of the robot straight in a direction, m.
  double free_distance(const slalom::observation_t& o, double direction) const {
    const double half_width = robot_.radius + 0.1;
    double free = robot_.max_range;
    for (int i = 0; i < o.rays; ++i) {
      const double angle = robot_.aperture * (i / (o.rays - 1.0) - 0.5) - direction;
      const bool in_corridor =
          std::cos(angle) > 0 && std::abs(o.ranges[i] * std::sin(angle)) < half_width;
      if (in_corridor) free = std::min(free, o.ranges[i] * std::cos(angle) - robot_.radius);
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

  void refuse(int64_t id, const std::string& reason) {
    slalom::error_t error = {};
    error.id = id;
    error.text = reason;
    lcm_.publish(channel_ + "_ERROR", &error);
  }

  std::string channel_;
  lcm::LCM lcm_;
  slalom::hello_t robot_ = {};
  double look_ahead_ = 1.0;  // m
};

std::string environment_variable(const char* name, const char* default_value) {
  const char* value = std::getenv(name);
  return value == nullptr ? default_value : value;
}

}  // namespace

int main() {
  MyMethod method(environment_variable("SLALOM_LCM_URL", "udpm://239.255.76.67:7667?ttl=0"),
                  environment_variable("SLALOM_LCM_CHANNEL", "SLALOM"));
  return method.serve() ? 0 : 1;
}
