#pragma once

#include <string>
#include <vector>

namespace slalom {

/// Time, state and speed of a replay. Times in s from the first sample.
class ReplayClock {
 public:
  double time() const { return time_; }
  double duration() const { return duration_; }
  bool playing() const { return playing_; }
  double speed() const { return speeds()[speed_]; }  ///< simulated s per s of real time
  static const std::vector<double>& speeds();
  std::string speed_text() const;  ///< "0.5x"

  /// Negative and non-finite durations count as 0. The time is clamped; at the old end it moves to
  /// the new end.
  void set_duration(double duration);
  void seek(double time);  ///< clamped to [0, duration]; NaN is the start
  void play();             ///< from the start if at the end; ignored if the duration is 0
  void pause() { playing_ = false; }
  void toggle() { playing_ ? pause() : play(); }
  void faster();
  void slower();
  /// Advances by seconds of real time; pauses at the end. Returns whether `time` changed.
  bool advance(double seconds);
  /// Advances to `now` (s, of any steady clock); called for every frame.
  void tick(double now);

 private:
  double time_ = 0, duration_ = 0;
  bool playing_ = false;
  std::size_t speed_ = 2;  ///< 1x
  double last_tick_ = -1;  ///< `now` of the last tick(); negative if the replay was paused
};

}  // namespace slalom
