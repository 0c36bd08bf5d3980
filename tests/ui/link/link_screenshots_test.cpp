#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QTest>

#include "tests/ui/scene.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/connect_card.h"

namespace hedr {
namespace {

// Pictures for people to look at, as those of screenshots_test.cpp.
void writePicture(const QString& name, MainWindow& window, QSize size) {
    QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
    window.resize(size);
    window.show();
    QTest::qWait(150);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.findChild<MapView*>()->isSharp(); }));
    const QString file =
        QStringLiteral(HEDR_BINARY_DIR "/screenshots/%1-%2.png").arg(name).arg(size.width());
    EXPECT_TRUE(window.grab().save(file)) << file.toStdString();
}

// A link that was good, then bad for a while.
std::vector<LinkSample> history() {
    std::vector<LinkSample> samples;
    for (int i = 0; i < 400; ++i) {
        const bool bad = i > 370 && i < 385;
        const double wave = 0.5 + 0.5 * std::sin(0.7 * i);
        samples.push_back({.receive_time_s = 1.0 * i,
                           .loss = bad ? 0.2 + 0.4 * wave : 0.01 * wave,
                           .frames_per_s = bad ? 60.0 : 120.0,
                           .bad_frames_per_s = bad ? 20.0 : 0.0,
                           .longest_gap_s = bad ? 1.5 * wave : 0.02,
                           .jitter_s = 0.004,
                           .round_trip_s = bad ? 0.4 + 0.3 * wave : 0.04 + 0.01 * wave,
                           .clock_offset_s = 3.0,
                           .radio_dbm = -71});
    }
    return samples;
}

LiveBatch batchOfARobotThatListens() {
    LiveBatch batch = test::sampleBatch(test::kDrive_s);
    batch.language = RobotLanguage::kHedr;
    batch.address = SerialAddress{"/dev/ttyUSB0", 57600};
    batch.robot->capabilities = kCapabilityRequests;
    batch.link_samples = history();
    const auto value = [](std::uint64_t ticket, RobotParameter id, std::int32_t raw) {
        return RequestProgress{.ticket = ticket,
                               .wish = ParameterGet{static_cast<std::uint8_t>(id)},
                               .state = RequestState::kDone,
                               .tries = 1,
                               .value = raw};
    };
    batch.requests = {
        value(1, RobotParameter::kLeftWheelDiameterUm, 183000),
        value(2, RobotParameter::kRightWheelDiameterUm, 183040),
        value(3, RobotParameter::kWheelbaseUm, 450000),
        value(4, RobotParameter::kTicksPerRevolutionMilli, 36000),
        value(5, RobotParameter::kHedrGainUradS2, 175),
        value(6, RobotParameter::kDominantDirections, 4),
        {.ticket = 7,
         .wish = ParameterGet{static_cast<std::uint8_t>(RobotParameter::kDominantOffset)},
         .state = RequestState::kNoAnswer,
         .tries = 20},
        {.ticket = 8,
         .wish = RobotCommand{.kind = CommandKind::kMeasureBias},
         .state = RequestState::kRefused,
         .tries = 2,
         .reason = AcknowledgeResult::kNotWhileMoving}};
    return batch;
}

TEST(LinkScreenshots, ShowTheCardsOfConnectLinkAndRobot) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        window.setTheme(theme);
        window.setPlan(test::samplePlan());
        const QString suffix = theme == ThemeName::kDay ? "day" : "night";
        auto* card = window.findChild<ConnectCard*>();
        card->setPorts({{"/dev/ttyUSB0", "FTDI FT232R USB UART A50285BI", "a"},
                        {"/dev/ttyACM0", "Arduino Uno 75833353035351D0", "b"},
                        {"/dev/ttyS0", "", ""}});
        window.show();
        QTest::keyClick(&window, Qt::Key_C);
        writePicture("connect-" + suffix, window, {1280, 800});
        hand.set(test::kDrive_s);
        window.applyBatch(batchOfARobotThatListens());
        QTest::keyClick(&window, Qt::Key_I);
        writePicture("link-" + suffix, window, {1600, 1000});
        QTest::keyClick(&window, Qt::Key_B);
        QTest::qWait(150);
        for (auto* field : window.findChildren<QLineEdit*>()) {
            if (field->text() == "450.000") field->setText("452.5");
        }
        writePicture("robot-" + suffix, window, {1600, 1000});
        writePicture("robot-" + suffix, window, {1024, 640});
    }
}

}  // namespace
}  // namespace hedr
