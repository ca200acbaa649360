#include <slalom/gui/scale_bar.h>

#include <cmath>
#include <cstdio>

namespace slalom {

ScaleBar ScaleBar::choose(double pixels_per_metre, double longest) {
  const double most = longest / pixels_per_metre;
  // 1e-9: a length that fits exactly is not left out by rounding.
  const double power = std::pow(10.0, std::floor(std::log10(most) + 1e-9));
  double metres = power;
  for (const double step : {2.0, 5.0})
    if (step * power <= most * (1 + 1e-9)) metres = step * power;
  return {metres, metres * pixels_per_metre};
}

std::string ScaleBar::text() const {
  const double factor = metres >= 1000 ? 0.001 : metres >= 1 ? 1 : metres >= 0.01 ? 100 : 1000;
  const char* unit = metres >= 1000 ? "km" : metres >= 1 ? "m" : metres >= 0.01 ? "cm" : "mm";
  char text[48];
  std::snprintf(text, sizeof text, "%g %s", metres * factor, unit);
  return text;
}

}  // namespace slalom
