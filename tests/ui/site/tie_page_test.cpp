#include <QDir>
#include <QLineEdit>
#include <QTest>

#include "core/geometry/angle.h"
#include "tests/ui/window_user.h"
#include "ui/site/site_desk.h"
#include "ui/site/tie_card.h"

namespace hedr {
namespace {

class TiePage : public testing::Test {
  protected:
    TiePage() {
        w.window.setPlan(test::samplePlan());
        open();
    }
    void open() {
        QTest::keyClick(&w.window, Qt::Key_G);
        QTest::qWait(0);
        EXPECT_TRUE(w.window.desk().open());
    }
    std::optional<GeoTie> tie() { return w.window.desk().site().site().geo_tie; }
    QPoint onMap(Point<World> p) {
        const Point<View> v = w.map().view().viewFromWorld() * p;
        return {qRound(v.x), qRound(v.y)};
    }
    void click(Point<World> at) { QTest::mouseClick(&w.map(), Qt::LeftButton, {}, onMap(at)); }
    QLineEdit* field(const QString& name) {
        for (auto* edit : w.window.findChild<TieCard*>()->findChildren<QLineEdit*>()) {
            if (edit->accessibleName() == name && edit->isVisible()) return edit;
        }
        return nullptr;
    }
    void type(const QString& name, const QString& text) {
        QLineEdit* edit = field(name);
        ASSERT_TRUE(edit) << name.toStdString();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    QString text() {
        QString all;
        for (auto* label : w.window.findChild<TieCard*>()->findChildren<QLabel*>())
            all += label->text() + '\n';
        return all.replace(QChar(0x00A0), QChar(' '));
    }
    WindowUser w;
};

TEST_F(TiePage, TiesByOnePlaceAndABearing) {
    click({40.0, 20.0});
    type("Coordinates of place 1", "52.2197, 21.0122");
    type("Bearing of up on the map", "30");
    w.button("Done")->click();
    ASSERT_TRUE(tie());
    EXPECT_NEAR(tie()->point.x, 40.0, 0.1);
    EXPECT_NEAR(tie()->point.y, 20.0, 0.1);
    EXPECT_EQ(tie()->at, (LatLon{52.2197, 21.0122}));
    EXPECT_NEAR(degFromRad(tie()->bearing_of_y_rad), 30.0, 1e-9);
    w.window.desk().undo();
    EXPECT_FALSE(tie());
}

TEST_F(TiePage, TiesByTwoPlacesWhoseBearingFollows) {
    const GeoTie truth{{40.0, 20.0}, {52.2197, 21.0122}, radFromDeg(25.0)};
    const auto textOf = [&](Point<World> p) {
        const LatLon at = latLonOf(p, truth).value();
        return QString("%1, %2").arg(at.latitude_deg, 0, 'f', 8).arg(at.longitude_deg, 0, 'f', 8);
    };
    click({30.0, 20.0});
    type("Coordinates of place 1", textOf({30.0, 20.0}));
    click({70.0, 20.0});
    type("Coordinates of place 2", textOf({70.0, 20.0}));
    EXPECT_TRUE(text().contains("Tied by two places")) << text().toStdString();
    EXPECT_FALSE(text().contains("does not agree")) << text().toStdString();
    EXPECT_FALSE(field("Bearing of up on the map")->isEnabled());
    w.button("Done")->click();
    ASSERT_TRUE(tie());
    EXPECT_NEAR(degFromRad(tie()->bearing_of_y_rad), 25.0, 0.3);
}

TEST_F(TiePage, SaysThatTwoPlacesContradictEachOther) {
    click({30.0, 20.0});
    type("Coordinates of place 1", "52.2197, 21.0122");
    click({70.0, 20.0});
    type("Coordinates of place 2", "52.2197, 21.0222");
    EXPECT_TRUE(text().contains("does not agree")) << text().toStdString();
    type("Coordinates of place 2", "52.2197, 21.0122");  // the same
    EXPECT_FALSE(w.button("Done")->isEnabled());
    w.button("Undo")->click();
    EXPECT_TRUE(w.button("Done")->isEnabled());
}

TEST_F(TiePage, SaysWhatIsNoPlaceAndKeepsWhatWasTyped) {
    click({30.0, 20.0});
    type("Coordinates of place 1", "somewhere");
    EXPECT_TRUE(text().contains("somewhere is no place on the globe")) << text().toStdString();
    EXPECT_EQ(field("Coordinates of place 1")->text(), "somewhere");
    type("Coordinates of place 1", "52.2197, 21.0122");
    type("Bearing of up on the map", "north");
    EXPECT_TRUE(text().contains("north is no bearing")) << text().toStdString();
    w.button("Done")->click();
    EXPECT_EQ(tie()->bearing_of_y_rad, 0.0);
}

TEST_F(TiePage, MovesRemovesAndUnties) {
    click({30.0, 20.0});
    type("Coordinates of place 1", "52.2197, 21.0122");
    QTest::mousePress(&w.map(), Qt::LeftButton, {}, onMap({30.0, 20.0}));
    QTest::mouseMove(&w.map(), onMap({35.0, 25.0}));
    QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, onMap({35.0, 25.0}));
    w.button("Done")->click();
    EXPECT_NEAR(tie()->point.x, 35.0, 0.2);
    open();
    w.button("Remove place 1")->click();
    EXPECT_TRUE(text().contains("Not tied"));
    w.button("Undo")->click();
    EXPECT_TRUE(text().contains("Tied by one place"));
    w.button("No tie")->click();
    w.button("Done")->click();
    EXPECT_FALSE(tie());
}

TEST_F(TiePage, IsPictured) {
    w.live(0.0);
    w.live(test::kDrive_s);
    click({30.0, 20.0});
    type("Coordinates of place 1", "52.2197, 21.0122");
    click({70.0, 20.0});
    type("Coordinates of place 2", "52.2197, 21.01279");
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        w.window.setTheme(theme);
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        const char* name = theme == ThemeName::kDay ? "day" : "night";
        EXPECT_TRUE(w.window.grab().save(
            QStringLiteral(HEDR_BINARY_DIR "/screenshots/tie-%1.png").arg(name)));
    }
}

}  // namespace
}  // namespace hedr
