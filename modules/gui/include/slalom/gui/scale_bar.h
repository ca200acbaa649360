#pragma once

#include <string>

namespace slalom {

/// A line of a round length that tells how large the world is drawn.
struct ScaleBar {
  double metres = 0;
  double pixels = 0;

  /// The longest of 1, 2 or 5 times a power of ten (m) that is at most `longest` pixels.
  static ScaleBar choose(double pixels_per_metre, double longest);
  std::string text() const;  ///< "20 cm", "5 m", "2 km"
};

}  // namespace slalom
