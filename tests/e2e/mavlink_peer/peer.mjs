// A robot that speaks MAVLink on standard input and output, as node-mavlink understands MAVLink.
//   node peer.mjs MODULES [--v1] [--slow] [--autopilot N] [--say HIGHRES_IMU,ODOMETRY,…]
// MODULES: where packaging/mavlink-peer.sh has installed node-mavlink. It talks until its input
// ends. Heartbeat, status, radio and text are always said; it obeys what answers.mjs tells. The slow one says of how
// it moves what nobody asked for four times a second only, as autopilots do.

import { createRequire } from 'node:module'
import { resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { answersTo, askedFor } from './answers.mjs'
import { messagesAt } from './motion.mjs'

const SYSTEM = 7
const AUTOPILOT_COMPONENT = 1
const MODEM = { system: 51, component: 68 } // as SiK modems call themselves
const START_MS = 100000 // the robot has run for so long already
const BACKLOG_MS = 2100 // of its drive, said at once: the receiver listens for two seconds first
const PERIOD_MS = 20
const SLOW_MS = 240
const ARDUPILOT = '3'

const { values: options, positionals } = parseArgs({
    allowPositionals: true,
    options: {
        slow: { type: 'boolean', default: false },
        v1: { type: 'boolean', default: false },
        autopilot: { type: 'string', default: '0' },
        say: { type: 'string', default: '' },
    },
})
const mavlink = createRequire(resolve(positionals[0], 'package.json'))('node-mavlink')
const { MavLinkProtocolV1, MavLinkProtocolV2, MavLinkPacketSignature, common } = mavlink

const sequences = new Map()
function nextSequence(system) {
    const sequence = sequences.get(system) ?? 0
    sequences.set(system, (sequence + 1) % 256)
    return sequence
}

function say(message, from = { system: SYSTEM, component: AUTOPILOT_COMPONENT }) {
    const Protocol = options.v1 ? MavLinkProtocolV1 : MavLinkProtocolV2
    const protocol = new Protocol(from.system, from.component)
    process.stdout.write(protocol.serialize(message, nextSequence(from.system)))
}

function saySigned(message) {
    const signed = MavLinkProtocolV2.IFLAG_SIGNED
    const protocol = new MavLinkProtocolV2(SYSTEM, AUTOPILOT_COMPONENT, signed)
    const frame = protocol.serialize(message, nextSequence(SYSTEM))
    process.stdout.write(protocol.sign(frame, 1, MavLinkPacketSignature.key('a secret')))
}

function text(severity, words) {
    return Object.assign(new common.StatusText(), { severity, text: words, id: 0, chunkSeq: 0 })
}

const begin = performance.now()
const sinceBoot_ms = () => START_MS + BACKLOG_MS + performance.now() - begin
const wanted = options.say.split(',').filter((name) => name !== '')

function sayAt(ms) {
    const messages = messagesAt(mavlink, Number(options.autopilot), (ms - START_MS) / 1000, ms)
    if ((ms - START_MS) % 500 === 0) {
        say(messages.HEARTBEAT)
        say(messages.SYS_STATUS)
        say(messages.RADIO_STATUS, MODEM)
    }
    for (const name of wanted) {
        const asked = !options.slow || askedFor.has(messages[name].constructor.MSG_ID)
        if (asked || (ms - START_MS) % SLOW_MS === 0) say(messages[name])
    }
}

let next_ms = START_MS
function catchUp() {
    for (; next_ms <= sinceBoot_ms(); next_ms += PERIOD_MS) sayAt(next_ms)
}
catchUp()
say(text(common.MavSeverity.WARNING, 'Wheel slips'))
say(text(common.MavSeverity.INFO, 'x'.repeat(50)))
if (!options.v1) saySigned(text(common.MavSeverity.INFO, 'Signed'))
const timer = setInterval(catchUp, PERIOD_MS)

mavlink.createMavLinkStream(process.stdin).on('data', (packet) => {
    for (const answer of answersTo(mavlink, packet, SYSTEM, sinceBoot_ms,
        options.autopilot === ARDUPILOT)) say(answer)
})
process.stdin.on('end', () => clearInterval(timer))
process.stdout.on('error', () => process.exit()) // nobody listens any more
