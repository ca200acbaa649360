// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/contrast.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kConfidence = 0.95;

QuantityInfo quantity_named(const std::string& name) {
  return {name, 1, name, "m", Direction::None};
}

/// `n` pairs whose differences are offset + 0.01 i.
MatchedValues shifted(const std::string& name, int n, double offset) {
  MatchedValues values{quantity_named(name), {}, {}};
  for (int i = 0; i < n; ++i) {
    values.reference.push_back(0.1 * i);
    values.group.push_back(0.1 * i + offset + 0.01 * i);
  }
  return values;
}

TEST(Contrast, OfPairsThatAllDifferInOneDirectionHolds) {
  const auto contrasts = contrast_matched({shifted("depth", 12, 1)}, kConfidence);
  ASSERT_EQ(contrasts.size(), 1u);
  const Contrast& contrast = contrasts[0];
  EXPECT_TRUE(contrast.holds);
  EXPECT_EQ(contrast.higher, 12u);
  EXPECT_NEAR(contrast.p, 2.0 / 4096, 1e-12) << "one of 2^12 signs in each tail";
  // Differences 1, 1.01, ..., 1.11: the median of all pairwise means is that of the values.
  EXPECT_NEAR(contrast.difference.estimate, 1.055, 1e-12);
  // 0, 0.1, ..., 1.1: quartiles at ranks 2.75 and 8.25 (from 0).
  EXPECT_NEAR(contrast.reference.low, 0.275, 1e-12);
  EXPECT_NEAR(contrast.reference.high, 0.825, 1e-12);
}

TEST(Contrast, OfAFamilyIsCorrectedByHolmAndSortedByWhatHolds) {
  // p = 2^-11 of the second; the first and the third do not differ: their signs alternate.
  MatchedValues noise = shifted("noise", 12, 0);
  for (std::size_t i = 0; i < noise.group.size(); ++i)
    noise.group[i] = noise.reference[i] + (i % 2 == 0 ? 1 : -1) * (0.1 + 0.01 * double(i));
  MatchedValues other = noise;
  other.quantity = quantity_named("other");
  const auto contrasts = contrast_matched({noise, shifted("depth", 12, 1), other}, kConfidence);
  ASSERT_EQ(contrasts.size(), 3u);
  EXPECT_EQ(contrasts[0].quantity.id, "depth");
  EXPECT_NEAR(contrasts[0].adjusted_p, 3 * 2.0 / 4096, 1e-12);
  EXPECT_EQ(contrasts[1].quantity.id, "noise");
  EXPECT_FALSE(contrasts[1].holds);
  EXPECT_EQ(contrasts[2].quantity.id, "other");
}

TEST(Contrast, OfFewPairsDoesNotHold) {
  EXPECT_FALSE(contrast_matched({shifted("depth", 5, 1)}, kConfidence)[0].holds) << "p = 1/16";
  EXPECT_TRUE(contrast_matched({shifted("depth", 6, 1)}, kConfidence)[0].holds) << "p = 1/32";
  EXPECT_EQ(min_pairs_to_hold(1, kConfidence), 6u);
  // 40 * 2^(1 - n) <= 0.05 is n >= 1 + log2(800) = 10.6.
  EXPECT_EQ(min_pairs_to_hold(40, kConfidence), 11u);
}

TEST(Contrast, WithoutPairsIsLeftOut) {
  EXPECT_TRUE(contrast_matched({{quantity_named("none"), {}, {}}}, kConfidence).empty());
}

TEST(Contrast, SaysTheQuantityItsRangesAndTheIntervalInASentence) {
  const Contrast contrast = contrast_matched({shifted("Depth", 12, -2)}, kConfidence)[0];
  const std::string text = contrast_sentence(contrast, "neighbors");
  EXPECT_EQ(
      text.find("12 of 12 have a lower Depth than their neighbors: -1.7 to -1.09 m, neighbors "
                "0.275 to 0.825 m (quartiles); difference -1.9"),
      0u)
      << text;
  EXPECT_NE(text.find("] m, p = 0.0005"), std::string::npos) << text;
}

RC_GTEST_PROP(Contrast, DoesNotDependOnTheOrderOfPairs, ()) {
  MatchedValues values{quantity_named("x"), {}, {}};
  const auto n = *rc::gen::inRange(1, 30);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < n; ++i)
    pairs.emplace_back(*rc::gen::inRange(-20, 20), *rc::gen::inRange(-20, 20));
  const auto contrast_in_order = [&] {
    values.group.clear();
    values.reference.clear();
    for (const auto& [a, b] : pairs) {
      values.group.push_back(a);
      values.reference.push_back(b);
    }
    return contrast_matched({values}, kConfidence)[0];
  };
  const Contrast given = contrast_in_order();
  std::sort(pairs.begin(), pairs.end());
  const Contrast sorted = contrast_in_order();
  RC_ASSERT(given.higher == sorted.higher && given.lower == sorted.lower);
  RC_ASSERT(given.p == sorted.p);
  RC_ASSERT(given.holds == sorted.holds);
  RC_ASSERT(given.difference.estimate == sorted.difference.estimate);
}

/// Ranges exchange with the groups, and the difference changes its sign.
RC_GTEST_PROP(Contrast, IsAntisymmetric, ()) {
  MatchedValues values{quantity_named("x"), {}, {}};
  for (int i = 0; i < 12; ++i) {
    values.group.push_back(*rc::gen::inRange(-20, 20));
    values.reference.push_back(*rc::gen::inRange(-20, 20));
  }
  const Contrast one = contrast_matched({values}, kConfidence)[0];
  std::swap(values.group, values.reference);
  const Contrast other = contrast_matched({values}, kConfidence)[0];
  RC_ASSERT(one.higher == other.lower);
  RC_ASSERT(one.difference.estimate == -other.difference.estimate);
  RC_ASSERT(one.group.low == other.reference.low);
  RC_ASSERT(one.p == other.p);
}

}  // namespace
}  // namespace slalom
