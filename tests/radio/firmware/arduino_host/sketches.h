#pragma once

// The example sketches, each in a namespace of its own: all of them are called setup and loop.
namespace hedr_sketch {
void setup();
void loop();
}  // namespace hedr_sketch

namespace text_sketch {
void setup();
void loop();
}  // namespace text_sketch
