#include "error_text.h"

#include <slalom/gui/actions.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace slalom {
namespace {

TEST(Actions, AreFoundByIdKeyAndMenu) {
  Actions actions;
  int done = 0;
  actions.add({"file.open", "File", "Open", "Ctrl+O", "Opens.", [&] { ++done; }});
  actions.add({"edit.undo", "Edit", "Undo", "Ctrl+Z", "Undoes.", [&] { done += 10; }});
  actions.add({"file.quit", "File", "Quit", "", "Ends.", [] {}});
  EXPECT_EQ(actions.menus(), (std::vector<std::string>{"File", "Edit"}));
  EXPECT_EQ(actions.of_menu("File").size(), 2U);
  actions.run("file.open");
  actions.find(key_stroke_of("ctrl+z"))->run();
  EXPECT_EQ(done, 11);
  EXPECT_EQ(actions.find(key_stroke_of("Ctrl+Y")), nullptr);
}

TEST(Actions, SayWhyTheyCannotBeDone) {
  Actions actions;
  actions.add({"edit.undo", "Edit", "Undo", "", "Undoes.", [] { FAIL(); },
               [] { return "nothing was done"; }});
  EXPECT_EQ(error_text(Culprit::Usage, [&] { actions.run("edit.undo"); }),
            "Undo: nothing was done");
  EXPECT_EQ(error_text(Culprit::Usage, [&] { actions.run("edit.unod"); }),
            "action edit.unod: there is no such action; expected edit.undo");
}

TEST(Actions, NeverShareAKeyOrAnId) {
  Actions actions;
  actions.add({"a", "M", "A", "Ctrl+A", "", [] {}});
  EXPECT_THROW(actions.add({"a", "M", "A", "", "", [] {}}), std::logic_error);
  EXPECT_THROW(actions.add({"b", "M", "B", "ctrl+a", "", [] {}}), std::logic_error);
}

}  // namespace
}  // namespace slalom
