#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <string_view>

#include "app/calibration_keeper.h"
#include "app/session.h"
#include "app/settings_store.h"
#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/procedures.h"
#include "ui/main_window.h"
#include "ui/panels/banner.h"

namespace hedr {

// An operator who calibrates by keys only a robot that talks over a pseudo-terminal.
class CalibratingOperator : public testing::Test {
  protected:
    explicit CalibratingOperator(const Session::Setup& setup = {}) : session(window, setup) {
        saveSettings({});
        std::filesystem::remove_all(own_vehicle.parent_path());
        window.resize(1280, 800);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~CalibratingOperator() override { saveSettings({}); }

    void press(Qt::Key key) {
        QTest::keyClick(window.focusWidget() ? window.focusWidget() : &window, key);
    }
    bool hearsSensors() const { return window.fleet().chosen().model.last().vehicle.has_value(); }
    void begin(std::string_view procedure) {
        session.connectToAll({port});
        choose(procedure);
    }
    void choose(std::string_view procedure) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return hearsSensors(); }, 20000));
        const auto row = std::ranges::find(procedures(), procedure, &Procedure::name);
        press(Qt::Key_K);
        for (auto i = procedures().begin(); i != row; ++i) press(Qt::Key_Down);
        press(Qt::Key_Return);
    }
    // Into the field of that number from above.
    void type(int field, const QString& text) {
        int index = 0;
        for (auto* candidate : window.findChildren<QLineEdit*>()) {
            if (!candidate->isVisible() || index++ != field) continue;
            candidate->setFocus();
            QTest::keyClicks(candidate, text);
            return press(Qt::Key_Return);
        }
        ADD_FAILURE() << "no field " << field;
    }
    bool says(const QString& words) const {
        return std::ranges::any_of(window.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    QAbstractButton* button(const QString& text) const {
        for (auto* candidate : window.findChildren<QAbstractButton*>()) {
            if (candidate->isVisible() && candidate->text() == text) return candidate;
        }
        return nullptr;
    }
    // Its pose stays for a while.
    bool stands() const {
        const LiveModel& model = window.fleet().chosen().model;
        const auto before = model.pose();
        constexpr int kWatch_ms = 500;
        QTest::qWait(kWatch_ms);
        return before && model.pose() && before->position == model.pose()->position;
    }
    bool canAccept() const {
        const auto* here = button("Accept here only");
        return here || (button("Accept") && button("Accept")->isEnabled());
    }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }
    // When the verdict allows it; the vehicle as the file has it then.
    Vehicle accept() {
        EXPECT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 120000));
        press(Qt::Key_Return);
        EXPECT_TRUE(QTest::qWaitFor([&] { return banner().startsWith("Kept."); }, 20000))
            << banner().toStdString();
        return loadVehicle(own_vehicle).value_or(Vehicle{});
    }

    const std::filesystem::path own_vehicle = ownVehicleFile("test");
    QTemporaryDir folder;
    QString port = folder.filePath("robot");
    MainWindow window;
    Session session;
};

}  // namespace hedr
