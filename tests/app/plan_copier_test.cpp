#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/session.h"
#include "tests/core/text/small_disk.h"
#include "ui/main_window.h"
#include "ui/panels/banner.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

PlanLevel noise(int side_px) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(side_px) *
                                     static_cast<std::size_t>(side_px));
    std::uint32_t state = 1;
    for (std::uint8_t& value : pixels) {
        state = 1664525u * state + 1013904223u;
        value = static_cast<std::uint8_t>(state >> 24);
    }
    return {side_px, side_px, 1,
            std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))};
}

// The window wishes copies, the session writes them.
class CopiesOfAPlan : public testing::Test {
  protected:
    CopiesOfAPlan() { window.show(); }
    PlanCopy copyOf(PlanLevel level, PlanCopyKind kind, const QString& name) const {
        return {.plan = {folder.filePath("plan.png").toStdString(), {std::move(level)}},
                .geo_tie = GeoTie{{}, {48.0, 11.0}, 0.0},
                .kind = kind,
                .file = folder.filePath(name).toStdString()};
    }
    PlanProgressCard* progress() const {
        for (auto* card : window.findChildren<PlanProgressCard*>()) {
            if (card->isVisible() && card->accessibleName() == "Saving the copy") return card;
        }
        return nullptr;
    }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }
    QStringList files() const { return QDir(folder.path()).entryList(QDir::Files); }
    bool told() const {
        return QTest::qWaitFor([&] { return !banner().isEmpty() && !progress(); }, 20000);
    }

    QTemporaryDir folder;
    MainWindow window;
    Session session{window, {}};
};

TEST_F(CopiesOfAPlan, AreWrittenAndItIsSaidWhereTheyLie) {
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kRosMap, "hall.yaml"));
    ASSERT_TRUE(told());
    EXPECT_EQ(banner(), "Saved as hall.yaml and hall.pgm in the folder " + folder.path() + ".");
    EXPECT_EQ(files(), QStringList({"hall.pgm", "hall.yaml"}));
}

TEST_F(CopiesOfAPlan, AreWrittenOneAfterTheOther) {
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kGeoTiff, "a.tif"));
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kPng, "b.png"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return banner().contains("b.png"); }, 20000));
    EXPECT_EQ(files(), QStringList({"a.tif", "b.pgw", "b.png"}));
}

TEST_F(CopiesOfAPlan, AreCanceledAndLeaveNothing) {
    emit window.copyChosen(copyOf(noise(4000), PlanCopyKind::kPng, "a.png"));
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kPng, "waits.png"));
    ASSERT_NE(progress(), nullptr);
    progress()->findChild<QPushButton*>()->click();
    EXPECT_EQ(progress(), nullptr);
    EXPECT_TRUE(banner().isEmpty());
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kGeoTiff, "after.tif"));
    ASSERT_TRUE(told());
    EXPECT_EQ(files(), QStringList("after.tif"));
}

TEST_F(CopiesOfAPlan, SayInOneSentenceThatTheFolderIsGone) {
    emit window.copyChosen(copyOf(noise(64), PlanCopyKind::kGeoTiff, "gone/a.tif"));
    ASSERT_TRUE(told());
    EXPECT_TRUE(banner().contains("gone/a.tif cannot be written")) << banner().toStdString();
}

TEST_F(CopiesOfAPlan, SayInOneSentenceThatTheImageIsGone) {
    PlanLevel tiled = noise(64);
    tiled.pixels.reset();
    tiled.read_part = [](const PlanPart&) -> Result<PlanLevel> {
        return fail(ErrorCode::kFileUnreadable, "/stick/plan.tif", "No such file or directory");
    };
    emit window.copyChosen(copyOf(tiled, PlanCopyKind::kPng, "a.png"));
    ASSERT_TRUE(told());
    EXPECT_TRUE(banner().contains("/stick/plan.tif cannot be read")) << banner().toStdString();
    EXPECT_TRUE(files().isEmpty());
}

TEST_F(CopiesOfAPlan, SayInOneSentenceThatTheDiskIsFull) {
    const SmallDisk disk(folder.filePath("disk").toStdString(), "size=64k");
    if (!disk.mounted()) GTEST_SKIP() << "mounting a small disk needs more rights";
    emit window.copyChosen(copyOf(noise(1000), PlanCopyKind::kGeoTiff, "disk/a.tif"));
    ASSERT_TRUE(told());
    EXPECT_TRUE(banner().contains("is full")) << banner().toStdString();
    EXPECT_TRUE(fs::is_empty(folder.filePath("disk").toStdString()));
}

}  // namespace
}  // namespace hedr
