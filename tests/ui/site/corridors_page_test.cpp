#include <QDir>
#include <QProgressBar>
#include <QTest>

#include "core/geometry/angle.h"
#include "tests/ui/window_user.h"
#include "ui/site/corridors_card.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

class CorridorsPage : public testing::Test {
  protected:
    Site site() { return w.window.desk().site().site(); }
    SiteModel& model() { return w.window.desk().site(); }
    double deviationDeg(double from_deg) {
        return degFromRad(deviationFromGrid(site().direction_rad.value() - radFromDeg(from_deg),
                                            radFromDeg(90.0)));
    }
    void open() {
        QTest::keyClick(&w.window, Qt::Key_H);
        ASSERT_TRUE(w.window.desk().open());
    }
    void openAndFind() {
        open();
        ASSERT_TRUE(soon([&] { return text().contains("sure"); })) << text().toStdString();
    }
    QString text() {
        QString all;
        for (auto* label : w.window.findChild<CorridorsCard*>()->findChildren<QLabel*>())
            all += label->text() + '\n';
        return all;
    }
    void drag(Point<World> from, Point<World> to) {
        const auto at = [&](Point<World> p) {
            const Point<View> v = w.map().view().viewFromWorld() * p;
            return QPoint(qRound(v.x), qRound(v.y));
        };
        QTest::mousePress(&w.map(), Qt::LeftButton, {}, at(from));
        QTest::mouseMove(&w.map(), at(to));
        QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, at(to));
    }
    // The plan turned about the world's origin.
    void turnPlan(double deg) {
        Site next = site();
        next.floors.front().plans.front().placement.origin.heading_rad += radFromDeg(deg);
        model().edit(next);
    }
    WindowUser w;
};

TEST_F(CorridorsPage, TellsTheDirectionOfThePlansWallsInTwoActions) {
    w.window.setPlan(test::samplePlan());
    turnPlan(7.0);
    openAndFind();
    EXPECT_FALSE(site().direction_rad) << "not before it is done";
    w.button("Done")->click();
    ASSERT_TRUE(site().direction_rad);
    EXPECT_NEAR(deviationDeg(7.0), 0.0, 0.3);
    EXPECT_TRUE(site().floors.front().plans.front().tells_direction);
    w.window.desk().undo();
    EXPECT_FALSE(site().direction_rad);
}

TEST_F(CorridorsPage, TurnsTheDirectionWithThePlanThatToldIt) {
    w.window.setPlan(test::samplePlan());
    openAndFind();
    w.button("Done")->click();
    QTest::keyClick(&w.window, Qt::Key_A);
    w.button("Move")->click();
    w.button("Turn left")->click();
    w.button("Done")->click();
    EXPECT_NEAR(deviationDeg(0.0), 0.0, 0.3);
    EXPECT_GT(std::abs(*site().direction_rad), radFromDeg(45.0)) << "it was turned";
}

TEST_F(CorridorsPage, TakesALineAlongACorridorWithoutAPlan) {
    open();
    EXPECT_FALSE(w.button("From the plan")->isEnabled());
    EXPECT_FALSE(w.button("Tell none")->isEnabled());
    const Point<World> c = w.map().view().centre;
    const double m = 100.0 / w.map().view().pixels_per_metre;
    drag(c, c + Vector<World>{m * std::cos(0.3), m * std::sin(0.3)});
    drag(c, c);  // a slip of the hand
    w.button("Done")->click();
    EXPECT_NEAR(deviationDeg(degFromRad(0.3)), 0.0, 0.8);
    open();
    w.button("Tell none")->click();
    w.button("Done")->click();
    EXPECT_FALSE(site().direction_rad);
}

TEST_F(CorridorsPage, LeavesTheSiteAloneWhenCanceledOrUndone) {
    w.window.setPlan(test::samplePlan());
    const Site before = site();
    openAndFind();
    w.button("Undo")->click();
    EXPECT_FALSE(w.button("Undo")->isEnabled());
    EXPECT_TRUE(text().contains("Not told"));
    w.button("Cancel")->click();
    EXPECT_EQ(site(), before);
}

TEST_F(CorridorsPage, SaysThatAPlanHasNoDirection) {
    PlanImage round = test::samplePlan();
    const PlanLevel& size = round.levels.front();
    QImage picture(size.width_px, size.height_px, QImage::Format_Grayscale8);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setPen(QPen(Qt::black, 4.0));
    for (int r = 60; r < size.height_px / 2; r += 60)
        painter.drawEllipse(QPointF(size.width_px / 2.0, size.height_px / 2.0), r, r);
    painter.end();
    const QTemporaryDir folder;
    ASSERT_TRUE(picture.save(folder.filePath("round.png")));
    w.window.setPlan(loadPlan(folder.filePath("round.png").toStdString()).value());
    open();
    ASSERT_TRUE(soon([&] { return text().contains("no dominant direction"); }))
        << text().toStdString();
    w.button("Done")->click();
    EXPECT_FALSE(site().direction_rad);
}

TEST_F(CorridorsPage, IsPictured) {
    w.window.setPlan(test::samplePlan());
    w.live(0.0);
    w.live(test::kDrive_s);
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        w.window.setTheme(theme);
        openAndFind();
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        const char* name = theme == ThemeName::kDay ? "day" : "night";
        EXPECT_TRUE(w.window.grab().save(
            QStringLiteral(HEDR_BINARY_DIR "/screenshots/corridors-%1.png").arg(name)));
        w.button("Cancel")->click();
    }
}

}  // namespace
}  // namespace hedr
