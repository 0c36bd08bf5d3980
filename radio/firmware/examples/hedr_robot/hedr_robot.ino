// hedr_robot - an Arduino robot with two encoders and a gyro that speaks the HEDR protocol.
//
// Copyright (c) 2026, the HEDR operator control unit authors
// SPDX-License-Identifier: BSD-2-Clause (the text is in hedr_robot.h)
//
// Copy hedr_robot.h into this folder, set the numbers below, upload, connect. The robot computes
// its own pose, sends it with what its sensors say, and answers what the laptop asks.
#include "hedr_robot.h"

// Encoders: channel A on a pin that can interrupt, channel B on any.
const uint8_t kLeftA = 2, kLeftB = 4, kRightA = 3, kRightB = 5;

// An analogue gyro of 10 mV per deg/s on a 10-bit, 5 V input, counter-clockwise positive. For one
// on I2C put its reading into gyroRate_urad_s().
const uint8_t kGyroPin = A0;
const int32_t kGyroMiddle = 512;         // the rest of its bias is measured while the robot stands
const int32_t kGyroUradPerCount = 8522;  // 0.488 deg/s

const uint32_t kPeriod_us = 20000;  // 50 samples a second

volatile int32_t left_ticks = 0;
volatile int32_t right_ticks = 0;

hedr_robot robot;
hedr_decoder decoder;
hedr_hello hello;
uint8_t frame[HEDR_FRAME_MAX];
uint16_t sequence = 0;
uint32_t last_sample_us = 0;
int samples = 0;

// Called where A rises: B tells the direction.
void leftTick() { left_ticks = left_ticks + (digitalRead(kLeftB) ? 1 : -1); }
void rightTick() { right_ticks = right_ticks + (digitalRead(kRightB) ? 1 : -1); }

int32_t gyroRate_urad_s() { return (analogRead(kGyroPin) - kGyroMiddle) * kGyroUradPerCount; }

void send(uint8_t size) {
    Serial.write(frame, size);
    ++sequence;
}

void setup() {
    Serial.begin(57600);
    pinMode(kLeftB, INPUT_PULLUP);
    pinMode(kRightB, INPUT_PULLUP);
    pinMode(kLeftA, INPUT_PULLUP);
    pinMode(kRightA, INPUT_PULLUP);
    attachInterrupt(digitalPinToInterrupt(kLeftA), leftTick, RISING);
    attachInterrupt(digitalPinToInterrupt(kRightA), rightTick, RISING);

    hedr_config config = hedr_default_config();
    config.left_wheel_diameter_um = 65000;  // measure yours
    config.right_wheel_diameter_um = 65000;
    config.wheelbase_um = 150000;
    config.ticks_per_revolution_milli = 360000;
    hedr_robot_init(&robot, &config);
    hedr_decoder_init(&decoder);

    // Another number after every restart: the noise of an open input. EEPROM is surer.
    hello.boot_id = micros() ^ ((uint32_t)analogRead(A5) << 16);
    hello.capabilities = HEDR_HAS_GYRO | HEDR_HAS_HEDR | HEDR_OBEYS_REQUESTS;
    hello.left_wheel_diameter_um = config.left_wheel_diameter_um;
    hello.right_wheel_diameter_um = config.right_wheel_diameter_um;
    hello.wheelbase_um = config.wheelbase_um;
    hello.ticks_per_revolution_milli = config.ticks_per_revolution_milli;
    hello.heading_source = config.heading_source;
    hello.vehicle = "Arduino robot";
    hello.firmware = "hedr_robot example";
}

void answerRequests() {
    hedr_request request;
    while (Serial.available() > 0) {
        if (hedr_decoder_push(&decoder, (uint8_t)Serial.read(), &request)) {
            send(hedr_robot_answer(&robot, &request, micros(), frame, sequence));
        }
    }
}

void sample(uint32_t now_us) {
    noInterrupts();  // a count has four bytes, and an interrupt may change it between two of them
    const int32_t left = left_ticks;
    const int32_t right = right_ticks;
    interrupts();
    hedr_robot_update(&robot, now_us, left, right, gyroRate_urad_s());
}

void loop() {
    answerRequests();
    const uint32_t now_us = micros();
    if (now_us - last_sample_us < kPeriod_us) return;
    last_sample_us = now_us;

    sample(now_us);
    if (samples % 50 == 0) send(hedr_encode_hello(frame, sequence, &hello));
    if (samples % 2 == 0) {
        const hedr_pose pose = hedr_robot_pose(&robot);
        send(hedr_encode_pose(frame, sequence, &pose));
    }
    const hedr_sensors sensors = hedr_robot_sensors(&robot);
    send(hedr_encode_sensors(frame, sequence, &sensors));
    samples = (samples + 1) % 50;
}
