// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"
#include "views/form_layout.h"
#include "views/form_panel.h"
#include "window/script_player.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

/// Keyboard input of a form without a window.
class FormPanelKeys : public testing::Test {
 protected:
  void open() {
    panel_ = make_form_panel(nullptr, form_, [this] { ++closed_; });
  }
  void key(int key, int modifiers = 0) {
    panel_->keyboardEvent(key, 0, GLFW_PRESS, modifiers);
    panel_->keyboardEvent(key, 0, GLFW_RELEASE, modifiers);
  }
  void type(const std::string& text) {
    for (const char c : text) panel_->keyboardCharacterEvent(static_cast<unsigned char>(c));
  }
  void SetUp() override {
    form_.title = "Order";
    FormField size{"size", "Size", FieldKind::Choice, "small"};
    size.choices = {"small", "large"};
    FormField toppings{"toppings", "Toppings", FieldKind::Choices, "olives"};
    toppings.choices = {"ham", "olives"};
    toppings.required = false;
    form_.fields = {{"head", "What", FieldKind::Heading},
                    {"name", "Name", FieldKind::Text, "Ada"},
                    {"count", "Count", FieldKind::Integer, "1"},
                    size,
                    toppings,
                    {"hot", "Hot", FieldKind::Flag}};
    form_.accepted = [this](const FormValues& values) { accepted_ = values; };
    open();
  }

  FormDescription form_;
  nanogui::ref<Element> panel_;
  FormValues accepted_;
  int closed_ = 0;
};

TEST_F(FormPanelKeys, ReplaceTheFirstFieldAndMoveOnWithTab) {
  type("Bob");
  key(GLFW_KEY_TAB);
  type("12");
  key(GLFW_KEY_BACKSPACE);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["name"], "Bob") << "the initial text is selected";
  EXPECT_EQ(accepted_["count"], "1");
  EXPECT_EQ(closed_, 1);
}

TEST_F(FormPanelKeys, ChooseWithArrowsAndSpace) {
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_RIGHT);  // large
  key(GLFW_KEY_DOWN);   // at olives, which is selected
  key(GLFW_KEY_SPACE);
  key(GLFW_KEY_LEFT);
  key(GLFW_KEY_SPACE);
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_SPACE);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["size"], "large");
  EXPECT_EQ(accepted_["toppings"], "ham");
  EXPECT_EQ(accepted_["hot"], "true");
}

TEST_F(FormPanelKeys, CycleBackwardsOverTheButtons) {
  key(GLFW_KEY_TAB, GLFW_MOD_SHIFT);  // OK
  key(GLFW_KEY_TAB, GLFW_MOD_SHIFT);  // Cancel
  key(GLFW_KEY_ENTER);
  EXPECT_TRUE(accepted_.empty());
  EXPECT_EQ(closed_, 1);
}

TEST_F(FormPanelKeys, CancelWithEscape) {
  key(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(accepted_.empty());
  EXPECT_EQ(closed_, 1);
}

TEST_F(FormPanelKeys, FocusAnInvalidField) {
  key(GLFW_KEY_TAB);
  type("few");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(closed_, 0);
  EXPECT_TRUE(mentions(panel_->text(), {"Count: ", "'few'", "valid"}));
  type("3");  // the invalid field has the focus
  EXPECT_FALSE(mentions(panel_->text(), {"valid"}));
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["count"], "3");
}

TEST_F(FormPanelKeys, ShowErrorsOfTheCallback) {
  form_.accepted = [](const FormValues&) { throw usage_error("oven", "is cold", "a hot one"); };
  open();
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(closed_, 0);
  EXPECT_TRUE(mentions(panel_->text(), {"oven: is cold; expected a hot one"}));
}

TEST_F(FormPanelKeys, CloseAMessage) {
  form_ = {};
  form_.title = "Done";
  form_.intro = "All is well.";
  open();
  EXPECT_NE(panel_->text().find("All is well."), std::string::npos);
  EXPECT_FALSE(panel_->rect_of("cancel").has_value());
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(closed_, 1);
}

/// Paths typed, chosen and dropped in a folder "maps/" with "a.map" and "b.map", and "c.txt" next
/// to it.
class FormPanelPaths : public FormPanelKeys {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_ / "maps");
    for (const std::string name : {"maps/a.map", "maps/b.map", "c.txt"})
      std::ofstream(folder_ / name) << name;
    FormField file{"file", "File", FieldKind::Text, folder_ / ""};
    file.extensions = {".map"};
    form_.fields = {file, {"count", "Count", FieldKind::Integer, "1"}};
    form_.accepted = [this](const FormValues& values) { accepted_ = values; };
    open();
  }
  void keep_typing(const std::string& text) {
    key(GLFW_KEY_END);
    type(text);
  }
  std::string shown() const { return shown_text(*panel_->childAt(0)); }
  std::string map(const std::string& name) const { return folder_ / ("maps/" + name); }

  TemporaryFolder folder_;
};

