/* hedr_robot.h - speak the HEDR robot protocol from a microcontroller.
 *
 * Copyright (c) 2026, the HEDR operator control unit authors
 * SPDX-License-Identifier: BSD-2-Clause
 *
 * Redistribution and use in source and binary forms, with or without modification, are permitted
 * provided that the following conditions are met:
 * 1. Redistributions of source code must retain the above copyright notice, this list of conditions
 *    and the following disclaimer.
 * 2. Redistributions in binary form must reproduce the above copyright notice, this list of
 *    conditions and the following disclaimer in the documentation and/or other materials provided
 *    with the distribution.
 * THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND ANY EXPRESS OR
 * IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND
 * FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDER OR
 * CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL
 * DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF USE,
 * DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY,
 * WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY
 * WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.
 *
 * C99, integers only, no allocation, no globals that change. Right shifts of negative numbers must
 * be arithmetic, as on every compiler in use. Four independent parts: encoders for what the robot
 * sends, a byte-wise decoder for what it is asked, signing of both, and the robot core (dead
 * reckoning with HEDR).
 *
 *     hedr_config config = hedr_default_config();
 *     hedr_robot robot;
 *     hedr_robot_init(&robot, &config);
 *     ... a hundred times a second:
 *     hedr_robot_update(&robot, micros(), left_count, right_count, gyro_rate_urad_s);
 *     hedr_sensors sensors = hedr_robot_sensors(&robot);
 *     serial_write(frame, hedr_encode_sensors(frame, sequence++, &sensors));
 */
#ifndef HEDR_ROBOT_H
#define HEDR_ROBOT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "hedr_robot.h copies integers as they lie in memory: little endian machines only"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define HEDR_PROTOCOL 1
#define HEDR_NAME_MAX 63   /* bytes of UTF-8 */
#define HEDR_EVENT_MAX 120 /* bytes of UTF-8 */
#define HEDR_FRAME_MAX 161 /* the longest frame that is encoded here: hello */
#define HEDR_REQUEST_BLOCK_MAX 40

enum {
    HEDR_ID_HELLO = 0x01,
    HEDR_ID_POSE = 0x02,
    HEDR_ID_SENSORS = 0x03,
    HEDR_ID_STATUS = 0x04,
    HEDR_ID_PARAMETER = 0x05,
    HEDR_ID_ACKNOWLEDGE = 0x06,
    HEDR_ID_EVENT = 0x07,
    HEDR_ID_TIME_ECHO = 0x08,
    HEDR_ID_PARAMETER_GET = 0x81,
    HEDR_ID_PARAMETER_SET = 0x82,
    HEDR_ID_COMMAND = 0x83,
    HEDR_ID_TIME_REQUEST = 0x84
};

enum { /* bits of hello's capabilities */
       HEDR_HAS_GYRO = 1,
       HEDR_HAS_MAGNETOMETER = 2,
       HEDR_HAS_TEMPERATURE = 4,
       HEDR_HAS_HEDR = 8,
       HEDR_OBEYS_REQUESTS = 16
};
#define HEDR_DEMANDS_SIGNED 0x8000U /* one of them, too large for an int of 16 bits */
enum { HEDR_SOURCE_GYRO = 0, HEDR_SOURCE_ENCODERS = 1 };
enum { HEDR_OFF = 0, HEDR_ACTIVE = 1, HEDR_SUSPENDED = 2 };
enum { HEDR_WHY_NONE = 0, HEDR_WHY_STANDING = 1, HEDR_WHY_TURNING = 2 };
enum {
    HEDR_COMMAND_MEASURE_BIAS = 1,
    HEDR_COMMAND_RESET_POSE = 2,
    HEDR_COMMAND_HEDR_ON = 3,
    HEDR_COMMAND_HEDR_OFF = 4
};
enum {
    HEDR_DONE = 0,
    HEDR_UNKNOWN_COMMAND = 1,
    HEDR_UNKNOWN_PARAMETER = 2,
    HEDR_OUT_OF_RANGE = 3,
    HEDR_NOT_WHILE_MOVING = 4,
    HEDR_NOT_SUPPORTED = 5
};

/* ---- Frames ---------------------------------------------------------------------------------- */

/* CRC-32C bit by bit: on an 8-bit machine as fast as a table of nibbles, and smaller. */
static inline uint32_t hedr_crc(const uint8_t* bytes, uint8_t size) {
    uint32_t crc = 0xFFFFFFFFUL;
    for (; size > 0; --size) {
        crc ^= *bytes++;
        for (uint8_t bit = 8; bit > 0; --bit) {
            const uint8_t odd = crc & 1U;
            crc >>= 1;
            if (odd) {
                crc ^= 0x82F63B78UL;
            }
        }
    }
    return ~crc;
}

/* While a frame is written, its first byte, which becomes the first COBS code, counts its length.
 */
static inline void hedr_put(uint8_t* frame, uint32_t value, uint8_t size) {
    for (; size > 0; --size) {
        frame[frame[0]] = (uint8_t)(value & 0xFFU);
        frame[0] = (uint8_t)(frame[0] + 1U);
        value >>= 8;
    }
}

/* A member of a message, an integer. Tables of these instead of a call for each member save a third
 * of the code on an 8-bit machine. */
typedef struct hedr_field {
    uint8_t offset;
    uint8_t size;
} hedr_field;

#define HEDR_FIELD(type, member) \
    { (uint8_t) offsetof(type, member), (uint8_t)sizeof(((type*)0)->member) }
#define HEDR_PUT_FIELDS(frame, table, message) \
    hedr_put_fields(frame, table, (uint8_t)(sizeof(table) / sizeof((table)[0])), message)

static inline void hedr_put_fields(uint8_t* frame, const hedr_field* field, uint8_t count,
                                   const void* message) {
    for (; count > 0; --count, ++field) {
        const uint8_t* member = (const uint8_t*)message + field->offset;
        for (uint8_t i = 0; i < field->size; ++i) {
            hedr_put(frame, member[i], 1);
        }
    }
}

