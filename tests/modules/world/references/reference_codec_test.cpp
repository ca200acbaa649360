// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/references/reference_codec.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

References both() {
  References references;
  references.shortest = ShortestPath{{{0, 0}, {3, 4}}, 5, {4.9, 5}, "BITstar", "note", 5.1, 5.2};
  references.safest = SafestPath{{{0, 0}, {1, 1}, {3, 4}}, 0.4, "exact", ""};
  return references;
}

TEST(ReferenceCodec, RestoresBothPathsOrTheReasons) {
  const References restored = references_from_bytes(to_bytes(both()), "test");
  ASSERT_TRUE(restored.shortest && restored.safest);
  EXPECT_EQ(restored.shortest->path, both().shortest->path);
  EXPECT_EQ(restored.shortest->certificate.lower_bound, 4.9);
  EXPECT_EQ(restored.shortest->certificate.upper_bound, 5);
  EXPECT_EQ(restored.shortest->exact_length, 5.1);
  EXPECT_EQ(restored.shortest->planner_length, 5.2);
  EXPECT_EQ(restored.safest->path.size(), 3u);
  EXPECT_EQ(restored.safest->bottleneck, 0.4);
  References none;
  none.shortest_reason = "no path";
  none.safest_reason = "start is not free";
  EXPECT_EQ(references_from_bytes(to_bytes(none), "test").safest_reason, "start is not free");
}

TEST(ReferenceCodec, KeepsTheFormatOfResultFiles) {
  References none;
  none.shortest_reason = "ab";
  const std::string expected("\3\2\0\0\0\0\0\0\0ab\0\0\0\0\0\0\0\0\0\0", 21);
  EXPECT_EQ(to_bytes(none), expected);  // version, two texts, neither path
}

References with_arrival() {
  References references = both();
  references.arrival = EarliestArrival{{7, 8.5}, {{0, {0, 0}}, {3, {0, 0}}, {8.5, {3, 4}}}};
  return references;
}

TEST(ReferenceCodec, RestoresTheEarliestArrivalOrTheReason) {
  const References restored = references_from_bytes(to_bytes(with_arrival()), "test");
  ASSERT_TRUE(restored.arrival.has_value());
  EXPECT_EQ(restored.arrival->certificate.lower_bound, 7);
  EXPECT_EQ(restored.arrival->certificate.upper_bound, 8.5);
  ASSERT_EQ(restored.arrival->plan.size(), 3U);
  EXPECT_EQ(restored.arrival->plan[2].t, 8.5);
  EXPECT_EQ(restored.arrival->plan[2].position.y, 4);
  EXPECT_EQ(restored.safest->bottleneck, 0.4);
  EXPECT_EQ(restored.unsolvable_reason(), "");
  References none = both();
  none.arrival_reason = "no arrival";
  EXPECT_EQ(references_from_bytes(to_bytes(none), "test").unsolvable_reason(), "no arrival");
}

TEST(ReferenceCodec, RejectsDamagedBytes) {
  const std::string bytes = to_bytes(with_arrival());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(references_from_bytes(bytes.substr(0, size), "test"), Error) << size;
  EXPECT_THROW(references_from_bytes(bytes + 'x', "test"), Error);
}

}  // namespace
}  // namespace slalom
