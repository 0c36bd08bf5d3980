/* All of signing as a robot's program would link it: what it costs beside the encoders. */
#include "radio/firmware/hedr_robot.h"

uint8_t robot_sign(hedr_signing* signing, uint8_t* frame, uint8_t size);
uint8_t robot_hear(hedr_decoder* decoder, hedr_signing* signing, uint8_t byte, hedr_request* out);
void robot_start(hedr_signing* signing, const uint8_t* key, const hedr_counters* kept,
                 void (*keep)(const hedr_counters* counters));

uint8_t robot_sign(hedr_signing* signing, uint8_t* frame, uint8_t size) {
    return hedr_sign(signing, frame, size);
}

uint8_t robot_hear(hedr_decoder* decoder, hedr_signing* signing, uint8_t byte, hedr_request* out) {
    return hedr_decoder_push_signed(decoder, signing, byte, out);
}

void robot_start(hedr_signing* signing, const uint8_t* key, const hedr_counters* kept,
                 void (*keep)(const hedr_counters* counters)) {
    hedr_signing_init(signing, key, kept, keep);
}
