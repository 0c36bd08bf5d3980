// What an operator does with a photo of an evacuation plan, from the file to the trail that lies in
// its corridors, by keys and clicks only.
#include <QDir>
#include <QLineEdit>
#include <QTest>

#include "core/site/survey/rectification.h"
#include "tests/ui/photo.h"
#include "tests/ui/window_user.h"
#include "ui/site/choices_panel.h"
#include "ui/site/distance_panel.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

class Operator {
  public:
    explicit Operator(ThemeName theme) : day_(theme == ThemeName::kDay) {
        user.window.setTheme(theme);
        user.window.resize(1600, 1000);
        user.hand.set(test::kDrive_s);
        user.window.applyBatch(test::sampleBatch(test::kDrive_s));
    }

    void openPhoto() {
        ++actions;
        user.window.setPlan(test::photographedPlan());
        look("1-photo");
    }
    void press(Qt::Key key) {
        ++actions;
        QTest::keyClick(&user.map(), key);
    }
    void choose(const QString& name) {
        ++actions;
        QAbstractButton* button = user.button(name);
        ASSERT_TRUE(button) << name.toStdString();
        ASSERT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, 20'000));
        button->click();
    }
    void click(Point<World> at) {
        ++actions;
        const Point<View> p = user.map().view().viewFromWorld() * at;
        QTest::mouseClick(&user.map(), Qt::LeftButton, {}, {qRound(p.x), qRound(p.y)});
    }
    void type(const QString& text) {
        ++actions;
        auto* field = user.window.findChild<DistancePanel*>()->findChild<QLineEdit*>();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void chooseFirstProposal() {
        ++actions;
        auto* panel = user.window.findChild<ChoicesPanel*>();
        QAbstractButton* first = nullptr;
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return (first = panel->findChild<ChoiceButton*>()) != nullptr; }, 60'000));
        first->click();
    }
    // Where the map shows a place of the drawing now.
    Point<World> shown(Point<World> on_drawing) const {
        const SitePlan& plan = user.window.desk().site().floor().plans.front();
        const PlanLevel photo = test::photographedPlan().levels.front();
        const auto how = rectificationOf(photo.width_px, photo.height_px, plan.straightened->quad,
                                         plan.straightened->aspect);
        return worldFromPlan(plan.placement, how->height_px) *
               recast(how->flat_from_photo * test::inPhoto(on_drawing));
    }
    void look(const QString& step) {
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        QTest::qWait(150);
        ASSERT_TRUE(QTest::qWaitFor([&] { return user.map().isSharp(); }));
        user.window.grab().save(QStringLiteral(HEDR_BINARY_DIR "/screenshots/story-%1-%2.png")
                                    .arg(step, day_ ? "day" : "night"));
    }

    mutable WindowUser user;
    int actions = 0;

  private:
    static Point<Plan> recast(Point<Flat> p) { return {p.x, p.y}; }

    bool day_;
};

class PhotoStory : public testing::TestWithParam<ThemeName> {};

TEST_P(PhotoStory, TakesAtMostTwelveActions) {
    Operator op(GetParam());
    op.openPhoto();
    op.press(Qt::Key_S);
    op.look("2-corners");
    op.choose("Done");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !op.user.window.desk().open(); }, 20'000));
    op.press(Qt::Key_A);
    op.choose("Distance");
    op.click(op.shown({0.3, 0.3}));
    op.click(op.shown({79.7, 0.3}));
    op.type("79.4 m");
    op.look("3-distance");
    op.choose("Trail");
    op.chooseFirstProposal();
    op.look("4-trail");
    op.choose("Done");
    op.look("5-done");
    EXPECT_LE(op.actions, 12);
    for (const Point<World>& corner :
         {Point<World>{26.0, 9.8}, {1.6, 25.0}, {1.6, 39.2}, {53.8, 39.2}, {78.4, 9.8}}) {
        EXPECT_LT((op.shown(corner) - corner).length(), 0.5) << corner.x << ", " << corner.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, PhotoStory, testing::Values(ThemeName::kDay, ThemeName::kNight),
                         [](const auto& test) {
                             return test.param == ThemeName::kDay ? "day" : "night";
                         });

}  // namespace
}  // namespace hedr
