// SPDX-License-Identifier: BSD-3-Clause
// An external method with one fault: faulty_process FAULT. It commands 0.5 m/s straight ahead. The
// fault occurs at the fourth observation of runs with seed 13; all other runs are normal.
#include <slalom/lcm/protocol.h>

#include <lcm/lcm-cpp.hpp>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <unistd.h>

namespace slalom {
namespace {

constexpr double kSpeed = 0.5;  // m/s
constexpr std::int64_t kFaultySeed = 13, kFaultyCycle = 3;

class Process {
 public:
  Process(std::string fault, const std::string& url, const std::string& channel)
      : fault_(std::move(fault)), channels_(channel), lcm_(url) {
    lcm_.subscribeFunction(channels_.hello, receive<hello_t>, this);
    lcm_.subscribeFunction(channels_.run_start, receive<run_start_t>, this);
    lcm_.subscribeFunction(channels_.observation, receive<observation_t>, this);
  }

  void serve() {
    while (lcm_.handle() == 0) continue;
  }

 private:
  template <typename Message>
  static void receive(const lcm::ReceiveBuffer*, const std::string&, const Message* message,
                      Process* process) {
    process->handle(message);
  }

  void handle(const hello_t* hello) {
    if (fault_ == "refuses") return refuse(hello->id);
    if (fault_ == "ends_at_hello") std::_Exit(3);
    if (fault_ != "silent_at_hello") ready(hello->id);
  }

  void handle(const run_start_t* message) {
    faulty_run_ = message->seed == kFaultySeed;
    if (faulty_run_ && fault_ == "ends_at_start") std::_Exit(4);
    ready(message->run_id);
  }

  void handle(const observation_t* message) {
    // Sent before a reply, so that it is received before that reply.
    if (faulty_run_ && fault_ == "garbled_before" && message->sequence == kFaultyCycle - 1)
      send_garbage();
    if (!faulty_run_ || message->sequence != kFaultyCycle)
      answer(message->run_id, message->sequence, kSpeed);
    else
      misbehave(message->run_id, message->sequence);
  }

  void misbehave(std::int64_t run, std::int64_t sequence) {
    if (fault_ == "killed") raise(SIGKILL);
    if (fault_ == "exits") std::_Exit(5);
    if (fault_ == "hung") hang();
    if (fault_ == "silent" || fault_ == "garbled_before") return;
    if (fault_ == "wrong_sequence") return answer(run, sequence + 1, kSpeed);
    if (fault_ == "wrong_run") return answer(run + 1, sequence, kSpeed);
    if (fault_ == "error") return refuse(run);
    if (fault_ == "nan") return answer(run, sequence, std::numeric_limits<double>::quiet_NaN());
    if (fault_ == "garbled") send_garbage();
    // Fills the socket's buffer: more than LCM would keep.
    for (int i = 0; fault_ == "flooded" && i < 40; ++i) send_garbage();
    if (fault_ == "late") answer(run, sequence - 1, 0.1);
    if (fault_ == "slow") usleep(1600 * 1000);
    if (fault_ == "chatty") std::cout << "output" << std::endl;
    answer(run, sequence, kSpeed);
    if (fault_ == "duplicate") answer(run, sequence, 0.1);
    if (fault_ == "repeated") answer(run, sequence, kSpeed);
  }

  [[noreturn]] static void hang() {
    std::signal(SIGTERM, SIG_IGN);
    while (true) pause();
  }

  void ready(std::int64_t id) {
    ready_t message = {};
    message.protocol_version = fault_ == "other_version" ? 8 : kLcmProtocolVersion;
    message.id = id;
    message.name = "faulty";
    lcm_.publish(channels_.ready, &message);
  }

  void refuse(std::int64_t id) {
    error_t message = {};
    message.id = id;
    message.text = "unsupported robot";
    lcm_.publish(channels_.error, &message);
  }

  void answer(std::int64_t run, std::int64_t sequence, double v) {
    command_t message = {};
    message.run_id = run;
    message.sequence = sequence;
    message.v = v;
    lcm_.publish(channels_.command, &message);
  }

  /// Sends noise, an empty message, a truncated command, and an error text of negative length.
  void send_garbage() {
    lcm_.publish(channels_.command, "not a message", 13);
    lcm_.publish(channels_.command, "", 0);
    command_t command = {};
    unsigned char bytes[64];
    command.encode(bytes, 0, sizeof bytes);
    lcm_.publish(channels_.command, bytes, static_cast<unsigned>(command.getEncodedSize() - 1));
    error_t error = {};
    const int size = error.encode(bytes, 0, sizeof bytes);
    for (int i = size - 5; i < size - 1; ++i) bytes[i] = 0xFF;
    lcm_.publish(channels_.error, bytes, static_cast<unsigned>(size));
  }

  std::string fault_;
  LcmChannels channels_;
  lcm::LCM lcm_;
  bool faulty_run_ = false;
};

}  // namespace
}  // namespace slalom

int main(int, char** argv) {
  slalom::Process(argv[1], std::getenv("SLALOM_LCM_URL"), std::getenv("SLALOM_LCM_CHANNEL"))
      .serve();
}
