#include <slalom/studio/replay_clock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace slalom {

const std::vector<double>& ReplayClock::speeds() {
  static const std::vector<double> speeds = {0.25, 0.5, 1, 2, 4, 8, 16};
  return speeds;
}

std::string ReplayClock::speed_text() const {
  char text[16];
  std::snprintf(text, sizeof text, "%gx", speed());
  return text;
}

void ReplayClock::set_duration(double duration) {
  const bool at_end = time_ >= duration_;
  duration_ = std::isfinite(duration) ? std::max(duration, 0.0) : 0;
  time_ = at_end ? duration_ : std::min(time_, duration_);
  if (time_ >= duration_) playing_ = false;
}

void ReplayClock::seek(double time) {
  time_ = std::isnan(time) ? 0 : std::clamp(time, 0.0, duration_);
}

void ReplayClock::play() {
  if (duration_ <= 0) return;
  if (time_ >= duration_) time_ = 0;
  playing_ = true;
}

void ReplayClock::faster() {
  if (speed_ + 1 < speeds().size()) ++speed_;
}

void ReplayClock::slower() {
  if (speed_ > 0) --speed_;
}

bool ReplayClock::advance(double seconds) {
  if (!playing_ || !(seconds > 0)) return false;
  const double before = time_;
  seek(time_ + seconds * speed());
  if (time_ >= duration_) pause();
  return time_ != before;
}

void ReplayClock::tick(double now) {
  if (last_tick_ >= 0) advance(now - last_tick_);
  last_tick_ = playing_ ? now : -1;
}

}  // namespace slalom