TEST_F(FormPanelPaths, AreChosenByArrowsAndEnter) {
  EXPECT_TRUE(mentions(shown(), {"../\nmaps/\n"}));
  EXPECT_FALSE(mentions(shown(), {"c.txt"}));
  key(GLFW_KEY_DOWN);  // ../
  key(GLFW_KEY_DOWN);  // maps/
  key(GLFW_KEY_ENTER);
  EXPECT_TRUE(mentions(shown(), {"../\n> a.map\nb.map\n"}));
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(closed_, 0) << "it chose b.map";
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["file"], map("b.map"));
}

TEST_F(FormPanelPaths, DecideTheFolderWhileTheyAreTyped) {
  keep_typing("maps");
  EXPECT_TRUE(mentions(shown(), {"maps/\n"}));
  type("/");
  EXPECT_TRUE(mentions(shown(), {"a.map"}));
  type("none/");
  EXPECT_TRUE(mentions(shown(), {"No such file"}));
  key(GLFW_KEY_DOWN);  // ../
  key(GLFW_KEY_ENTER);
  EXPECT_TRUE(mentions(shown(), {"a.map"}));
}

TEST_F(FormPanelPaths, GiveTheArrowsBackAtTheFirstEntryAndWithTab) {
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_UP);  // in the field again
  keep_typing("new.map");
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_TAB);
  type("5");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["file"], folder_ / "new.map");
  EXPECT_EQ(accepted_["count"], "5");
}

TEST_F(FormPanelPaths, OfSeveralAreReplacedAtTheEnd) {
  form_.fields[0].several = true;
  form_.fields[0].value = "x.map, " + map("");
  open();
  key(GLFW_KEY_DOWN);  // ../
  key(GLFW_KEY_DOWN);  // a.map
  key(GLFW_KEY_ENTER);
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(accepted_["file"], "x.map, " + map("a.map"));
}

TEST_F(FormPanelPaths, AreShownForTheFieldThatHadTheFocusLast) {
  FormField other = form_.fields[0];
  other.key = "other";
  other.value = map("");
  form_.fields.push_back(other);
  open();
  EXPECT_FALSE(mentions(shown(), {"a.map"}));
  key(GLFW_KEY_TAB);  // count
  EXPECT_FALSE(mentions(shown(), {"a.map"}));
  key(GLFW_KEY_TAB);  // other
  EXPECT_TRUE(mentions(shown(), {"a.map"}));
  key(GLFW_KEY_TAB);  // Cancel
  EXPECT_TRUE(mentions(shown(), {"a.map"}));
}

TEST(FormLayout, KeepsLinesApartAndWrapsChoices) {
  FormDescription form;
  FormField many{"many", "Many", FieldKind::Choices, "", "", "help"};
  for (int i = 0; i < 20; ++i) many.choices.push_back("choice " + std::to_string(i));
  FormField path{"path", "Path", FieldKind::Text, "", "", "help"};
  path.wide = true;
  form.fields = {many, {"count", "Count", FieldKind::Integer, "1", "m", "help"}, path};
  const FormLayout layout(
      FormModel(form), 900, [](const std::string&, float) { return 80; }, std::size_t{1});
  ASSERT_EQ(layout.lines().size(), 3U);
  double bottom = 0;
  for (const FormLine& line : layout.lines()) {
    EXPECT_DOUBLE_EQ(line.top, bottom);
    bottom += line.height;
    for (const ScreenRect& part : {line.label, line.box, line.unit, line.help, line.folder}) {
      if (part.width <= 0) continue;
      EXPECT_GE(part.top, line.top);
      EXPECT_LE(part.top + part.height, bottom);
      EXPECT_LE(part.left + part.width, 900);
    }
  }
  EXPECT_DOUBLE_EQ(layout.height(), bottom);
  EXPECT_GT(layout.lines()[1].folder.height, 0);
  EXPECT_EQ(layout.lines()[2].folder.height, 0);
  // Each is 100 wide with its margins, and 106 from the next; 700 px hold 6 or 7 in a row.
  const auto& choices = layout.lines()[0].choices;
  ASSERT_EQ(choices.size(), 20U);
  EXPECT_GT(choices[7].top, choices[0].top);
  EXPECT_EQ(choices[5].top, choices[0].top);
  for (std::size_t i = 1; i < choices.size(); ++i)
    if (choices[i].top == choices[i - 1].top) {
      EXPECT_GE(choices[i].left, choices[i - 1].left + choices[i - 1].width);
    }
}

}  // namespace
}  // namespace slalom
