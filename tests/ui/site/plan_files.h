#pragma once

#include <gtest/gtest.h>

#include <QColor>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>

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