static inline void hedr_put_text(uint8_t* frame, const char* text, uint8_t longest) {
    uint8_t size = 0;
    while (size < longest && text[size] != '\0') {
        ++size;
    }
    /* Not in the middle of a character. */
    while (text[size] != '\0' && size > 0 && ((uint8_t)text[size] & 0xC0U) == 0x80U) {
        --size;
    }
    hedr_put(frame, size, 1);
    for (uint8_t i = 0; i < size; ++i) {
        hedr_put(frame, (uint8_t)text[i], 1);
    }
}

static inline void hedr_begin(uint8_t* frame, uint8_t id, uint16_t sequence) {
    frame[0] = 1;
    hedr_put(frame, id, 1);
    hedr_put(frame, sequence, 2);
}

/* Adds the checksum, stuffs in place (a code byte stands where a zero was), ends with 0x00. Returns
 * the length of the frame. */
static inline uint8_t hedr_finish(uint8_t* frame) {
    uint8_t code = 0;
    uint8_t size;
    hedr_put(frame, hedr_crc(frame + 1, (uint8_t)(frame[0] - 1U)), 4);
    size = frame[0];
    for (uint8_t i = 1; i < size; ++i) {
        if (frame[i] == 0) {
            frame[code] = (uint8_t)(i - code);
            code = i;
        }
    }
    frame[code] = (uint8_t)(size - code);
    frame[size] = 0;
    return (uint8_t)(size + 1U);
}

/* ---- What the robot sends. Each encoder fills `frame` (HEDR_FRAME_MAX bytes do) and returns its
 * length. -------------------------------------------------------------------------------------- */

typedef struct hedr_hello {
    uint32_t boot_id; /* another number after every restart */
    uint16_t capabilities;
    uint32_t left_wheel_diameter_um;
    uint32_t right_wheel_diameter_um;
    uint32_t wheelbase_um;
    uint32_t ticks_per_revolution_milli;
    uint8_t heading_source;
    const char* vehicle;
    const char* firmware;
} hedr_hello;

static inline uint8_t hedr_encode_hello(uint8_t* frame, uint16_t sequence, const hedr_hello* m) {
    static const hedr_field fields[] = {
        HEDR_FIELD(hedr_hello, boot_id),
        HEDR_FIELD(hedr_hello, capabilities),
        HEDR_FIELD(hedr_hello, left_wheel_diameter_um),
        HEDR_FIELD(hedr_hello, right_wheel_diameter_um),
        HEDR_FIELD(hedr_hello, wheelbase_um),
        HEDR_FIELD(hedr_hello, ticks_per_revolution_milli),
        HEDR_FIELD(hedr_hello, heading_source),
    };
    hedr_begin(frame, HEDR_ID_HELLO, sequence);
    hedr_put(frame, HEDR_PROTOCOL, 1);
    HEDR_PUT_FIELDS(frame, fields, m);
    hedr_put_text(frame, m->vehicle, HEDR_NAME_MAX);
    hedr_put_text(frame, m->firmware, HEDR_NAME_MAX);
    return hedr_finish(frame);
}

typedef struct hedr_pose {
    uint32_t time_us;
    int32_t x_mm;
    int32_t y_mm;
    int32_t heading; /* 2^-20 turn, full turns kept */
    int16_t rate_mrad_s;
    int16_t drift_10urad_s;
    uint8_t state;  /* HEDR_OFF... */
    uint8_t reason; /* HEDR_WHY_... */
    uint8_t standing;
    uint8_t calibrated;
} hedr_pose;

static inline uint8_t hedr_encode_pose(uint8_t* frame, uint16_t sequence, const hedr_pose* m) {
    static const hedr_field fields[] = {
        HEDR_FIELD(hedr_pose, time_us),     HEDR_FIELD(hedr_pose, x_mm),
        HEDR_FIELD(hedr_pose, y_mm),        HEDR_FIELD(hedr_pose, heading),
        HEDR_FIELD(hedr_pose, rate_mrad_s), HEDR_FIELD(hedr_pose, drift_10urad_s),
    };
    hedr_begin(frame, HEDR_ID_POSE, sequence);
    HEDR_PUT_FIELDS(frame, fields, m);
    hedr_put(frame,
             (m->state & 3U) | (m->reason & 7U) << 2 | (m->standing ? 32U : 0U) |
                 (m->calibrated ? 64U : 0U),
             2);
    return hedr_finish(frame);
}

#define HEDR_NO_TEMPERATURE INT16_MIN
#define HEDR_NO_GYRO 0x80000000UL

typedef struct hedr_sensors {
    uint32_t time_us;
    int32_t left_ticks;
    int32_t right_ticks;
    uint32_t gyro_urad; /* cumulative, wraps */
    uint8_t has_gyro;
    int16_t temperature_centi_c; /* or HEDR_NO_TEMPERATURE */
    uint8_t has_magnetometer;
    int16_t magnetometer[3];
} hedr_sensors;

static inline uint8_t hedr_encode_sensors(uint8_t* frame, uint16_t sequence,
                                          const hedr_sensors* m) {
    static const hedr_field before[] = {
        HEDR_FIELD(hedr_sensors, time_us),
        HEDR_FIELD(hedr_sensors, left_ticks),
        HEDR_FIELD(hedr_sensors, right_ticks),
    };
    static const hedr_field after[] = {
        HEDR_FIELD(hedr_sensors, temperature_centi_c),
        HEDR_FIELD(hedr_sensors, magnetometer[0]),
        HEDR_FIELD(hedr_sensors, magnetometer[1]),
        HEDR_FIELD(hedr_sensors, magnetometer[2]),
    };
    uint32_t gyro = HEDR_NO_GYRO;
    if (m->has_gyro) {
        gyro = m->gyro_urad + (m->gyro_urad == HEDR_NO_GYRO ? 1U : 0U);
    }
    hedr_begin(frame, HEDR_ID_SENSORS, sequence);
    HEDR_PUT_FIELDS(frame, before, m);
    hedr_put(frame, gyro, 4);
    hedr_put_fields(frame, after, m->has_magnetometer ? 4 : 1, m);
    return hedr_finish(frame);
}

