// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "forms/requests.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

Scenario scenario_with_movers() {
  const Movers movers = {{"a", 0.5, {{0.1, {2, 2}}, {4, {6, 2}}}, MoverEnd::Vanish},
                         {"b", 0.3, {{0, {8, 1}}, {1, {8, 3}}, {2, {8, 1}}}, MoverEnd::Loop}};
  return Scenario::continuous("room", {0, 0, 10, 6}, {}, {1, 5, 0}, {9, 5}).with_movers(movers);
}

/// The scenario that the form makes of these fields.
Scenario typed(const FormValues& input) {
  FormModel form(movers_form(scenario_with_movers()));
  for (const auto& [key, text] : input) form.set_value(form.index_of(key), text);
  EXPECT_EQ(form.first_error(), std::nullopt);
  return read_movers(scenario_with_movers(), form.values());
}

TEST(MoversForm, ShowsOneMoverAtATime) {
  FormModel form(movers_form(scenario_with_movers()));
  const auto shown = [&form](const std::string& key) { return form.is_shown(form.index_of(key)); };
  EXPECT_EQ(form.value(form.index_of("mover")), "1: a");
  EXPECT_TRUE(shown("waypoints.0"));
  EXPECT_FALSE(shown("waypoints.1"));
  EXPECT_EQ(form.value(form.index_of("waypoints.0")), "0.1 2 2; 4 6 2");
  form.choose(form.index_of("mover"), "2: b");
  EXPECT_FALSE(shown("waypoints.0"));
  EXPECT_TRUE(shown("waypoints.1"));
}

TEST(MoversForm, ChangesNothingByItself) {
  EXPECT_EQ(typed({}).hash(), scenario_with_movers().hash());
}

TEST(MoversForm, EditsTimesRadiusIdAndEnd) {
  const Scenario edited = typed({{"waypoints.0", "1 2 2;3 6 2 ; 5  6 4"},
                                 {"radius.0", "0.25"},
                                 {"id.0", "walker"},
                                 {"after.0", "stop"}});
  const Mover expected{"walker", 0.25, {{1, {2, 2}}, {3, {6, 2}}, {5, {6, 4}}}, MoverEnd::Stop};
  EXPECT_EQ(edited.movers()[0], expected);
  EXPECT_EQ(edited.movers()[1], scenario_with_movers().movers()[1]);
}

TEST(MoversForm, DerivesTimesFromASpeed) {
  const Mover b = typed({{"speed.1", "0.5"}}).movers()[1];
  EXPECT_DOUBLE_EQ(b.waypoints[1].t, 4) << "2 m at 0.5 m/s";
  EXPECT_DOUBLE_EQ(b.waypoints[2].t, 8);
}

TEST(MoversForm, SaysWhatIsWrong) {
  for (const std::string text : {"0 1", "0 1 2 3", "0 1 x", "0, 1, 2"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "moving obstacle 1",
                             {"is not a waypoint", "0 1 2; 4 5 2"},
                             [&] {
                               typed({{"waypoints.0", text}});
                             }))
        << text;
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: moving obstacle 'a'",
                           {"waypoint 1", "increasing times"}, [] {
                             typed({{"waypoints.0", "4 2 2; 3 6 2"}});
                           }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: moving obstacle 'a'", {"not closed"}, [] {
    typed({{"after.0", "loop"}});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: moving obstacle 'b'", {"duplicate id"}, [] {
    typed({{"id.0", "b"}});
  }));
}

}  // namespace
}  // namespace slalom
