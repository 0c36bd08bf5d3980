// What the robot does with a request.

const INT32 = 6 // MAV_PARAM_TYPE
const REAL32 = 9

// HEDR_DIRECTIONS cannot be set: it stays as it is. HEDR_GAIN_URAD is a float, as all of ArduPilot's
// parameters are; the others are integers, whose bits travel in a float.
const parameters = new Map([
    ['HEDR_BASE_UM', { type: INT32, value: 400000 }],
    ['HEDR_OFFSET', { type: INT32, value: 0 }],
    ['HEDR_GAIN_URAD', { type: REAL32, value: 20 }],
    ['HEDR_DIRECTIONS', { type: INT32, value: 4, fixed: true }],
])

const MEASURE_BIAS = 31010
const RESET_POSE = 31011
const HEDR_ON = 31012

// The four bytes at the payload's beginning, for small negative integers are no number as a float.
// (JavaScript keeps the bits of those above -4194304 on the way back.)
function written(packet, type) {
    return type === INT32 ? packet.payload.readInt32LE(0) : packet.payload.readFloatLE(0)
}

function valueOf({ common }, name, index) {
    const { type, value } = parameters.get(name)
    const bits = Buffer.alloc(4)
    if (type === INT32) bits.writeInt32LE(value)
    else bits.writeFloatLE(value)
    return Object.assign(new common.ParamValue(), {
        paramId: name, paramValue: bits.readFloatLE(0), paramType: type,
        paramCount: parameters.size, paramIndex: index })
}

function set(mavlink, packet, request) {
    const parameter = parameters.get(request.paramId)
    if (!parameter) return []
    if (!parameter.fixed) parameter.value = written(packet, request.paramType)
    return [valueOf(mavlink, request.paramId, [...parameters.keys()].indexOf(request.paramId))]
}

function read(mavlink, request) {
    if (!parameters.has(request.paramId) || request.paramIndex !== -1) return []
    return [valueOf(mavlink, request.paramId, [...parameters.keys()].indexOf(request.paramId))]
}

function obey({ common }, packet, request) {
    const { ACCEPTED, TEMPORARILY_REJECTED, UNSUPPORTED } = common.MavResult
    const results = { [MEASURE_BIAS]: ACCEPTED, [RESET_POSE]: ACCEPTED, [HEDR_ON]: TEMPORARILY_REJECTED }
    const ack = Object.assign(new common.CommandAck(), {
        command: request.command, result: results[request.command] ?? UNSUPPORTED, progress: 255,
        targetSystem: packet.header.sysid, targetComponent: packet.header.compid })
    if (request.command !== RESET_POSE) return [ack]
    const [north, east, yaw] = [0, 4, 8].map((at) => packet.payload.readFloatLE(at).toFixed(2))
    const said = Object.assign(new common.StatusText(), {
        severity: common.MavSeverity.INFO, text: `at ${north} ${east} yaw ${yaw}` })
    return [ack, said]
}

// `sinceBoot_ms`: the robot's clock.
export function answersTo(mavlink, packet, system, sinceBoot_ms) {
    const { common } = mavlink
    const known = [common.ParamSet, common.ParamRequestRead, common.CommandLong, common.TimeSync]
    const Message = known.find((each) => each.MSG_ID === packet.header.msgid)
    if (!Message) return []
    const request = packet.protocol.data(packet.payload, Message)
    if (request.targetSystem !== system && request.targetSystem !== 0) return []
    if (Message === common.ParamSet) return set(mavlink, packet, request)
    if (Message === common.ParamRequestRead) return read(mavlink, request)
    if (Message === common.CommandLong) return obey(mavlink, packet, request)
    if (request.tc1 !== 0n) return []
    return [Object.assign(new common.TimeSync(), {
        tc1: BigInt(Math.round(1e6 * sinceBoot_ms())), ts1: request.ts1,
        targetSystem: packet.header.sysid, targetComponent: packet.header.compid })]
}