#define HEDR_NO_RADIO INT8_MIN

typedef struct hedr_status {
    uint16_t battery_mv;
    uint16_t faults;
    int8_t radio_dbm; /* or HEDR_NO_RADIO */
} hedr_status;

static inline uint8_t hedr_encode_status(uint8_t* frame, uint16_t sequence, const hedr_status* m) {
    static const hedr_field fields[] = {
        HEDR_FIELD(hedr_status, battery_mv),
        HEDR_FIELD(hedr_status, faults),
        HEDR_FIELD(hedr_status, radio_dbm),
    };
    hedr_begin(frame, HEDR_ID_STATUS, sequence);
    HEDR_PUT_FIELDS(frame, fields, m);
    return hedr_finish(frame);
}

static inline uint8_t hedr_encode_parameter(uint8_t* frame, uint16_t sequence, uint8_t id,
                                            int32_t value) {
    hedr_begin(frame, HEDR_ID_PARAMETER, sequence);
    hedr_put(frame, id, 1);
    hedr_put(frame, (uint32_t)value, 4);
    return hedr_finish(frame);
}

static inline uint8_t hedr_encode_acknowledge(uint8_t* frame, uint16_t sequence, uint8_t command,
                                              uint8_t result) {
    hedr_begin(frame, HEDR_ID_ACKNOWLEDGE, sequence);
    hedr_put(frame, command, 1);
    hedr_put(frame, result, 1);
    return hedr_finish(frame);
}

static inline uint8_t hedr_encode_event(uint8_t* frame, uint16_t sequence, uint32_t time_us,
                                        const char* text) {
    hedr_begin(frame, HEDR_ID_EVENT, sequence);
    hedr_put(frame, time_us, 4);
    hedr_put_text(frame, text, HEDR_EVENT_MAX);
    return hedr_finish(frame);
}

static inline uint8_t hedr_encode_time_echo(uint8_t* frame, uint16_t sequence, uint32_t token,
                                            uint32_t time_us) {
    hedr_begin(frame, HEDR_ID_TIME_ECHO, sequence);
    hedr_put(frame, token, 4);
    hedr_put(frame, time_us, 4);
    return hedr_finish(frame);
}

/* ---- What the robot is asked ----------------------------------------------------------------- */

typedef struct hedr_request {
    uint8_t id; /* HEDR_ID_PARAMETER_GET... */
    uint16_t sequence;
    uint8_t number; /* of the parameter or the command */
    int32_t value;  /* of a parameter */
    int32_t x_mm;   /* of a pose reset */
    int32_t y_mm;
    int32_t heading; /* 2^-20 turn */
    uint32_t token;
} hedr_request;

typedef struct hedr_decoder {
    uint8_t block[HEDR_REQUEST_BLOCK_MAX];
    uint8_t size; /* HEDR_REQUEST_BLOCK_MAX + 1: too long, waits for the next 0x00 */
} hedr_decoder;

static inline void hedr_decoder_init(hedr_decoder* d) { d->size = 0; }

static inline uint32_t hedr_get32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

/* Back to plain bytes in block[1...]; 0 where it is not a good frame. */
static inline uint8_t hedr_unstuff_and_check(uint8_t* block, uint8_t size) {
    uint8_t code = 0;
    if (size < 8) {
        return 0;
    }
    while (code < size) {
        const uint8_t step = block[code];
        if (step > size - code) {
            return 0;
        }
        block[code] = 0;
        code = (uint8_t)(code + step);
    }
    return hedr_crc(block + 1, (uint8_t)(size - 5U)) == hedr_get32(block + size - 4);
}

/* Longer payloads than known are fine, they come from a newer laptop; shorter ones are not. */
static inline uint8_t hedr_parse_request(const uint8_t* block, uint8_t size, hedr_request* out) {
    const uint8_t payload_size = (uint8_t)(size - 8U);
    const uint8_t* payload = block + 4;
    out->id = block[1];
    out->sequence = (uint16_t)((uint16_t)block[2] | (uint16_t)((uint16_t)block[3] << 8));
    out->number = payload_size >= 1 ? payload[0] : 0;
    switch (out->id) {
        case HEDR_ID_PARAMETER_GET:
            return payload_size >= 1;
        case HEDR_ID_PARAMETER_SET:
            out->value = payload_size >= 5 ? (int32_t)hedr_get32(payload + 1) : 0;
            return payload_size >= 5;
        case HEDR_ID_COMMAND:
            if (payload_size < 13) {
                return 0;
            }
            out->x_mm = (int32_t)hedr_get32(payload + 1);
            out->y_mm = (int32_t)hedr_get32(payload + 5);
            out->heading = (int32_t)hedr_get32(payload + 9);
            return 1;
        case HEDR_ID_TIME_REQUEST:
            out->token = payload_size >= 4 ? hedr_get32(payload) : 0;
            return payload_size >= 4;
        default:
            return 0;
    }
}

/* Takes the next byte from the line. Returns the size of the good frame that it ends, now plain in
 * block[1...], or 0. */
static inline uint8_t hedr_decoder_collect(hedr_decoder* d, uint8_t byte) {
    const uint8_t size = d->size;
    if (byte != 0) {
        if (size < HEDR_REQUEST_BLOCK_MAX) {
            d->block[size] = byte;
        }
        d->size = size <= HEDR_REQUEST_BLOCK_MAX ? (uint8_t)(size + 1U) : size;
        return 0;
    }
    d->size = 0;
    return size <= HEDR_REQUEST_BLOCK_MAX && hedr_unstuff_and_check(d->block, size) ? size : 0;
}

/* Takes the next byte from the line. Returns 1 when it ends a request that is now in *out. */
static inline uint8_t hedr_decoder_push(hedr_decoder* d, uint8_t byte, hedr_request* out) {
    const uint8_t size = hedr_decoder_collect(d, byte);
    return size != 0 && hedr_parse_request(d->block, size, out);
}

