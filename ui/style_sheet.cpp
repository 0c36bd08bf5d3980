#include "ui/style_sheet.h"

#include "ui/fonts.h"

namespace hedr {
namespace {

QString filled(QString sheet, const Theme& theme) {
    const bool day = theme.name == ThemeName::kDay;
    const QColor on_accent = day ? theme.paper : theme.background;
    const QColor accent_hover = day ? theme.accent.darker(112) : theme.accent.lighter(108);
    const QColor chip_hover = day ? theme.chip.darker(104) : theme.chip.lighter(125);
    return sheet.replace("@family", uiFont(16).family())
        .replace("@chip-hover", chip_hover.name())
        .replace("@chip", theme.chip.name())
        .replace("@tick", day ? "check-light" : "check-dark")
        .replace("@ink", theme.ink.name())
        .replace("@dim", theme.dim.name())
        .replace("@good", theme.good.name())
        .replace("@warning", theme.warning.name())
        .replace("@alarm", theme.alarm.name())
        .replace("@hairline", theme.hairline.name())
        .replace("@chrome", theme.chrome.name())
        .replace("@accent-hover", accent_hover.name())
        .replace("@on-accent", on_accent.name())
        .replace("@accent", theme.accent.name());
}

constexpr const char* kButton = R"(
QPushButton { font: 600 16px "@family"; padding: 0 20px; min-height: 44px; border-radius: 8px;
    border: 2px solid transparent; background: @chip; color: @ink; }
QPushButton:hover { background: @chip-hover; }
QPushButton:focus { border-color: @accent; }
QPushButton:disabled { color: @dim; }
)";

constexpr const char* kPrimaryButton = R"(
QPushButton { font: 600 16px "@family"; padding: 0 24px; min-height: 44px; border-radius: 8px;
    border: 2px solid transparent; background: @accent; color: @on-accent; }
QPushButton:hover { background: @accent-hover; }
QPushButton:focus { border-color: @ink; }
QPushButton:disabled { background: @chip; color: @dim; }
)";

constexpr const char* kFlatButton = R"(
QPushButton { font: 500 13px "@family"; text-align: left; padding: 0 12px; border-radius: 8px;
    border: 2px solid transparent; background: transparent; color: @dim; }
QPushButton:hover { background: @chip; color: @ink; }
QPushButton:focus { border-color: @accent; background: @chip; }
)";

constexpr const char* kMenuIndicator = R"(
QPushButton { padding-right: 8px; }
QPushButton::menu-indicator { image: url(:/icons/chevron.svg); width: 14px; height: 14px;
    subcontrol-position: right center; right: 6px; }
)";

constexpr const char* kSegment = R"(
QPushButton { font: 500 14px "@family"; padding: 0 4px; min-height: 36px; border-radius: 8px;
    border: 2px solid transparent; background: transparent; color: @dim; }
QPushButton:hover { color: @ink; }
QPushButton:checked { background: @chip; color: @ink; }
QPushButton:focus { border-color: @accent; }
QPushButton:disabled { color: @hairline; }
)";

// A field that looks like a title until it is used.
constexpr const char* kQuietField = R"(
QLineEdit { font: 600 20px "@family"; color: @ink; background: transparent; min-height: 36px;
    border: 2px solid transparent; border-radius: 8px; margin-left: -4px;
    selection-background-color: @accent; selection-color: @on-accent; }
QLineEdit:hover { background: @chip; }
QLineEdit:focus { border-color: @accent; padding: 0 8px; }
)";

constexpr const char* kSlider = R"(
QSlider { min-height: 28px; background: transparent; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @hairline; }
QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: @accent; }
QSlider::sub-page:horizontal:disabled { background: @hairline; }
QSlider::handle:horizontal { width: 18px; margin: -7px 0; border-radius: 9px; background: @accent; }
QSlider::handle:horizontal:disabled { background: @dim; }
QSlider::handle:horizontal:focus { border: 2px solid @ink; width: 14px; }
)";

constexpr const char* kMenu = R"(
QMenu { font: 15px "@family"; color: @ink; background: @chrome; border: 1px solid @hairline;
    padding: 4px; }
QMenu::item { padding: 8px 24px 8px 16px; border-radius: 6px; }
QMenu::item:selected { background: @chip; }
QMenu::item:disabled { color: @dim; }
QMenu::separator { height: 1px; margin: 4px 8px; background: @hairline; }
QMenu::indicator { width: 16px; height: 16px; margin-left: 8px; border-radius: 4px;
    border: 2px solid @dim; }
QMenu::indicator:checked { border-color: @accent; background: @accent;
    image: url(:/icons/@tick.svg); }
)";

constexpr const char* kScroll = R"(
QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }
QScrollBar:vertical { width: 7px; background: transparent; margin: 0; }
QScrollBar::handle:vertical { background: @dim; border-radius: 3px; min-height: 32px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

constexpr const char* kPictureList = R"(
QListWidget { font: 500 13px "@family"; color: @dim; background: transparent; outline: none; }
QListWidget::item { border: 2px solid transparent; border-radius: 8px; padding: 6px; }
QListWidget::item:hover { background: @chip; color: @ink; }
QListWidget::item:selected { background: @chip; color: @ink; }
QListWidget::item:focus { border-color: @accent; }
)";

