#pragma once

#include <gtest/gtest.h>

#include <QColor>
#include <QFile>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <vector>

namespace hedr::test {

// A folder with drawings of floors, made for one test.
class PlanFiles {
  public:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QString addImage(const QString& name, const QSize& size = {400, 300},
                     const QColor& wall = Qt::black) const {
        QImage image(size, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setPen(QPen(wall, 6.0));
        const int w = size.width();
        const int h = size.height();
        painter.drawRect(w / 20, h / 20, w * 18 / 20, h * 18 / 20);
        painter.drawLine(w / 20, h / 2, w * 2 / 5, h / 2);
        painter.drawLine(w * 3 / 5, h / 20, w * 3 / 5, h * 19 / 20);
        painter.end();
        EXPECT_TRUE(image.save(path(name)));
        return path(name);
    }
    // A wall around each page, and in it as many rooms as the page's number.
    QString addPdf(const QString& name, const std::vector<QPageSize::PageSizeId>& pages) const {
        QPdfWriter writer(path(name));
        writer.setPageMargins({});
        writer.setPageSize(QPageSize(pages.front()));
        QPainter painter(&writer);
        for (std::size_t i = 0; i < pages.size(); ++i) {
            if (i > 0) {
                writer.setPageSize(QPageSize(pages[i]));
                writer.newPage();
            }
            const int w = writer.width();
            const int h = writer.height();
            painter.setPen(QPen(Qt::black, w / 50.0));
            painter.drawRect(w / 10, h / 10, w * 8 / 10, h * 8 / 10);
            for (int square = 0; square <= static_cast<int>(i); ++square) {
                painter.drawRect(w / 5 + square * w / 6, h / 3, w / 8, w / 8);
            }
        }
        return path(name);
    }
    QString addText(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return path(name);
    }

  private:
    QTemporaryDir folder_;
};

}  // namespace hedr::test
