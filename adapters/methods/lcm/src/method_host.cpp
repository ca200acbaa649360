// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/lcm/method_host.h>

#include <lcm/lcm-cpp.hpp>

#include <algorithm>

namespace slalom {
namespace {

constexpr int kPollPeriod = 100;  // ms between checks whether to stop

/// A host on LCM channels.
class Server {
 public:
  Server(MethodHost& host, const std::string& url, const std::string& channel)
      : host_(host), channels_(channel), lcm_(url) {
    const bool good =
        can_receive(lcm_) && lcm_.subscribeFunction(channels_.hello, receive<hello_t>, this) &&
        lcm_.subscribeFunction(channels_.goal_heading, receive<goal_heading_t>, this) &&
        lcm_.subscribeFunction(channels_.run_start, receive<run_start_t>, this) &&
        lcm_.subscribeFunction(channels_.observation, receive<observation_t>, this);
    if (!good) throw job_error(url, "LCM cannot be used with this URL");
  }

  bool handle() { return lcm_.handleTimeout(kPollPeriod) >= 0; }

 private:
  template <typename Message>
  static void receive(const lcm::ReceiveBuffer* buffer, const std::string&, Server* server) {
    static thread_local Message message;  // reuses the memory of the ranges
    if (decode_message(buffer->data, buffer->data_size, message)) server->handle_message(message);
  }

  template <typename Message>
  void handle_message(const Message& message) {
    try {
      reply(message);
    } catch (const std::exception& failure) {
      error_t error = {};
      error.id = id_of(message);
      error.text = reason_of(failure);
      publish(channels_.error, error);
    }
  }

  void reply(const hello_t& hello) { publish(channels_.ready, host_.handle_hello(hello)); }
  void reply(const goal_heading_t& message) { host_.handle_goal_heading(message); }
  void reply(const run_start_t& message) {
    publish(channels_.ready, host_.handle_run_start(message));
  }
  void reply(const observation_t& message) {
    if (const auto command = host_.handle_observation(message))
      publish(channels_.command, *command);
  }

  static std::int64_t id_of(const hello_t& hello) { return hello.id; }
  template <typename Message>
  static std::int64_t id_of(const Message& message) {
    return message.run_id;
  }

  template <typename Message>
  void publish(const std::string& channel, const Message& message) {
    lcm_.publish(channel, &message);
  }

  MethodHost& host_;
  LcmChannels channels_;
  lcm::LCM lcm_;
};

}  // namespace

MethodHost::MethodHost(std::string name, Factory factory)
    : name_(std::move(name)), factory_(std::move(factory)) {}

ready_t MethodHost::ready(std::int64_t id) const {
  ready_t answer = {};
  answer.protocol_version = kLcmProtocolVersion;
  answer.id = id;
  answer.name = name_;
  return answer;
}

ready_t MethodHost::handle_hello(const hello_t& hello) {
  if (hello.protocol_version != kLcmProtocolVersion)
    throw MethodError("the simulator uses protocol version " +
                      std::to_string(hello.protocol_version) + "; expected version " +
                      std::to_string(kLcmProtocolVersion));
  if (method_ && hello.id == hello_id_) return ready(hello.id);
  method_.reset();
  sensor_ = sensor_of(hello);
  method_ = factory_(hello);
  hello_id_ = hello.id;
  return ready(hello.id);
}

ready_t MethodHost::handle_run_start(const run_start_t& message) {
  if (!method_) throw MethodError("run_start_t received before hello_t");
  next_sequence_ = -1;
  NavigationTask task = task_of(message);
  if (goal_heading_.run_id == message.run_id) {
    task.goal_heading = goal_heading_.heading;
    task.goal_heading_tolerance = goal_heading_.tolerance;
  }
  method_->reset(task);
  run_id_ = message.run_id;
  next_sequence_ = 0;
  return ready(message.run_id);
}

std::optional<command_t> MethodHost::handle_observation(const observation_t& message) {
  if (message.run_id != run_id_ || message.sequence != next_sequence_) return std::nullopt;
  ++next_sequence_;
  const Observation observation = observation_of(message, sensor_, scan_);
  if (message.sequence == 0) method_->settle(observation);
  const Command command = method_->step(observation);
  command_t answer = {};
  answer.run_id = message.run_id;
  answer.sequence = message.sequence;
  answer.v = command.v;
  answer.w = command.w;
  answer.vy = command.vy;
  return answer;
}

void serve_method(MethodHost& host, const std::string& url, const std::string& channel,
                  const std::function<bool()>& stop) {
  Server server(host, url, channel);
  while (!stop())
    if (!server.handle() && !stop()) throw job_error(url, "LCM has stopped working");
}

}  // namespace slalom
