// SPDX-License-Identifier: BSD-3-Clause
#include "thin_samples.h"

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

/// Slopes of the lines from a sample that pass all later ones within the tolerance of a signal.
struct SlopeRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool contains(double slope) const { return low <= slope && slope <= high; }
  void narrow(double slope, double margin) {
    low = std::max(low, slope - margin);
    high = std::min(high, slope + margin);
  }
};

/// The samples that are kept so far, and which lines may follow the last of them.
class Thinning {
 public:
  Thinning(const std::vector<double>& times, const std::vector<Signal>& signals)
      : times_(times), signals_(signals) {}

  void keep(std::size_t i) {
    if (!samples_.empty() && samples_.back() == i) return;
    samples_.push_back(i);
    ranges_.assign(signals_.size(), {});
  }

  /// Whether the line from the last kept sample to this one passes those between.
  bool reaches(std::size_t i) {
    const std::size_t from = samples_.back();
    const double duration = times_[i] - times_[from];
    if (!(duration > 0)) return false;
    bool passes = true;
    for (std::size_t k = 0; k < signals_.size(); ++k) {
      const Signal& signal = signals_[k];
      const double slope = (signal.values[i] - signal.values[from]) / duration;
      passes = passes && ranges_[k].contains(slope);
      ranges_[k].narrow(slope, signal.tolerance / duration);
    }
    return passes;
  }

  const std::vector<std::size_t>& samples() const { return samples_; }

 private:
  const std::vector<double>& times_;
  const std::vector<Signal>& signals_;
  std::vector<std::size_t> samples_;
  std::vector<SlopeRange> ranges_;
};

}  // namespace

std::vector<std::size_t> thin_samples(const std::vector<double>& times,
                                      const std::vector<Signal>& signals, std::size_t kept) {
  Thinning thinning(times, signals);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i > 0 && !thinning.reaches(i)) {
      thinning.keep(i - 1);
      if (!thinning.reaches(i)) thinning.keep(i);
    }
    if (i == 0 || i == kept || i + 1 == times.size()) thinning.keep(i);
  }
  return thinning.samples();
}

}  // namespace slalom