/* ---- Signing: a robot with a key signs what it sends and heeds signed requests only ------------
 *
 *     static const uint8_t key[] = HEDR_KEY;   from `hedr key install`
 *     static void keep(const hedr_counters* c) { ... write them to EEPROM ... }
 *     hedr_signing signing;
 *     hedr_signing_init(&signing, key, &counters_from_eeprom, keep);
 *     size = hedr_encode_pose(frame, sequence++, &pose);
 *     serial_write(frame, hedr_sign(&signing, frame, size));
 *     ... and HEDR_DEMANDS_SIGNED among the capabilities, hedr_decoder_push_signed for each byte.
 */

#define HEDR_KEY_SIZE 16
#define HEDR_TAG_SIZE 8
#define HEDR_SIGNATURE_SIZE 12 /* counter and tag */
#define HEDR_SIGNED_FRAME_MAX (HEDR_FRAME_MAX + HEDR_SIGNATURE_SIZE)
#define HEDR_ID_SIGNED 0x40U
#define HEDR_ID_FROM_LAPTOP 0x80U
#define HEDR_COUNTER_BLOCK 65536UL

/* What must outlive a restart, 8 bytes. New EEPROM (all bits set) counts as zeros. */
typedef struct hedr_counters {
    uint32_t reserved; /* the robot may have used every counter up to this */
    uint32_t heard;    /* the laptop's */
} hedr_counters;

typedef struct hedr_signing {
    const uint8_t* key;
    uint32_t counter; /* of the last frame that was signed */
    hedr_counters kept;
    /* Must have written the counters when it returns. Called for the first frame and each 65,536th
     * (nine minutes), and for each command and parameter that is set. */
    void (*keep)(const hedr_counters* counters);
} hedr_signing;

static inline void hedr_signing_init(hedr_signing* s, const uint8_t* key, const hedr_counters* kept,
                                     void (*keep)(const hedr_counters* counters)) {
    s->key = key;
    s->kept.reserved = kept->reserved == 0xFFFFFFFFUL ? 0 : kept->reserved;
    s->kept.heard = kept->heard == 0xFFFFFFFFUL ? 0 : kept->heard;
    s->counter = s->kept.reserved;
    s->keep = keep;
}

static inline uint64_t hedr_rotate(uint64_t word, uint8_t bits) {
    return word << bits | word >> (64U - bits);
}

static inline void hedr_sip_rounds(uint64_t* v, uint8_t rounds) {
    for (; rounds > 0; --rounds) {
        v[0] += v[1];
        v[1] = hedr_rotate(v[1], 13) ^ v[0];
        v[0] = hedr_rotate(v[0], 32);
        v[2] += v[3];
        v[3] = hedr_rotate(v[3], 16) ^ v[2];
        v[0] += v[3];
        v[3] = hedr_rotate(v[3], 21) ^ v[0];
        v[2] += v[1];
        v[1] = hedr_rotate(v[1], 17) ^ v[2];
        v[2] = hedr_rotate(v[2], 32);
    }
}

/* SipHash-2-4 (Aumasson and Bernstein 2012). Words are filled byte by byte: shifting 64 bits by a
 * number that is not known costs an 8-bit machine hundreds of cycles. */
static inline void hedr_siphash(const uint8_t* key, const uint8_t* bytes, uint8_t size,
                                uint8_t* tag) {
    static const uint64_t start[4] = {UINT64_C(0x736F6D6570736575), UINT64_C(0x646F72616E646F6D),
                                      UINT64_C(0x6C7967656E657261), UINT64_C(0x7465646279746573)};
    uint64_t v[4];
    uint64_t word;
    uint8_t done = 0;
    uint8_t filled;
    for (uint8_t i = 0; i < 32; ++i) {
        ((uint8_t*)v)[i] = ((const uint8_t*)start)[i] ^ key[i & 15U];
    }
    do {
        word = 0;
        for (filled = 0; filled < 8 && done < size; ++filled) {
            ((uint8_t*)&word)[filled] = bytes[done++];
        }
        if (filled < 8) {
            ((uint8_t*)&word)[7] = size;
        }
        v[3] ^= word;
        hedr_sip_rounds(v, 2);
        v[0] ^= word;
    } while (filled == 8);
    v[2] ^= 0xFFU;
    hedr_sip_rounds(v, 4);
    word = v[0] ^ v[1] ^ v[2] ^ v[3];
    for (uint8_t i = 0; i < HEDR_TAG_SIZE; ++i) {
        tag[i] = ((const uint8_t*)&word)[i];
    }
}

/* Makes the signed frame of what an encoder wrote (`frame` needs HEDR_SIGNED_FRAME_MAX bytes) and
 * returns its length; 0 when the counters are used up, which takes years: then a new key is due. */
static inline uint8_t hedr_sign(hedr_signing* s, uint8_t* frame, uint8_t size) {
    uint8_t tag[HEDR_TAG_SIZE];
    if (size == 0 || !hedr_unstuff_and_check(frame, (uint8_t)(size - 1U))) {
        return 0;
    }
    if (s->counter == s->kept.reserved) {
        if (s->kept.reserved > 0xFFFFFFFFUL - HEDR_COUNTER_BLOCK - 1U) {
            return 0;
        }
        s->kept.reserved += HEDR_COUNTER_BLOCK;
        s->keep(&s->kept);
    }
    frame[0] = (uint8_t)(size - 5U); /* the checksum and the zero go */
    frame[1] |= HEDR_ID_SIGNED;
    hedr_put(frame, ++s->counter, 4);
    hedr_siphash(s->key, frame + 1, (uint8_t)(frame[0] - 1U), tag);
    for (uint8_t i = 0; i < HEDR_TAG_SIZE; ++i) {
        hedr_put(frame, tag[i], 1);
    }
    return hedr_finish(frame);
}

