#pragma once

#include <QObject>
#include <QString>

#include "ui/map/map_tool.h"
#include "ui/panels/card.h"

namespace hedr {

// One kind of work on the map: a title and a hint above the map, a card beside it, and a tool for
// the pointer. Nothing is kept until it is accepted.
class DeskPage : public QObject, public MapTool {
    Q_OBJECT

  public:
    using QObject::QObject;

    virtual QString title() const = 0;
    virtual QString hint() const = 0;  // what to do next
    virtual Card* card() = 0;          // on the map's right side
    virtual void begin() = 0;          // the page has come up
    virtual bool canUndo() const = 0;
    virtual void undo() = 0;
    virtual bool canAccept() const { return true; }
    virtual void cancel() = 0;
    virtual void accept() = 0;
    // An arrow key: by so much on the screen. False: the key is free to move the map.
    virtual bool nudge(Vector<View>) { return false; }

  signals:
    void changed();   // title, hint, what can be undone, what the tool paints
    void finished();  // accepted or canceled by itself
};

}  // namespace hedr