constexpr const char* kDialog = R"(
QDialog, QSplitter, QMenu { background: @chrome; color: @ink; }
QLabel, QHeaderView::section, QMenu { font: 500 14px "@family"; color: @dim;
    background: transparent; border: none; }
QLabel#name { font: 600 16px "@family"; color: @ink; }
QLabel#words { font: 15px "@family"; color: @ink; }
QLabel#picture { background: @chip; border-radius: 8px; }
QTreeView, QListView { font: 15px "@family"; color: @ink; background: @chrome; outline: none;
    border: 1px solid @hairline; border-radius: 8px; padding: 4px;
    selection-background-color: @chip; selection-color: @ink; }
QHeaderView { background: transparent; }
QHeaderView::section { padding: 8px; }
QTreeView::item, QListView::item { min-height: 28px; border: none; }
QTreeView::item:hover, QListView::item:hover, QTreeView::item:selected, QListView::item:selected {
    background: @chip; color: @ink; }
QLineEdit, QComboBox { font: 15px "@family"; color: @ink; background: @chrome;
    border: 1px solid @hairline; border-radius: 8px; padding: 0 12px; min-height: 36px;
    selection-background-color: @accent; selection-color: @on-accent; }
QLineEdit:focus, QComboBox:focus { border: 2px solid @accent; padding: 0 11px; min-height: 34px; }
QComboBox::drop-down { width: 32px; border: none; }
QComboBox::down-arrow { image: url(:/icons/chevron.svg); width: 18px; height: 18px; }
QComboBox QAbstractItemView { padding: 4px; border-radius: 0; }
QPushButton { font: 600 15px "@family"; padding: 0 20px; min-height: 40px; border-radius: 8px;
    border: 2px solid transparent; background: @chip; color: @ink; }
QPushButton:default { background: @accent; color: @on-accent; }
QPushButton:focus { border-color: @ink; }
QPushButton:disabled { background: @chip; color: @dim; }
QToolButton { border: 2px solid transparent; border-radius: 8px; background: transparent; }
QToolButton:hover, QToolButton:checked { background: @chip; }
QToolButton:focus { border-color: @accent; }
)";

constexpr const char* kForm = R"(
QLabel { font: 500 13px "@family"; color: @dim; background: transparent; }
QLabel[role="title"] { font: 600 20px "@family"; color: @ink; }
QLabel[role="text"] { font: 15px "@family"; color: @ink; }
QLabel[role="value"] { font: 600 25px "@family"; color: @ink; }
QLabel[role="hint"] { font: 15px "@family"; color: @dim; }
QLabel[tone="good"] { color: @good; }
QLabel[tone="warning"] { color: @warning; }
QLabel[tone="alarm"] { color: @alarm; }
QCheckBox { font: 15px "@family"; color: @ink; spacing: 8px; min-height: 32px; }
QCheckBox::indicator { width: 16px; height: 16px; border-radius: 4px; border: 2px solid @dim;
    background: @chrome; }
QCheckBox::indicator:checked { border-color: @accent; background: @accent; 
    image: url(:/icons/@tick.svg); }
QCheckBox:focus { color: @accent; }
QComboBox, QLineEdit { font: 16px "@family"; color: @ink; background: @chrome;
    border: 1px solid @hairline; border-radius: 8px; padding: 0 12px; min-height: 44px;
    selection-background-color: @accent; selection-color: @on-accent; }
QComboBox:focus, QLineEdit:focus { border: 2px solid @accent; padding: 0 11px; min-height: 42px; }
QComboBox QLineEdit, QComboBox QLineEdit:focus { border: none; padding: 0; min-height: 0;
    background: transparent; }
QComboBox::drop-down { width: 36px; border: none; }
QComboBox::down-arrow { image: url(:/icons/chevron.svg); width: 18px; height: 18px; }
QComboBox QAbstractItemView { font: 16px "@family"; color: @ink; background: @chrome;
    border: 1px solid @hairline; outline: none; padding: 4px;
    selection-background-color: @chip; selection-color: @ink; }
QProgressBar { border: none; border-radius: 4px; background: @chip; max-height: 8px; }
QProgressBar::chunk { border-radius: 4px; background: @accent; }
)";

}  // namespace

QString primaryButtonSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kPrimaryButton), theme);
}

QString buttonSheet(const Theme& theme) { return filled(QString::fromLatin1(kButton), theme); }

QString flatButtonSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kFlatButton), theme);
}

QString flatMenuButtonSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kFlatButton) + QString::fromLatin1(kMenuIndicator), theme);
}

QString segmentSheet(const Theme& theme) { return filled(QString::fromLatin1(kSegment), theme); }

QString quietFieldSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kQuietField), theme);
}

QString sliderSheet(const Theme& theme) { return filled(QString::fromLatin1(kSlider), theme); }

QString menuSheet(const Theme& theme) { return filled(QString::fromLatin1(kMenu), theme); }

QString scrollSheet(const Theme& theme) { return filled(QString::fromLatin1(kScroll), theme); }

QString pictureListSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kPictureList) + QString::fromLatin1(kScroll), theme);
}

QString dialogSheet(const Theme& theme) {
    return filled(QString::fromLatin1(kDialog) + QString::fromLatin1(kScroll), theme);
}

QString formSheet(const Theme& theme) { return filled(QString::fromLatin1(kForm), theme); }

}  // namespace hedr