/* Whether a plain block is a request that the laptop signed and that was not heard before. */
static inline uint8_t hedr_verify(hedr_signing* s, const uint8_t* block, uint8_t size) {
    const uint8_t tag_at = (uint8_t)(size - 4U - HEDR_TAG_SIZE);
    uint8_t tag[HEDR_TAG_SIZE];
    uint8_t different = 0;
    uint32_t counter;
    if (size < 8 + HEDR_SIGNATURE_SIZE || (block[1] & 0xC0U) != 0xC0U) {
        return 0;
    }
    hedr_siphash(s->key, block + 1, (uint8_t)(tag_at - 1U), tag);
    for (uint8_t i = 0; i < HEDR_TAG_SIZE; ++i) { /* as long for every tag */
        different |= tag[i] ^ block[tag_at + i];
    }
    counter = hedr_get32(block + tag_at - 4);
    if (different || counter <= s->kept.heard || counter == 0xFFFFFFFFUL) {
        return 0;
    }
    s->kept.heard = counter;
    return 1;
}

/* hedr_decoder_push for a robot that demands signed requests. What changes something is never done
 * twice, not after a restart either; what only asks is not worth the wear of the EEPROM. */
static inline uint8_t hedr_decoder_push_signed(hedr_decoder* d, hedr_signing* s, uint8_t byte,
                                               hedr_request* out) {
    const uint8_t size = hedr_decoder_collect(d, byte);
    if (size == 0 || !hedr_verify(s, d->block, size)) {
        return 0;
    }
    d->block[1] &= (uint8_t)~HEDR_ID_SIGNED;
    if (!hedr_parse_request(d->block, (uint8_t)(size - HEDR_SIGNATURE_SIZE), out)) {
        return 0;
    }
    if (out->id == HEDR_ID_PARAMETER_SET || out->id == HEDR_ID_COMMAND) {
        s->keep(&s->kept);
    }
    return 1;
}

/* ---- The robot core: dead reckoning and HEDR -------------------------------------------------
 *
 * HEDR: Borenstein, Borrell, Miller, Thomas, "Heuristics-enhanced Dead-reckoning (HEDR) for
 * Accurate Position Tracking of Tele-operated UGVs", 2010. Differs from the paper:
 * - the sign of the correction in Eqs. (7) and (10); as printed it is positive feedback;
 * - i_c is stated as an acceleration k, so that it does not depend on the sampling rate;
 * - suspended in turns and while standing; the integrator leaks to its running mean, and both are
 *   given up when held too long;
 * - a relay around two integrators swings without end, so a small part acts on the heading itself.
 */

#define HEDR_LONGEST_STEP_US 1000000UL
/* More in one step is a broken counter: 8.4 m in 2^-24 um, 16 turns in 2^-44 turn. */
#define HEDR_LONGEST_TRAVEL INT64_C(0x7FFFFFFF0000)
#define HEDR_LONGEST_TURN INT64_C(0x1000000000000)
#define HEDR_STANDING_US 500000UL      /* no count for so long */
#define HEDR_TURNING_NRAD_S 174532925L /* 10 deg/s */
#define HEDR_RATE_FILTER_US 200000L    /* for "turning": encoders' rates are coarse */
#define HEDR_LEAK_US 20000000L         /* time constant of I's way back to its mean */
#define HEDR_MEAN_US 20000000L         /* of the mean itself */
#define HEDR_DAMPING_MS 10000L         /* acts on the heading as k over so long would */
#define HEDR_HELD_US 30000000UL        /* what was learnt longer ago is given up */
#define HEDR_INTEGRAL_MAX_NRAD_S 300000000L
#define HEDR_RATE_MAX_URAD_S 33554432L
#define HEDR_SHORTEST_BIAS_US 1000000UL

typedef struct hedr_config {
    int32_t left_wheel_diameter_um; /* 1 mm to 2 m */
    int32_t right_wheel_diameter_um;
    int32_t wheelbase_um;               /* 20 mm to 10 m */
    int32_t ticks_per_revolution_milli; /* at least 10 ticks */
    int32_t hedr_gain_urad_s2;          /* k of HEDR */
    int32_t dominant_directions;        /* 4 or 8 */
    int32_t dominant_offset;            /* of the building, 2^-20 turn */
    uint8_t heading_source;
    uint8_t hedr_on;
    uint32_t bias_time_us; /* the gyro's bias is measured for so long, standing, at the start */
} hedr_config;

typedef struct hedr_robot {
    hedr_config config;
    int64_t left_travel_per_tick; /* 2^-24 um */
    int64_t right_travel_per_tick;
    int64_t left_turn_per_tick; /* 2^-44 turn */
    int64_t right_turn_per_tick;

    uint8_t started;
    uint32_t time_us;
    int32_t left_ticks;
    int32_t right_ticks;

    int64_t x; /* 2^-8 um */
    int64_t y;
    int64_t heading;      /* 2^-44 turn */
    int32_t travel_rest;  /* 2^-24 um */
    int32_t angle_rest;   /* 10^-15 rad */
    int64_t rate_nrad_s;  /* low-passed */
    uint32_t standing_us; /* saturates at HEDR_STANDING_US */

    uint32_t gyro_urad; /* cumulative, bias and all */
    int32_t gyro_rest;  /* 10^-12 rad */

    uint8_t measuring_bias;
    uint8_t calibrated;
    int64_t bias_nrad_s;
    int64_t bias_sum; /* 10^-12 rad */
    uint32_t bias_elapsed_us;

    uint8_t state;
    uint8_t reason;
    int64_t integral_nrad_s; /* I of HEDR */
    int64_t damping_nrad_s;
    int64_t mean_nrad_s; /* running mean of -I: the drift */
    uint32_t held_us;
} hedr_robot;

static inline hedr_config hedr_default_config(void) {
    hedr_config c;
    c.left_wheel_diameter_um = 200000L;
    c.right_wheel_diameter_um = 200000L;
    c.wheelbase_um = 400000L;
    c.ticks_per_revolution_milli = 1000000L;
    c.hedr_gain_urad_s2 = 175L; /* 0.01 deg/s^2 */
    c.dominant_directions = 4;
    c.dominant_offset = 0;
    c.heading_source = HEDR_SOURCE_GYRO;
    c.hedr_on = 1;
    c.bias_time_us = 5000000UL;
    return c;
}

