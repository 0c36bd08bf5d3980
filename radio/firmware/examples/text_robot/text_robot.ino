// text_robot - an Arduino robot with two encoders and a gyro that prints lines of text.
//
// Copyright (c) 2026, the HEDR operator control unit authors
// SPDX-License-Identifier: BSD-2-Clause (the text is in hedr_robot.h)
//
// Nothing but print: a header line that names the columns with their units, then a line of numbers
// fifty times a second. docs/text_robots.md has the names that are understood.

// Encoders: channel A on a pin that can interrupt, channel B on any.
const uint8_t kLeftA = 2, kLeftB = 4, kRightA = 3, kRightB = 5;

// An analogue gyro of 10 mV per deg/s on a 10-bit, 5 V input, counter-clockwise positive.
const uint8_t kGyroPin = A0;
const float kGyroDpsPerCount = 0.48828f;

const uint32_t kPeriod_ms = 20;

volatile long left_ticks = 0;
volatile long right_ticks = 0;
uint32_t last_line_ms = 0;

// Called where A rises: B tells the direction.
void leftTick() { left_ticks = left_ticks + (digitalRead(kLeftB) ? 1 : -1); }
void rightTick() { right_ticks = right_ticks + (digitalRead(kRightB) ? 1 : -1); }

void setup() {
    Serial.begin(57600);
    pinMode(kLeftB, INPUT_PULLUP);
    pinMode(kRightB, INPUT_PULLUP);
    pinMode(kLeftA, INPUT_PULLUP);
    pinMode(kRightA, INPUT_PULLUP);
    attachInterrupt(digitalPinToInterrupt(kLeftA), leftTick, RISING);
    attachInterrupt(digitalPinToInterrupt(kRightA), rightTick, RISING);
    Serial.println("# text robot ready");  // words are allowed
    Serial.println("t_ms,left_ticks,right_ticks,gyro_dps");
}

void loop() {
    const uint32_t now_ms = millis();
    if (now_ms - last_line_ms < kPeriod_ms) return;
    last_line_ms = now_ms;

    noInterrupts();  // a count has four bytes, and an interrupt may change it between two of them
    const long left = left_ticks;
    const long right = right_ticks;
    interrupts();

    Serial.print(now_ms);
    Serial.print(',');
    Serial.print(left);
    Serial.print(',');
    Serial.print(right);
    Serial.print(',');
    Serial.println((float)(analogRead(kGyroPin) - 512) * kGyroDpsPerCount);
}
