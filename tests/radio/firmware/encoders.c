/* All encoders as a robot's program would link them: proves that the header is C99, and what its
 * encoders cost. The test compiles this file alone and measures the object. */
#include "radio/firmware/hedr_robot.h"

uint8_t robot_encode(uint8_t* frame, uint16_t sequence, uint8_t id, const void* message);

uint8_t robot_encode(uint8_t* frame, uint16_t sequence, uint8_t id, const void* message) {
    const int32_t* numbers = (const int32_t*)message;
    switch (id) {
        case HEDR_ID_HELLO:
            return hedr_encode_hello(frame, sequence, (const hedr_hello*)message);
        case HEDR_ID_POSE:
            return hedr_encode_pose(frame, sequence, (const hedr_pose*)message);
        case HEDR_ID_SENSORS:
            return hedr_encode_sensors(frame, sequence, (const hedr_sensors*)message);
        case HEDR_ID_STATUS:
            return hedr_encode_status(frame, sequence, (const hedr_status*)message);
        case HEDR_ID_PARAMETER:
            return hedr_encode_parameter(frame, sequence, (uint8_t)numbers[0], numbers[1]);
        case HEDR_ID_ACKNOWLEDGE:
            return hedr_encode_acknowledge(frame, sequence, (uint8_t)numbers[0],
                                           (uint8_t)numbers[1]);
        case HEDR_ID_EVENT:
            return hedr_encode_event(frame, sequence, 0, (const char*)message);
        case HEDR_ID_TIME_ECHO:
            return hedr_encode_time_echo(frame, sequence, (uint32_t)numbers[0],
                                         (uint32_t)numbers[1]);
        default:
            return 0;
    }
}