static inline uint8_t hedr_within(int32_t value, int32_t low, int32_t high) {
    return value >= low && value <= high;
}

static inline uint8_t hedr_config_ok(const hedr_config* c) {
    return hedr_within(c->left_wheel_diameter_um, 1000L, 2000000L) &&
           hedr_within(c->right_wheel_diameter_um, 1000L, 2000000L) &&
           hedr_within(c->wheelbase_um, 20000L, 10000000L) &&
           hedr_within(c->ticks_per_revolution_milli, 10000L, INT32_MAX) &&
           hedr_within(c->hedr_gain_urad_s2, 0L, 100000L) &&
           (c->dominant_directions == 4 || c->dominant_directions == 8) &&
           c->heading_source <= HEDR_SOURCE_ENCODERS;
}

static inline void hedr_measure_bias_from_now(hedr_robot* r) {
    r->measuring_bias = r->config.heading_source == HEDR_SOURCE_GYRO && r->config.bias_time_us > 0;
    r->bias_sum = 0;
    r->bias_elapsed_us = 0;
}

static inline int64_t hedr_travel_per_tick(int32_t diameter_um, int32_t ticks_milli) {
    const int64_t thousand_pi = (int64_t)diameter_um * INT64_C(3141592654) / 1000000L;
    return thousand_pi * 16777216L / ticks_milli;
}

/* Travel / (2 pi wheelbase): pi cancels. */
static inline int64_t hedr_turn_per_tick(int32_t diameter_um, const hedr_config* c) {
    const int64_t part = (int64_t)diameter_um * 500L * 4194304L / c->ticks_per_revolution_milli;
    return part * 4194304L / c->wheelbase_um;
}

static inline void hedr_robot_set_scales(hedr_robot* r) {
    const hedr_config* c = &r->config;
    r->left_travel_per_tick =
        hedr_travel_per_tick(c->left_wheel_diameter_um, c->ticks_per_revolution_milli);
    r->right_travel_per_tick =
        hedr_travel_per_tick(c->right_wheel_diameter_um, c->ticks_per_revolution_milli);
    r->left_turn_per_tick = hedr_turn_per_tick(c->left_wheel_diameter_um, c);
    r->right_turn_per_tick = hedr_turn_per_tick(c->right_wheel_diameter_um, c);
}

/* Returns 0, and changes nothing, where the configuration is out of range. */
static inline uint8_t hedr_robot_init(hedr_robot* r, const hedr_config* config) {
    uint8_t* byte = (uint8_t*)r;
    if (!hedr_config_ok(config)) {
        return 0;
    }
    for (size_t i = 0; i < sizeof *r; ++i) {
        byte[i] = 0;
    }
    r->config = *config;
    r->standing_us = HEDR_STANDING_US;
    r->held_us = HEDR_HELD_US;
    hedr_robot_set_scales(r);
    hedr_measure_bias_from_now(r);
    return 1;
}

/* sin of a binary angle (2^32 is a full turn) in 2^-30; error below 4e-9. Odd polynomial, minimax
 * on a quarter turn. */
static inline int32_t hedr_sin(uint32_t angle) {
    static const int32_t coefficient[5] = {161942L, -5016767L, 85564854L, -693597876L, 1686629674L};
    int64_t z = (int32_t)angle; /* 2^30 is a quarter turn */
    int64_t square, sum = 0;
    if (z > INT64_C(1073741824)) {
        z = INT64_C(2147483648) - z;
    } else if (z < -INT64_C(1073741824)) {
        z = -INT64_C(2147483648) - z;
    }
    square = (z * z) >> 30;
    for (uint8_t i = 0; i < 5; ++i) {
        sum = ((sum * square) >> 30) + coefficient[i];
    }
    return (int32_t)((sum * z) >> 30);
}

static inline int32_t hedr_cos(uint32_t angle) { return hedr_sin(angle + 1073741824UL); }

static inline int64_t hedr_clamp(int64_t value, int64_t limit) {
    return value > limit ? limit : value < -limit ? -limit : value;
}

static inline uint8_t hedr_robot_stands(const hedr_robot* r) {
    return r->standing_us >= HEDR_STANDING_US;
}

/* The cumulative angle for the sensors message. */
static inline void hedr_integrate_gyro(hedr_robot* r, int32_t rate_urad_s, uint32_t dt_us) {
    const int64_t sum = (int64_t)rate_urad_s * (int64_t)dt_us + r->gyro_rest;
    r->gyro_urad += (uint32_t)(sum / 1000000L);
    r->gyro_rest = (int32_t)(sum % 1000000L);
}

static inline void hedr_measure_bias(hedr_robot* r, int32_t rate_urad_s, uint32_t dt_us,
                                     uint8_t moved) {
    if (!moved) {
        r->bias_sum += (int64_t)rate_urad_s * (int64_t)dt_us;
        r->bias_elapsed_us += dt_us;
    }
    if (moved || r->bias_elapsed_us >= r->config.bias_time_us) {
        r->measuring_bias = 0;
        if (r->bias_elapsed_us >= HEDR_SHORTEST_BIAS_US || !moved) {
            r->bias_nrad_s = r->bias_sum * 1000L / (int64_t)r->bias_elapsed_us;
            r->calibrated = 1;
        }
    }
}

/* 2^-44 turn of a rate over dt; what is below a nanoradian is kept for the next step. */
static inline int64_t hedr_turn_of_rate(hedr_robot* r, int64_t rate_nrad_s, uint32_t dt_us) {
    const int64_t sum = rate_nrad_s * (int64_t)dt_us + r->angle_rest;
    const int64_t nrad = sum / 1000000L;
    r->angle_rest = (int32_t)(sum % 1000000L);
    return (nrad * 183493156L) >> 16;
}

/* 0 in a dominant direction, positive to the left of it: MOD(psi, delta) with the interval spread
 * over 32 bits, so that "> delta/2" is the sign. */
static inline int32_t hedr_deviation(const hedr_robot* r) {
    const uint32_t angle =
        (uint32_t)(r->heading >> 12) - ((uint32_t)r->config.dominant_offset << 12);
    return (int32_t)(r->config.dominant_directions == 8 ? angle << 3 : angle << 2);
}

