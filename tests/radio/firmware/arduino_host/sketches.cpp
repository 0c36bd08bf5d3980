#include "tests/radio/firmware/arduino_host/sketches.h"

#include "radio/firmware/hedr_robot.h"
#include "tests/radio/firmware/arduino_host/Arduino.h"

// What its author copies beside the sketch is above: no second one is read.
namespace hedr_sketch {
#include "radio/firmware/examples/hedr_robot/hedr_robot.ino"
}  // namespace hedr_sketch

namespace text_sketch {
#include "radio/firmware/examples/text_robot/text_robot.ino"
}  // namespace text_sketch
