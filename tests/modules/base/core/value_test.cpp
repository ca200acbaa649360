// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/value.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Value, ANumberThatIsNotFiniteIsNotAvailable) {
  EXPECT_TRUE(Value::of(NAN).is_na());
  EXPECT_TRUE(Value::of(INFINITY).is_na());
  EXPECT_EQ(Value::of(NAN).reason(), "not a finite number");
}

TEST(Value, KeepsNumberAndStandardError) {
  const Value value = Value::of(0.4, 0.01);
  EXPECT_EQ(value.number(), 0.4);
  EXPECT_EQ(value.standard_error(), 0.01);
  EXPECT_FALSE(Value::of(0.4).standard_error().has_value());
}

TEST(Value, NumberOfNaThrowsLogicError) {
  EXPECT_THROW(Value::na("outcome: collision").number(), std::logic_error);
}

TEST(Value, TextsHaveTheUnitOrTheReason) {
  EXPECT_EQ(format_value(Value::of(2.5, 0.1), "m"), "2.5 m");
  EXPECT_EQ(format_value(Value::of(0.68), "-"), "0.68");
  EXPECT_EQ(format_value(Value::na("outcome: stuck"), "m"), "NA (outcome: stuck)");
}

}  // namespace
}  // namespace slalom
