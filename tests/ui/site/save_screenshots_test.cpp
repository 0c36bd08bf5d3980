#include <QDir>
#include <QTemporaryDir>

#include "tests/ui/site/menu_user.h"
#include "tests/ui/window_user.h"
#include "ui/site/save_dialog.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// Pictures for people to look at: build folder, screenshots/NAME-THEME.png.
class SaveScreenshots : public testing::TestWithParam<ThemeName> {
  protected:
    SaveScreenshots() {
        w.window.setTheme(GetParam());
        QDir(folder.path()).mkdir("plans of the campus");
        PlanImage plan = test::samplePlan();
        plan.image_file = folder.filePath("ground-floor.png").toStdString();
        w.window.setPlan(plan);
        w.live(1.0);
        w.live(60.0);
        w.button("Layers")->click();
        QTest::qWait(400);  // the small pictures
    }
    void save(QWidget& widget, const QString& name) const {
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        const char* theme = GetParam() == ThemeName::kDay ? "day" : "night";
        QTest::qWait(150);
        EXPECT_TRUE(widget.grab().save(
            QStringLiteral(HEDR_BINARY_DIR "/screenshots/%1-%2.png").arg(name).arg(theme)));
    }

    QTemporaryDir folder;
    WindowUser w;
};

TEST_P(SaveScreenshots, ShowTheMenuAndTheDialog) {
    test::RowMenu row(w.window, "ground-floor.png");
    save(row.menu(), "save-menu");
    save(*row.entry("Save a copy as")->menu(), "save-menu-kinds");
    ASSERT_TRUE(row.choose("Image with world file…"));
    auto* dialog = w.window.findChild<SaveDialog*>();
    ASSERT_NE(dialog, nullptr);
    save(*dialog, "save-dialog");
    dialog->reject();
}

TEST_P(SaveScreenshots, ShowHowFarACopyIsAndWhereItLies) {
    w.window.showPlanProgress(0.2);
    w.window.showCopyProgress(0.63);
    save(w.window, "save-progress");
    w.window.showPlanProgress(std::nullopt);
    w.window.showCopyProgress(std::nullopt);
    w.window.showSaved({"/home/operator/plans/ground-floor-copy.yaml",
                        "/home/operator/plans/ground-floor-copy.pgm"});
    save(w.window, "save-done");
    ASSERT_TRUE(test::RowMenu(w.window, "ground-floor.png").choose("GeoTIFF…"));
    save(w.window, "save-refused");
}

INSTANTIATE_TEST_SUITE_P(Both, SaveScreenshots, testing::Values(ThemeName::kDay, ThemeName::kNight),
                         [](const auto& test) {
                             return std::string(test.param == ThemeName::kDay ? "day" : "night");
                         });

}  // namespace
}  // namespace hedr
