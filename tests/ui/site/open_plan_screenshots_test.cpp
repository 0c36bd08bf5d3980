#include <QDir>
#include <QPushButton>

#include "tests/ui/site/plan_files.h"
#include "tests/ui/window_user.h"
#include "ui/site/open_plan_dialog.h"
#include "ui/site/page_card.h"
#include "ui/site/plan_row.h"
#include "ui/site/recent_plans_card.h"

namespace hedr {
namespace {

// Pictures for people to look at: build folder, screenshots/NAME-THEME.png.
class OpenPlanScreenshots : public testing::TestWithParam<ThemeName> {
  protected:
    OpenPlanScreenshots() {
        w.window.setTheme(GetParam());
        files.addImage("ground-floor.png", {2000, 1300});
        files.addImage("first-floor.jpg", {900, 1400}, Qt::darkBlue);
        files.addImage("evacuation-plan-of-the-second-floor-east-wing-2026.png", {1600, 900});
        files.addText("notes.png", "no picture");
    }
    void save(QWidget& widget, const QString& name) const {
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        const char* theme = GetParam() == ThemeName::kDay ? "day" : "night";
        QTest::qWait(150);
        EXPECT_TRUE(widget.grab().save(
            QStringLiteral(HEDR_BINARY_DIR "/screenshots/%1-%2.png").arg(name).arg(theme)));
    }
    // So that the pictures are there.
    void looked(const QString& file) const {
        EXPECT_TRUE(soon([&] {
            const auto* words = w.window.findChild<QLabel*>("words");
            return words && !words->text().isEmpty();
        })) << file.toStdString();
    }

    test::PlanFiles files;
    WindowUser w;
};

TEST_P(OpenPlanScreenshots, ShowRecentPlansAndTheDialog) {
    w.window.setRecentPlans({files.path("ground-floor.png"), files.path("first-floor.jpg"),
                             files.path("evacuation-plan-of-the-second-floor-east-wing-2026.png"),
                             files.path("notes.png")});
    QTest::keyClick(&w.window, Qt::Key_P);
    ASSERT_TRUE(soon([&] { return w.window.findChild<RecentPlansCard*>()->isVisible(); }));
    save(w.window, "open-recent");
    w.button("Open another…")->click();
    auto* dialog = w.window.findChild<OpenPlanDialog*>();
    dialog->selectFile(files.path("ground-floor.png"));
    emit dialog->currentChanged(files.path("ground-floor.png"));
    looked("ground-floor.png");
    save(*dialog, "open-dialog");
    emit dialog->currentChanged(files.path("notes.png"));
    looked("notes.png");
    save(*dialog, "open-dialog-unreadable");
    dialog->reject();
}

TEST_P(OpenPlanScreenshots, ShowThePagesOfAFile) {
    using Size = QPageSize;
    const QString file = files.addPdf("university-building-floors.pdf",
                                      {Size::A3, Size::A3, Size::A4, Size::A5, Size::A4});
    w.window.setRecentPlans({file});
    QTest::keyClick(&w.window, Qt::Key_P);
    ASSERT_TRUE(soon([&] { return w.button("university-building-floors.pdf") != nullptr; }));
    w.button("university-building-floors.pdf")->click();
    auto* card = w.window.findChild<PageCard*>();
    ASSERT_TRUE(soon([&] { return card->isVisible(); }));
    QTest::qWait(400);
    save(w.window, "open-pages");
    card->findChild<QLineEdit*>("paper_scale")->setText("1 : x");
    save(w.window, "open-pages-scale");
}

INSTANTIATE_TEST_SUITE_P(Both, OpenPlanScreenshots,
                         testing::Values(ThemeName::kDay, ThemeName::kNight), [](const auto& test) {
                             return std::string(test.param == ThemeName::kDay ? "day" : "night");
                         });

}  // namespace
}  // namespace hedr
