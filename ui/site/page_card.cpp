#include "ui/site/page_card.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>

#include "ui/fonts.h"
#include "ui/icons.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr QSize kPicture_px{160, 120};
constexpr QSize kCell_px{192, 176};
constexpr int kMostRows = 2;  // that are seen without scrolling

// All pictures have one size, so that the words below them are in line.
QPixmap onSheet(const QImage& picture, const Theme& theme, double device_ratio) {
    QPixmap sheet(kPicture_px * device_ratio);
    sheet.setDevicePixelRatio(device_ratio);
    sheet.fill(Qt::transparent);
    QPainter painter(&sheet);
    if (picture.isNull()) {
        constexpr int kPlanIcon_px = 40;
        painter.drawPixmap(
            (kPicture_px.width() - kPlanIcon_px) / 2, (kPicture_px.height() - kPlanIcon_px) / 2,
            iconPixmap(QStringLiteral("plan"), theme.dim, kPlanIcon_px, device_ratio));
        return sheet;
    }
    const QImage small =
        picture.scaled(kPicture_px * device_ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QRect shown({}, small.size() / device_ratio);
    shown.moveCenter(QRect({}, kPicture_px).center());
    painter.drawImage(shown, themedPicture(small, theme));
    painter.setPen(theme.hairline);
    painter.drawRect(shown.adjusted(0, 0, -1, -1));
    return sheet;
}

}  // namespace

std::optional<double> paperScaleOf(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^\\s*(?:1\\s*[:/]\\s*)?([0-9.,]+)\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    bool ok = false;
    const double scale = match.captured(1).replace(u',', u'.').toDouble(&ok);
    constexpr double kLargest = 1e6;
    return ok && scale > 0.0 && scale <= kLargest ? std::optional(scale) : std::nullopt;
}

PageCard::PageCard(QWidget* parent)
    : Card(parent),
      title_(new QLabel(this)),
      name_(new QLabel(this)),
      pages_(new QListWidget(this)),
      scale_label_(new QLabel(tr("Scale of the paper, if you know it"), this)),
      scale_(new QLineEdit(this)),
      advice_(new QLabel(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      open_(new QPushButton(tr("Open"), this)) {
    setAccessibleName(tr("Pages of a file"));
    title_->setProperty("role", QStringLiteral("title"));
    pages_->setAccessibleName(tr("Pages"));
    pages_->setViewMode(QListView::IconMode);
    pages_->setMovement(QListView::Static);
    pages_->setResizeMode(QListView::Adjust);
    pages_->setUniformItemSizes(true);
    pages_->setFrameShape(QFrame::NoFrame);
    pages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    pages_->setIconSize(kPicture_px);
    pages_->setGridSize(kCell_px);
    scale_label_->setBuddy(scale_);
    scale_->setObjectName(QStringLiteral("paper_scale"));
    scale_->setAccessibleName(scale_label_->text());
    scale_->setPlaceholderText(tr("1 : 100"));
    layOut();
    connect(pages_, &QListWidget::itemDoubleClicked, this, &PageCard::choose);
    connect(pages_, &QListWidget::currentRowChanged, this, &PageCard::updateButton);
    connect(scale_, &QLineEdit::textChanged, this, &PageCard::updateButton);
    connect(cancel_, &QPushButton::clicked, this, &PageCard::closeWished);
    connect(open_, &QPushButton::clicked, this, &PageCard::choose);
    setVisible(false);
}

void PageCard::layOut() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(20, 20, 20, 20);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->addWidget(title_, 0, 0, 1, 2);
    grid->addWidget(name_, 1, 0, 1, 2);
    grid->addWidget(pages_, 2, 0, 1, 2);
    grid->addWidget(scale_label_, 3, 0, 1, 2);
    grid->addWidget(scale_, 4, 0, 1, 2);
    grid->addWidget(advice_, 5, 0, 1, 2);
    grid->setRowMinimumHeight(6, 8);
    grid->addWidget(cancel_, 7, 0);
    grid->addWidget(open_, 7, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
}

void PageCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : {title_, name_, scale_label_, advice_}) {
        label->setStyleSheet(formSheet(theme));
    }
    scale_->setStyleSheet(formSheet(theme));
    pages_->setStyleSheet(pictureListSheet(theme));
    cancel_->setStyleSheet(buttonSheet(theme));
    open_->setStyleSheet(primaryButtonSheet(theme));
    for (int page = 1; page <= pages_->count(); ++page) showPicture(page);
    fitToPages();
}

void PageCard::setFile(const QString& file, const std::vector<QString>& pages) {
    file_ = file;
    pictures_.assign(pages.size(), {});
    title_->setText(pages.size() == 1 ? tr("What is its scale?") : tr("Which page is the plan?"));
    scale_->clear();
    pages_->clear();
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const int page = static_cast<int>(i) + 1;
        pages_->addItem(tr("Page %1\n%2").arg(page).arg(pages[i]));
        showPicture(page);
    }
    pages_->setCurrentRow(0);
    fitToPages();
    name_->setText(name_->fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle,
                                                   2 * kCell_px.width()));
}

void PageCard::focusFirst() { pages_->count() > 1 ? pages_->setFocus() : scale_->setFocus(); }

void PageCard::setGlance(const PlanFileWish& page, const PlanGlance& glance) {
    if (page.file != file_ || page.choice.page < 1 || page.choice.page > pages_->count()) return;
    pictures_.at(static_cast<std::size_t>(page.choice.page - 1)) = glance.picture;
    showPicture(page.choice.page);
}

void PageCard::showPicture(int page) {
    const QImage& picture = pictures_.at(static_cast<std::size_t>(page - 1));
    QIcon icon;
    // A chosen page looks as the others do: its frame tells.
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) {
        icon.addPixmap(onSheet(picture, theme(), devicePixelRatioF()), mode);
    }
    pages_->item(page - 1)->setIcon(icon);
}

void PageCard::fitToPages() {
    const int rows = std::clamp((pages_->count() + 1) / 2, 1, kMostRows);
    constexpr int kScrollBar_px = 12;
    pages_->setFixedSize(2 * kCell_px.width() + kScrollBar_px, rows * kCell_px.height() + 4);
    for (QWidget* child : findChildren<QWidget*>()) child->ensurePolished();
    updateButton();
}

void PageCard::updateButton() {
    const bool usable = scale_->text().trimmed().isEmpty() || paperScaleOf(scale_->text());
    advice_->setText(usable ? QString() : tr("Write it as 1 : 100, or leave it empty."));
    advice_->setVisible(!usable);
    open_->setEnabled(usable && pages_->currentRow() >= 0);
    layout()->activate();
    resize(sizeHint());
}

void PageCard::choose() {
    if (!open_->isEnabled()) return;
    PlanFileWish wish{.file = file_, .choice = {.page = pages_->currentRow() + 1}};
    if (const auto scale = paperScaleOf(scale_->text())) wish.choice.paper_scale = *scale;
    emit chosen(wish);
}

void PageCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        choose();
    } else if (event->key() == Qt::Key_Escape) {
        emit closeWished();
    } else {
        Card::keyPressEvent(event);
    }
}

}  // namespace hedr
