#pragma once

#include <string>
#include <vector>

namespace slalom {

/// Where a replay is, and whether and how fast it goes on. Times in s from the first instant.
class ReplayClock {
 public:
  double time() const { return time_; }
  double duration() const { return duration_; }
  bool playing() const { return playing_; }
  double speed() const { return speeds()[speed_]; }  ///< simulated s per s
  static const std::vector<double>& speeds();
  std::string speed_text() const;  ///< "0.5x"

  /// Negative and not finite ones count as 0. The time stays within it; at the old end it goes to
  /// the new one.
  void set_duration(double duration);
  void seek(double time);  ///< to the nearest time there is; NaN is the start
  void play();             ///< at the end from the start again; nothing when there is no duration
  void pause() { playing_ = false; }
  void toggle() { playing_ ? pause() : play(); }
  void faster();
  void slower();
  /// So many seconds of real time have passed; pauses at the end. Returns whether `time` changed.
  bool advance(double seconds);

 private:
  double time_ = 0, duration_ = 0;
  bool playing_ = false;
  std::size_t speed_ = 2;  ///< 1x
};

}  // namespace slalom
