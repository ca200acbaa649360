// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/people/people_settings.h>

#include <gtest/gtest.h>

#include <string>

namespace slalom {
namespace {

TEST(PeopleSettings, AreReadAndChecked) {
  PeopleSettings settings;
  const auto set = [&](const std::string& key, const std::string& text) {
    for_each_option(settings, [&](const Option& option) {
      if (option.key == key) option.set(text, "people.ini: " + key);
    });
  };
  set("model", "orca");
  set("side", "left");
  set("notices", "0.5");
  EXPECT_EQ(settings.model, PeopleModel::Orca);
  EXPECT_EQ(settings.side, PeopleSide::Left);
  EXPECT_EQ(settings.notices, 0.5);
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, "people.ini: period", {"0"}, [&] { set("period", "0"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "people.ini: model", {"speed"},
                           [&] { set("model", "force"); }));
}

TEST(PeopleSettings, LetTheSharesOfThoseWhoNoticeBeNested) {
  constexpr int kPeople = 2000;
  int half = 0;
  for (int i = 0; i < kPeople; ++i) {
    const std::string id = "p" + std::to_string(i);
    EXPECT_FALSE(notices_robot("scenario", id, 0));
    EXPECT_TRUE(notices_robot("scenario", id, 1));
    bool before = false;
    for (double share = 0; share <= 1; share += 0.125) {
      const bool notices = notices_robot("scenario", id, share);
      EXPECT_TRUE(notices || !before);
      before = notices;
    }
    if (notices_robot("scenario", id, 0.5)) ++half;
  }
  EXPECT_NEAR(half, kPeople / 2, 4 * 22.4);  // four standard deviations of a binomial
}

}  // namespace
}  // namespace slalom
