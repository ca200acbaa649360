// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <slalom/core/hash.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

struct Symmetry {
  int quarter_turns = 0;
  bool is_mirrored = false, is_reversed = false;

  TPoint2D operator()(TPoint2D p) const {
    if (is_mirrored) p.y = -p.y;
    for (int i = 0; i < quarter_turns; ++i) p = {-p.y, p.x};
    return p;
  }
};

/// Cells of an eighth of a meter around the origin: their coordinates are exact.
World transformed_world(const Symmetry& change) {
  std::vector<Polygon> polygons = {rectangle(-1, -1, 1, 1), rectangle(1, 0.5, 2.5, 1),
                                   rectangle(-3, -2.5, -1.5, -2), rectangle(2.5, -3, 3, -1)};
  for (Polygon& polygon : polygons)
    for (TPoint2D& vertex : polygon.vertices) vertex = change(vertex);
  return world_with({-4.5, -4.5, 4.5, 4.5}, polygons, 0.125);
}

std::vector<TPoint2D> places(const Symmetry& change, PeopleModel model, bool robot) {
  RandomEngine random(5);
  const World base = transformed_world({}), world = transformed_world(change);
  People people = random_people(random, base, 16, PersonEnd::Return);
  for (Person& person : people) {
    person.start = change(person.start);
    for (TPoint2D& point : person.route) point = change(point);
  }
  if (change.is_reversed) std::reverse(people.begin(), people.end());
  PeopleSettings settings;
  settings.model = model;
  settings.side = change.is_mirrored ? PeopleSide::Left : PeopleSide::Right;
  Crowd crowd(world, people, settings);
  RobotDisc disc{{change({-4, 2}), change({0.3, 0.1}), 0.3},
                 std::vector<bool>(people.size(), true)};
  std::vector<TPoint2D> places;
  for (int k = 0; k < 150; ++k) {
    crowd.decide(robot ? std::make_optional(disc) : std::nullopt);
    crowd.move();
    disc.disc.position += disc.disc.velocity * settings.period;
    std::vector<TPoint2D> now;
    for (const PersonState& walker : crowd.states()) now.push_back(walker.disc.position);
    if (change.is_reversed) std::reverse(now.begin(), now.end());
    places.insert(places.end(), now.begin(), now.end());
  }
  return places;
}

void expect_same_bits(const Symmetry& change) {
  for (const PeopleModel model : kModels)
    for (const bool robot : {false, true}) {
      const auto expected = places({}, model, robot), actual = places(change, model, robot);
      ASSERT_EQ(expected.size(), actual.size());
      std::size_t different = 0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const TPoint2D p = change(expected[i]);
        if (!(p.x == actual[i].x && p.y == actual[i].y)) ++different;
      }
      EXPECT_EQ(different, 0U) << to_string(model) << " robot " << robot;
    }
}

TEST(CrowdSymmetry, KeepsTheBitsOfATurnByNinetyDegrees) {
  expect_same_bits({1, false, false});
}

TEST(CrowdSymmetry, KeepsTheBitsOfATurnByHalf) {
  expect_same_bits({2, false, false});
}

TEST(CrowdSymmetry, KeepsTheBitsOfAMirrorImageWithTheOtherSide) {
  expect_same_bits({0, true, false});
  expect_same_bits({3, true, false});
}

TEST(CrowdSymmetry, DoesNotDependOnTheOrderOfPeople) {
  expect_same_bits({0, false, true});
}

}  // namespace
}  // namespace slalom::testing
