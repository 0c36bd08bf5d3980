#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>

// As much of an Arduino as the example sketches use, on the host: its pins and its clock are set by
// the test, and what it prints is kept.

inline constexpr std::uint8_t A0 = 14;
inline constexpr std::uint8_t A5 = 19;
inline constexpr int INPUT_PULLUP = 2;
inline constexpr int RISING = 3;

struct ArduinoHost {
    std::uint64_t time_us = 0;
    std::array<int, 20> pins{};
    std::array<void (*)(), 20> on_rise{};
    bool interrupts_on = true;
    std::string printed;
    std::deque<std::uint8_t> received;
};

// The one machine that the sketches' free functions mean; each test gives it a fresh state.
inline ArduinoHost& arduinoHost() {
    static ArduinoHost host;
    return host;
}

class ArduinoSerial {
  public:
    void begin(long) {}
    int available() { return static_cast<int>(arduinoHost().received.size()); }
    int read() {
        const int byte = arduinoHost().received.front();
        arduinoHost().received.pop_front();
        return byte;
    }
    void write(const std::uint8_t* bytes, std::size_t size) {
        arduinoHost().printed.append(reinterpret_cast<const char*>(bytes), size);
    }
    void print(char c) { arduinoHost().printed += c; }
    void print(const char* text) { arduinoHost().printed += text; }
    void print(long number) { arduinoHost().printed += std::to_string(number); }
    void print(std::uint32_t number) { arduinoHost().printed += std::to_string(number); }
    void print(float number) { print(static_cast<double>(number)); }
    void print(double number) {  // two places, as there
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.2f", number);
        arduinoHost().printed += text.data();
    }
    template <class Value>
    void println(Value value) {
        print(value);
        arduinoHost().printed += "\r\n";
    }
};
inline ArduinoSerial Serial;

inline std::uint32_t micros() { return static_cast<std::uint32_t>(arduinoHost().time_us); }
inline std::uint32_t millis() { return static_cast<std::uint32_t>(arduinoHost().time_us / 1000); }
inline void pinMode(std::uint8_t, int) {}
inline int digitalRead(std::uint8_t pin) { return arduinoHost().pins[pin]; }
inline int analogRead(std::uint8_t pin) { return arduinoHost().pins[pin]; }
inline std::uint8_t digitalPinToInterrupt(std::uint8_t pin) { return pin; }
inline void attachInterrupt(std::uint8_t pin, void (*on_rise)(), int) {
    arduinoHost().on_rise[pin] = on_rise;
}
inline void noInterrupts() { arduinoHost().interrupts_on = false; }
inline void interrupts() { arduinoHost().interrupts_on = true; }
