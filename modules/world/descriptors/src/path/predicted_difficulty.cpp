// SPDX-License-Identifier: BSD-3-Clause
#include "difficulty_model.h"

#include <slalom/descriptors/descriptor.h>

#include <algorithm>

namespace slalom::descriptors {

Value narrow_fraction(const DescriptorContext& context);
Value detour_ratio(const DescriptorContext& context);

/// Rasch difficulty in logit, predicted from narrow_fraction and detour_ratio; the model is that of
/// discs of 0.25 m in slalom-standard.
Value predicted_difficulty(const DescriptorContext& context) {
  const Value narrow = narrow_fraction(context);
  if (narrow.is_na()) return narrow;
  const Value ratio = detour_ratio(context);
  if (ratio.is_na()) return ratio;
  // Rounding can make P* shorter than the straight line.
  const double detour = std::max(0.0, 1 - 1 / ratio.number());
  return Value::of(kEasiest + kNarrow * narrow.number() / (narrow.number() + kHalfNarrow) +
                   kDetour * detour / (detour + kHalfDetour));
}

}  // namespace slalom::descriptors