static inline void hedr_hold(hedr_robot* r, uint32_t dt_us) {
    r->damping_nrad_s = 0;
    r->held_us = r->held_us < HEDR_HELD_US ? r->held_us + dt_us : r->held_us;
    if (r->state == HEDR_OFF || r->held_us >= HEDR_HELD_US) {
        r->integral_nrad_s = 0;
        r->mean_nrad_s = 0;
    }
}

/* Eq. (7) with the right sign. The part that acts on the heading at once damps the loop. */
static inline void hedr_learn(hedr_robot* r, uint32_t dt_us) {
    const int64_t step = (int64_t)r->config.hedr_gain_urad_s2 * (int64_t)dt_us / 1000L;
    const int32_t deviation = hedr_deviation(r);
    const int8_t side = deviation < 0 ? 1 : deviation > 0 ? -1 : 0;
    const int64_t leak = (r->integral_nrad_s + r->mean_nrad_s) * (int64_t)dt_us / HEDR_LEAK_US;
    r->integral_nrad_s =
        hedr_clamp(r->integral_nrad_s + side * step - leak, HEDR_INTEGRAL_MAX_NRAD_S);
    r->damping_nrad_s = side * (int64_t)r->config.hedr_gain_urad_s2 * HEDR_DAMPING_MS;
    r->mean_nrad_s += (-r->integral_nrad_s - r->mean_nrad_s) * (int64_t)dt_us / HEDR_MEAN_US;
    r->held_us = 0;
}

/* The integrator and the state of HEDR, from the heading and rate of the last step. */
static inline void hedr_correct(hedr_robot* r, uint32_t dt_us) {
    const uint8_t turning =
        r->rate_nrad_s > HEDR_TURNING_NRAD_S || r->rate_nrad_s < -HEDR_TURNING_NRAD_S;
    r->reason = hedr_robot_stands(r) ? HEDR_WHY_STANDING
                : turning            ? HEDR_WHY_TURNING
                                     : HEDR_WHY_NONE;
    r->state = HEDR_ACTIVE;
    if (!r->config.hedr_on) {
        r->state = HEDR_OFF;
        r->reason = HEDR_WHY_NONE;
    } else if (r->reason != HEDR_WHY_NONE) {
        r->state = HEDR_SUSPENDED;
    }
    if (r->state == HEDR_ACTIVE) {
        hedr_learn(r, dt_us);
    } else {
        hedr_hold(r, dt_us);
    }
}

static inline void hedr_turn(hedr_robot* r, int32_t gyro_rate_urad_s, int64_t wheel_turn,
                             uint32_t dt_us) {
    const uint8_t from_gyro = r->config.heading_source == HEDR_SOURCE_GYRO;
    const int64_t measured = from_gyro ? (int64_t)gyro_rate_urad_s * 1000L - r->bias_nrad_s : 0;
    /* Eq. (9) */
    const int64_t rate = hedr_clamp(measured + r->integral_nrad_s + r->damping_nrad_s,
                                    (int64_t)HEDR_RATE_MAX_URAD_S * 1000L);
    const int64_t turn = hedr_turn_of_rate(r, rate, dt_us) + (from_gyro ? 0 : wheel_turn);
    /* 2^-44 turn in nanoradians: 1e9 * 2 pi / 2^44 = 23968 / 2^26 */
    const int64_t now_nrad_s = hedr_clamp((turn >> 13) * 23968L / 8192L * 1000000L / (int64_t)dt_us,
                                          (int64_t)HEDR_RATE_MAX_URAD_S * 1000L);
    r->heading += turn;
    r->rate_nrad_s +=
        (now_nrad_s - r->rate_nrad_s) * (int64_t)dt_us / (HEDR_RATE_FILTER_US + (int64_t)dt_us);
}

static inline void hedr_advance(hedr_robot* r, int64_t travel, int64_t heading_before) {
    const uint32_t direction = (uint32_t)(((heading_before + r->heading) / 2) >> 12);
    const int64_t step = travel >> 16; /* 2^-8 um */
    r->travel_rest = (int32_t)(travel & 0xFFFFL);
    r->x += (step * hedr_cos(direction) + 536870912L) >> 30;
    r->y += (step * hedr_sin(direction) + 536870912L) >> 30;
}

/* One step of dt_us at most HEDR_LONGEST_STEP_US in which the counters went on by left and right.
 */
static inline void hedr_step(hedr_robot* r, uint32_t dt_us, int32_t left, int32_t right,
                             int32_t gyro_rate_urad_s) {
    const int32_t rate = (int32_t)hedr_clamp(gyro_rate_urad_s, HEDR_RATE_MAX_URAD_S);
    const uint8_t moved = left != 0 || right != 0;
    const int64_t heading_before = r->heading;
    const int64_t turn = right * r->right_turn_per_tick - left * r->left_turn_per_tick;
    const int64_t travel =
        (left * r->left_travel_per_tick + right * r->right_travel_per_tick) / 2 + r->travel_rest;

    hedr_integrate_gyro(r, rate, dt_us);
    r->standing_us = moved ? 0 : r->standing_us + dt_us;
    r->standing_us = r->standing_us > HEDR_STANDING_US ? HEDR_STANDING_US : r->standing_us;
    if (hedr_clamp(travel, HEDR_LONGEST_TRAVEL) != travel ||
        hedr_clamp(turn, HEDR_LONGEST_TURN) != turn) {
        return;
    }
    hedr_correct(r, dt_us);
    if (r->measuring_bias) {
        hedr_measure_bias(r, rate, dt_us, moved);
    }
    if (!r->measuring_bias) {
        hedr_turn(r, rate, turn, dt_us);
        hedr_advance(r, travel, heading_before);
    }
}

/* One sample. Counts and time may wrap. The gyro's rate stands for at most a second; a counter that
 * jumps is taken as restarted. */
