// Writes a pair of each message: npm install node-mavlink && node make_golden.js FOLDER
// Every field has another value, negative where it may be, so that no two can be confused.
const fs = require('fs');
const path = require('path');
const {MavLinkProtocolV1, MavLinkProtocolV2, MavLinkPacketSignature, common, minimal} =
    require('node-mavlink');

const kMessages = [
    minimal.Heartbeat, common.SysStatus, common.ParamRequestRead, common.ParamValue,
    common.ParamSet, common.ScaledImu, common.RawImu, common.Attitude, common.LocalPositionNed,
    common.CommandLong, common.CommandAck, common.HighresImu, common.RadioStatus, common.TimeSync,
    common.StatusText, common.Odometry, common.WheelDistance,
];

const kSigned = [minimal.Heartbeat, common.Attitude, common.Odometry];

function valueOf(type, n) {
    if (type === 'float') return Math.fround((n % 2 ? -1 : 1) * (n + 0.625));
    if (type === 'double') return (n % 2 ? -1 : 1) * (1000 * n + 0.123456789);
    if (type === 'uint64_t') return 12345678901n + BigInt(n);
    if (type === 'int64_t') return -98765432109n - BigInt(n);
    if (type === 'uint32_t') return 0x81020300 + n;
    if (type === 'int32_t') return -1234567 - n;
    if (type === 'uint16_t') return 0x9100 + n;
    if (type === 'int16_t') return -300 - n;
    if (type === 'int8_t') return -10 - n;
    return 130 + n;  // uint8_t
}

function fill(definition) {
    const message = new definition();
    const words = {};
    definition.FIELDS.forEach((field, i) => {
        const type = field.type.replace('[]', '');
        let value;
        if (type === 'char') {
            value = 'HEDR_text_of_some_length_and_more_words_up_to_fifty'.slice(0, field.length - 1);
        } else if (field.length > 0) {
            value = Array.from({length: field.length}, (_, k) => valueOf(type, i + k));
        } else {
            value = valueOf(type, i);
        }
        message[field.name] = value;
        words[field.source] = typeof value === 'bigint' ? Number(value) : value;
    });
    return {message, words};
}

function write(folder, name, bytes, words) {
    fs.writeFileSync(path.join(folder, name + '.bin'), bytes);
    fs.writeFileSync(path.join(folder, name + '.json'), JSON.stringify(words, null, 1) + '\n');
}

const folder = process.argv[2];
kMessages.forEach((definition, i) => {
    const {message, words} = fill(definition);
    const name = definition.MSG_NAME.toLowerCase();
    const head = {message: definition.MSG_NAME, id: definition.MSG_ID, sequence: 40 + i,
                  system: 7, component: 1};
    write(folder, name + '_v2', new MavLinkProtocolV2(7, 1).serialize(message, 40 + i),
          {...head, version: 2, signed: false, fields: words});
    if (definition.MSG_ID < 256) {
        write(folder, name + '_v1', new MavLinkProtocolV1(7, 1).serialize(message, 40 + i),
              {...head, version: 1, signed: false, fields: words});
    }
    if (!kSigned.includes(definition)) return;
    const protocol = new MavLinkProtocolV2(7, 1, MavLinkProtocolV2.IFLAG_SIGNED);
    const key = MavLinkPacketSignature.key('golden');
    write(folder, name + '_signed',
          protocol.sign(protocol.serialize(message, 40 + i), 1, key, Date.UTC(2026, 0, 1)),
          {...head, version: 2, signed: true, fields: words});
});

// Zeros at the end, which version 2 leaves out.
const zero = new common.Attitude();
zero.timeBootMs = 5;
const words = {time_boot_ms: 5, roll: 0, pitch: 0, yaw: 0, rollspeed: 0, pitchspeed: 0, yawspeed: 0};
for (const field of ['roll', 'pitch', 'yaw', 'rollspeed', 'pitchspeed', 'yawspeed']) zero[field] = 0;
write(folder, 'attitude_truncated', new MavLinkProtocolV2(7, 1).serialize(zero, 90),
      {message: 'ATTITUDE', id: 30, sequence: 90, system: 7, component: 1, version: 2,
       signed: false, fields: words});
