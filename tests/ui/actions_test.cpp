#include "ui/actions.h"

#include <gtest/gtest.h>

#include <QFile>
#include <set>

#include "ui/fonts.h"

namespace hedr {
namespace {

TEST(Actions, AllHaveATextATipAKeyOfTheirOwnAndAnIcon) {
    uiFont(12);  // brings the resources in
    std::set<QString> keys;
    std::set<QString> texts;
    for (const ActionEntry& entry : actionTable()) {
        EXPECT_FALSE(entry.text.isEmpty());
        EXPECT_FALSE(entry.tip.isEmpty()) << entry.text.toStdString();
        EXPECT_FALSE(entry.key.isEmpty()) << entry.text.toStdString();
        EXPECT_TRUE(keys.insert(entry.key.toString()).second) << entry.text.toStdString();
        EXPECT_TRUE(texts.insert(entry.text).second) << entry.text.toStdString();
        const QString icon = QStringLiteral(":/icons/%1.svg").arg(entry.icon);
        EXPECT_TRUE(QFile::exists(icon)) << icon.toStdString();
    }
}

TEST(Actions, AreEachInTheTableOnce) {
    std::set<ActionId> ids;
    for (const ActionEntry& entry : actionTable()) {
        EXPECT_TRUE(ids.insert(entry.id).second) << entry.text.toStdString();
    }
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(ActionId::kQuit) + 1);
}

}  // namespace
}  // namespace hedr