static inline void hedr_robot_update(hedr_robot* r, uint32_t time_us, int32_t left_ticks,
                                     int32_t right_ticks, int32_t gyro_rate_urad_s) {
    const uint32_t dt_us = time_us - r->time_us;
    const int32_t left = (int32_t)((uint32_t)left_ticks - (uint32_t)r->left_ticks);
    const int32_t right = (int32_t)((uint32_t)right_ticks - (uint32_t)r->right_ticks);
    const uint8_t first = !r->started;
    if (dt_us == 0 && !first) {
        return;
    }
    r->started = 1;
    r->time_us = time_us;
    r->left_ticks = left_ticks;
    r->right_ticks = right_ticks;
    if (!first && hedr_within(left, -32767, 32767) && hedr_within(right, -32767, 32767)) {
        hedr_step(r, dt_us < HEDR_LONGEST_STEP_US ? dt_us : HEDR_LONGEST_STEP_US, left, right,
                  gyro_rate_urad_s);
    }
}

static inline hedr_sensors hedr_robot_sensors(const hedr_robot* r) {
    hedr_sensors m;
    m.time_us = r->time_us;
    m.left_ticks = r->left_ticks;
    m.right_ticks = r->right_ticks;
    m.gyro_urad = r->gyro_urad;
    m.has_gyro = r->config.heading_source == HEDR_SOURCE_GYRO;
    m.temperature_centi_c = HEDR_NO_TEMPERATURE;
    m.has_magnetometer = 0;
    m.magnetometer[0] = m.magnetometer[1] = m.magnetometer[2] = 0;
    return m;
}

static inline int32_t hedr_mm(int64_t position) {
    const int64_t raised = position + 128000L;
    return (int32_t)(raised / 256000L - (raised % 256000L < 0 ? 1 : 0));
}

static inline hedr_pose hedr_robot_pose(const hedr_robot* r) {
    hedr_pose m;
    m.time_us = r->time_us;
    m.x_mm = hedr_mm(r->x);
    m.y_mm = hedr_mm(r->y);
    m.heading = (int32_t)((r->heading + 8388608L) >> 24);
    m.rate_mrad_s = (int16_t)hedr_clamp(r->rate_nrad_s / 1000000L, INT16_MAX);
    m.drift_10urad_s = (int16_t)hedr_clamp(r->mean_nrad_s / 10000L, INT16_MAX);
    m.state = r->state;
    m.reason = r->reason;
    m.standing = hedr_robot_stands(r);
    m.calibrated = r->calibrated;
    return m;
}

static inline void hedr_robot_reset_pose(hedr_robot* r, int32_t x_mm, int32_t y_mm,
                                         int32_t heading) {
    r->x = (int64_t)x_mm * 256000L;
    r->y = (int64_t)y_mm * 256000L;
    r->heading = (int64_t)heading * 16777216L;
}

/* NULL for an unknown number. */
static inline int32_t* hedr_parameter(hedr_config* c, uint8_t number) {
    switch (number) {
        case 1:
            return &c->left_wheel_diameter_um;
        case 2:
            return &c->right_wheel_diameter_um;
        case 3:
            return &c->wheelbase_um;
        case 4:
            return &c->ticks_per_revolution_milli;
        case 5:
            return &c->hedr_gain_urad_s2;
        case 6:
            return &c->dominant_directions;
        case 7:
            return &c->dominant_offset;
        default:
            return NULL;
    }
}

static inline uint8_t hedr_robot_set_parameter(hedr_robot* r, uint8_t number, int32_t value) {
    hedr_config changed = r->config;
    int32_t* parameter = hedr_parameter(&changed, number);
    if (parameter == NULL) {
        return HEDR_UNKNOWN_PARAMETER;
    }
    *parameter = value;
    if (!hedr_config_ok(&changed)) {
        return HEDR_OUT_OF_RANGE;
    }
    r->config = changed;
    hedr_robot_set_scales(r);
    return HEDR_DONE;
}

static inline uint8_t hedr_robot_command(hedr_robot* r, const hedr_request* q) {
    switch (q->number) {
        case HEDR_COMMAND_MEASURE_BIAS:
            if (r->config.heading_source != HEDR_SOURCE_GYRO) {
                return HEDR_NOT_SUPPORTED;
            }
            if (!hedr_robot_stands(r)) {
                return HEDR_NOT_WHILE_MOVING;
            }
            hedr_measure_bias_from_now(r);
            return HEDR_DONE;
        case HEDR_COMMAND_RESET_POSE:
            hedr_robot_reset_pose(r, q->x_mm, q->y_mm, q->heading);
            return HEDR_DONE;
        case HEDR_COMMAND_HEDR_ON:
        case HEDR_COMMAND_HEDR_OFF:
            r->config.hedr_on = q->number == HEDR_COMMAND_HEDR_ON;
            return HEDR_DONE;
        default:
            return HEDR_UNKNOWN_COMMAND;
    }
}

/* Does what a request asks and encodes the answer; returns the length of the frame. */
static inline uint8_t hedr_robot_answer(hedr_robot* r, const hedr_request* q, uint32_t time_us,
                                        uint8_t* frame, uint16_t sequence) {
    uint8_t result = HEDR_DONE;
    const int32_t* parameter;
    if (q->id == HEDR_ID_TIME_REQUEST) {
        return hedr_encode_time_echo(frame, sequence, q->token, time_us);
    }
    if (q->id == HEDR_ID_COMMAND) {
        return hedr_encode_acknowledge(frame, sequence, q->number, hedr_robot_command(r, q));
    }
    if (q->id == HEDR_ID_PARAMETER_SET) {
        result = hedr_robot_set_parameter(r, q->number, q->value);
    }
    parameter = hedr_parameter(&r->config, q->number);
    if (parameter == NULL) {
        result = HEDR_UNKNOWN_PARAMETER;
    }
    if (result != HEDR_DONE) {
        return hedr_encode_acknowledge(frame, sequence, q->id, result);
    }
    return hedr_encode_parameter(frame, sequence, q->number, *parameter);
}

#ifdef __cplusplus
}
#endif

#endif /* HEDR_ROBOT_H */
