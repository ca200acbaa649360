// SPDX-License-Identifier: BSD-3-Clause
#include "method_link.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace slalom {
namespace {

constexpr double kMaxPoll = 0.01;  // s, maximum duration of one poll
/// Messages of a channel that wait to be handled; LCM drops further ones. By default it keeps 30,
/// so that a reply behind invalid messages would be lost.
constexpr int kMaxWaiting = 100000;

/// A number that is none equals itself.
bool are_equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool are_equal(const command_t& a, const command_t& b) {
  return are_equal(a.v, b.v) && are_equal(a.w, b.w) && are_equal(a.vy, b.vy);
}

}  // namespace

MethodLink::MethodLink(const std::string& url, const std::string& prefix)
    : channels_(prefix), lcm_(url) {
  if (!can_receive(lcm_)) return;
  // Static functions, because GCC 12 with -fsanitize miscompiles LCM's calls of member functions.
  using Link = MethodLink;
  lcm::Subscription* const subscriptions[] = {
      lcm_.subscribeFunction(channels_.ready, receive<ready_t, &Link::on_ready>, this),
      lcm_.subscribeFunction(channels_.command, receive<command_t, &Link::on_command>, this),
      lcm_.subscribeFunction(channels_.error, receive<error_t, &Link::on_error>, this)};
  good_ = true;
  for (lcm::Subscription* subscription : subscriptions)
    good_ = good_ && subscription != nullptr && subscription->setQueueCapacity(kMaxWaiting) == 0;
}

void MethodLink::expect_replies_to(std::int64_t id) {
  id_ = id;
  sent_ = -1;
  ready_.reset();
  command_.reset();
  commands_.clear();
  conflict_ = false;
  error_.reset();
  undecodable_ = 0;
}

void MethodLink::send(const hello_t& hello) {
  publish(channels_.hello, hello);
}

void MethodLink::send(const goal_heading_t& message) {
  publish(channels_.goal_heading, message);
}

void MethodLink::send(const run_start_t& message) {
  publish(channels_.run_start, message);
}

void MethodLink::send(const run_end_t& message) {
  publish(channels_.run_end, message);
}

void MethodLink::send(const observation_t& message) {
  sent_ = message.sequence;
  publish(channels_.observation, message);
}

bool MethodLink::wait(double seconds) {
  if (seconds <= 0) return handle(0);
  const int milliseconds = static_cast<int>(std::min(seconds, kMaxPoll) * 1000);
  if (milliseconds > 0) return handle(milliseconds);  // the resolution of LCM's timeouts
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  return handle(0);
}

bool MethodLink::handle(int milliseconds) {
  return lcm_.handleTimeout(milliseconds) > 0;
}

template <typename Message>
void MethodLink::publish(const std::string& channel, const Message& message) {
  bytes_.resize(static_cast<std::size_t>(message.getEncodedSize()));
  const int size = message.encode(bytes_.data(), 0, static_cast<int>(bytes_.size()));
  // A message that LCM cannot send gets no reply, so the run ends with a timeout.
  lcm_.publish(channel, bytes_.data(), static_cast<unsigned>(std::max(size, 0)));
}

template <typename Message, void (MethodLink::*take)(const Message&)>
void MethodLink::receive(const lcm::ReceiveBuffer* buffer, const std::string&, MethodLink* link) {
  Message message;
  if (decode_message(buffer->data, buffer->data_size, message))
    (link->*take)(message);
  else
    ++link->undecodable_;
}

void MethodLink::on_ready(const ready_t& message) {
  if (message.id == id_ && !ready_) ready_ = message;
}

void MethodLink::on_command(const command_t& message) {
  constexpr std::size_t kKept = 100;
  if (message.run_id != id_ || message.sequence < 0 || message.sequence > sent_) return;
  const auto [known, is_new] = commands_.try_emplace(message.sequence, message);
  if (!is_new && !are_equal(known->second, message)) conflict_ = true;
  if (!command_ || message.sequence > command_->sequence) command_ = message;
  if (commands_.size() > kKept) commands_.erase(commands_.begin());
}

void MethodLink::on_error(const error_t& message) {
  if (message.id == id_ && !error_) error_ = message;
}

}  // namespace slalom
