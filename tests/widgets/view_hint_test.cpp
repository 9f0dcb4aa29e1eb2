// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/view_hint.h"

#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

class Hints : public Window {};

TEST_F(Hints, StandInEachViewUntilItIsUsed) {
  EXPECT_TRUE(window_->findChildren<ViewHint*>().isEmpty());  // only at a first start
  window_->showHints();
  window_->showHints();
  QTest::qWait(20);
  ASSERT_EQ(window_->findChildren<ViewHint*>().size(), 3);
  for (VtkView* view :
       {static_cast<VtkView*>(window_->views().cloud()), static_cast<VtkView*>(window_->views().columns()),
        static_cast<VtkView*>(window_->views().boxes())}) {
    auto* hint = view->canvas()->findChild<ViewHint*>();
    ASSERT_TRUE(hint);
    EXPECT_TRUE(hint->isVisible());
    EXPECT_TRUE(view->canvas()->rect().contains(hint->geometry()));
    const int before = window_->findChildren<ViewHint*>().size();
    QTest::mouseClick(view->canvas(), Qt::LeftButton, {}, view->canvas()->rect().center());
    QTest::qWait(20);
    EXPECT_EQ(window_->findChildren<ViewHint*>().size(), before - 1);
    EXPECT_FALSE(view->canvas()->findChild<ViewHint*>());
  }
}

}  // namespace
}  // namespace stratascope::test
