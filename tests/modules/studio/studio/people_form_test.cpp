// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "forms/requests.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

Scenario scenario_with_people() {
  const People people = {{"a", 0.25, 1.3, {2, 2}, {{4, 2}, {6, 3.5}}, 1.5, PersonEnd::Return},
                         {"b", 0.3, 1, {8, 1}, {{8, 3}}}};
  return Scenario::continuous("room", {0, 0, 10, 6}, {}, {1, 5, 0}, {9, 5}).with_people(people);
}

/// The scenario that the form makes of these fields.
Scenario typed_people(const FormValues& input) {
  FormModel form(people_form(scenario_with_people()));
  for (const auto& [key, text] : input) form.set_value(form.index_of(key), text);
  EXPECT_EQ(form.first_error(), std::nullopt);
  return read_people(scenario_with_people(), form.values());
}

TEST(PeopleForm, ShowsOnePersonAtATime) {
  FormModel form(people_form(scenario_with_people()));
  const auto shown = [&form](const std::string& key) { return form.is_shown(form.index_of(key)); };
  EXPECT_EQ(form.value(form.index_of("person")), "1: a");
  EXPECT_TRUE(shown("route.0"));
  EXPECT_FALSE(shown("route.1"));
  EXPECT_EQ(form.value(form.index_of("start.0")), "2 2");
  EXPECT_EQ(form.value(form.index_of("route.0")), "4 2; 6 3.5");
  form.choose(form.index_of("person"), "2: b");
  EXPECT_FALSE(shown("route.0"));
  EXPECT_TRUE(shown("route.1"));
}

TEST(PeopleForm, ChangesNothingByItself) {
  EXPECT_EQ(typed_people({}).hash(), scenario_with_people().hash());
}

TEST(PeopleForm, EditsAllOfAPerson) {
  const Scenario edited = typed_people({{"id.0", "anna"},
                                        {"radius.0", "0.2"},
                                        {"speed.0", "1.1"},
                                        {"start.0", " 3  1"},
                                        {"route.0", "5 1;7 1 "},
                                        {"begin.0", "0"},
                                        {"after.0", "vanish"}});
  const Person expected{"anna", 0.2, 1.1, {3, 1}, {{5, 1}, {7, 1}}, 0, PersonEnd::Vanish};
  EXPECT_EQ(edited.people()[0], expected);
  EXPECT_EQ(edited.people()[1], scenario_with_people().people()[1]);
}

TEST(PeopleForm, SaysWhatIsWrong) {
  for (const std::string text : {"1", "1 2 3", "1 x", "1, 2"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "person 1", {"is not a point", "4 3; 1 3"}, [&] {
      typed_people({{"route.0", text}});
    })) << text;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "person 2", {"is not a start", "one point"}, [] {
    typed_people({{"start.1", "1 2; 3 4"}});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'a'", {"no route"}, [] {
    typed_people({{"route.0", ";"}});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'b'", {"duplicate id"}, [] {
    typed_people({{"id.0", "b"}});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'b'", {"starts within person 'a'"}, [] {
    typed_people({{"begin.0", "0"}, {"start.1", "2.5 2"}});
  }));
}

}  // namespace
}  // namespace slalom
