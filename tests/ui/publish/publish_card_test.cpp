#include "ui/publish/publish_card.h"

#include <gtest/gtest.h>

#include <QTest>

namespace hedr {
namespace {

class CardOfPublishing : public testing::Test {
  protected:
    CardOfPublishing() {
        card.setTheme(dayTheme());
        card.QWidget::show();
        QObject::connect(&card, &PublishCard::targetsWished,
                         [this](const std::vector<PublishTarget>& targets) { wished = targets; });
    }
    QCheckBox* on(const char* word) const { return card.findChild<QCheckBox*>(word); }
    QLineEdit* address(const char* word) const {
        return card.findChild<QLineEdit*>(QString(word) + "_address");
    }
    QString state(const char* word) const {
        const auto* label = card.findChild<QLabel*>(QString(word) + "_state");
        return label->isVisibleTo(&card) ? label->text() : QString();
    }

    PublishCard card;
    std::optional<std::vector<PublishTarget>> wished;
};

TEST_F(CardOfPublishing, HasEverythingOffAtFirst) {
    card.show({});
    for (const char* word : {"json", "nmea", "cot"}) {
        EXPECT_FALSE(on(word)->isChecked()) << word;
        EXPECT_EQ(state(word), "") << word;
    }
    EXPECT_FALSE(wished);
}

TEST_F(CardOfPublishing, AClickWishesTheDefaultWhichIsThisComputer) {
    on("json")->click();
    ASSERT_TRUE(wished);
    EXPECT_EQ(*wished, std::vector{defaultTarget(PublishKind::kJson)});
    EXPECT_FALSE(leavesThisComputer(wished->front()));
    card.show({{.target = wished->front(), .port = 10120}});
    EXPECT_EQ(state("json"), "Nobody listens yet.");
    card.show({{.target = wished->front(), .port = 10120, .clients = 2}});
    EXPECT_EQ(state("json"), "2 programs listen.");
    on("json")->click();
    EXPECT_TRUE(wished->empty());
    card.show({});
    EXPECT_EQ(state("json"), "");
}

TEST_F(CardOfPublishing, SaysThatOthersCanHear) {
    address("cot")->setText("udp://239.2.3.1:6969");
    on("cot")->click();
    ASSERT_EQ(wished->size(), 1U);
    card.show({{.target = wished->front()}});
    EXPECT_EQ(state("cot"), "Sent. Others on the network can read it.");
}

TEST_F(CardOfPublishing, AWrongAddressIsSaidAndStaysOff) {
    address("nmea")->setText("nowhere");
    on("nmea")->click();
    EXPECT_FALSE(on("nmea")->isChecked());
    ASSERT_TRUE(wished);
    EXPECT_TRUE(wished->empty());
    EXPECT_FALSE(state("nmea").isEmpty());
    card.show({});
    EXPECT_FALSE(state("nmea").isEmpty()) << "it is still wrong";
}

TEST_F(CardOfPublishing, ShowsWhatTheCommandLineSwitchedOn) {
    const auto target = parsePublishTarget("nmea=tcp://:2000");
    ASSERT_TRUE(target);
    card.show({{.target = *target, .error = Error{ErrorCode::kNotOnGlobe, "NMEA", {}}}});
    EXPECT_TRUE(on("nmea")->isChecked());
    EXPECT_EQ(address("nmea")->text(), addressText(*target));
    EXPECT_TRUE(state("nmea").contains("latitude")) << state("nmea").toStdString();
    EXPECT_FALSE(wished) << "nothing to wish for";
}

}  // namespace
}  // namespace hedr
