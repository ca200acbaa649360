// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/table.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// 400 pixels of content in a view of 100 pixels below a header of 20.
Scroll scroll() {
  Scroll scroll;
  scroll.set(400, {0, 20, 200, 100});
  return scroll;
}

TEST(Scroll, StaysWithinItsContent) {
  Scroll view = scroll();
  view.by(-10);
  EXPECT_EQ(view.offset(), 0);
  view.by(1000);
  EXPECT_EQ(view.offset(), 300);
  view.set(150, {0, 20, 200, 100});
  EXPECT_EQ(view.offset(), 50) << "the content has become shorter";
}

TEST(Scroll, BringsAPartIntoView) {
  Scroll view = scroll();
  view.show(150, 170);
  EXPECT_EQ(view.offset(), 70);
  view.show(100, 120);
  EXPECT_EQ(view.offset(), 70) << "it is in view";
  view.show(0, 20);
  EXPECT_EQ(view.offset(), 0);
}

TEST(Scroll, HasABarOnlyIfItIsNeeded) {
  EXPECT_TRUE(scroll().thumb());
  Scroll fits;
  fits.set(100, {0, 20, 200, 100});
  EXPECT_FALSE(fits.thumb());
  EXPECT_FALSE(fits.press({199, 50}));
}

TEST(Scroll, FollowsTheDraggedBar) {
  Scroll view = scroll();
  EXPECT_FALSE(view.press({100, 50})) << "beside the bar";
  EXPECT_TRUE(view.press({195, 25}));
  EXPECT_TRUE(view.drag({195, 1000}));
  EXPECT_EQ(view.offset(), 300);
  view.release();
  EXPECT_FALSE(view.drag({195, 0}));
  EXPECT_TRUE(view.press({195, 25})) << "above the bar: one page up";
  EXPECT_EQ(view.offset(), 200);
}

}  // namespace
}  // namespace slalom
