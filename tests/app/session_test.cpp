#include "app/session.h"

#include <gtest/gtest.h>

#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>

#include "app/settings_store.h"
#include "ui/main_window.h"
#include "ui/panels/banner.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// A session in front of which an operator drops files on the window.
class PlansOfASession : public testing::Test {
  protected:
    PlansOfASession() {
        saveSettings({});
        window.show();
    }
    ~PlansOfASession() override { saveSettings({}); }

    QString addImage(const QString& name) const {
        QImage image(64, 48, QImage::Format_RGB32);
        image.fill(Qt::white);
        EXPECT_TRUE(image.save(folder.filePath(name)));
        return folder.filePath(name);
    }
    void drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    }
    std::size_t plans() { return window.desk().site().floor().plans.size(); }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }

    QTemporaryDir folder;
    MainWindow window;
    Session session{window, {}};
};

TEST_F(PlansOfASession, LieOnOneAnotherAndAreRemembered) {
    const QString first = addImage("first.png");
    const QString second = addImage("second.png");
    drop({first, second});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 2; }, 20000));
    EXPECT_EQ(window.desk().site().floor().plans.back().image_file, second.toStdString());
    EXPECT_EQ(loadSettings().recent_plans, QStringList({second, first}));
    EXPECT_FALSE(window.findChild<PlanProgressCard*>()->isVisible());
}

TEST_F(PlansOfASession, AreNotRememberedWhereNobodyCanOpenThemAgain) {
    session.openPlan({.file = addImage("of-the-demo.png"), .lasting = false});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 1; }, 20000));
    EXPECT_TRUE(loadSettings().recent_plans.isEmpty());
}

TEST_F(PlansOfASession, AreSavedAsASiteThatIsSaidAndRemembered) {
    drop({addImage("plan.png")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 1; }, 20000));
    const QString file = folder.filePath("campus.site.toml");
    emit window.siteFileChosen(file);
    EXPECT_EQ(banner(), "Saved as campus.site.toml in the folder " + folder.path() + ".");
    EXPECT_EQ(loadSettings().recent_plans.front(), file);
}

TEST_F(PlansOfASession, AreOpenedThoughOneOfTheFilesIsNone) {
    QFile notes(folder.filePath("notes.txt"));
    ASSERT_TRUE(notes.open(QIODevice::WriteOnly));
    notes.write("no picture");
    notes.close();
    const QString plan = addImage("plan.png");
    drop({notes.fileName(), plan});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 1; }, 20000));
    EXPECT_TRUE(banner().contains("notes.txt is not an image that can be read"))
        << banner().toStdString();
    EXPECT_EQ(loadSettings().recent_plans, QStringList(plan));
}

TEST_F(PlansOfASession, AreNotOpenedOnceTheOperatorCancels) {
    session.openPlan({.file = addImage("first.png")});
    session.openPlan({.file = addImage("second.png")});
    emit window.planLoadCanceled();
    EXPECT_FALSE(window.findChild<PlanProgressCard*>()->isVisible());
    session.openPlan({.file = addImage("third.png")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 1; }, 20000));
    QTest::qWait(20);
    EXPECT_EQ(plans(), 1U);
    EXPECT_TRUE(banner().startsWith("third.png says no scale")) << banner().toStdString();
}

TEST_F(PlansOfASession, AreSeenCoarselyBeforeTheyAreLoaded) {
    QImage image(2600, 2000, QImage::Format_Grayscale8);
    image.fill(Qt::white);
    ASSERT_TRUE(image.save(folder.filePath("large.jpg")));
    bool coarse = false;
    const auto finest = [&] {
        return window.desk()
            .site()
            .image(window.desk().site().floor().plans.front())
            ->levels.front()
            .pixels;
    };
    QObject::connect(&window.desk().site(), &SiteModel::changed, &session, [&] {
        if (plans() == 1 && !finest()) coarse = true;
    });
    session.openPlan({.file = folder.filePath("large.jpg")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return plans() == 1 && finest(); }, 20000));
    EXPECT_TRUE(coarse);
    EXPECT_EQ(plans(), 1U);
}

}  // namespace
}  // namespace hedr
