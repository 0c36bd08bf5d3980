// What the robot does with a request.

const INT32 = 6 // MAV_PARAM_TYPE
const REAL32 = 9

// HEDR_DIRECTIONS cannot be set: it stays as it is. HEDR_GAIN_URAD is a float, as all of ArduPilot's
// parameters are; the others are integers, whose bits travel in a float, from ArduPilot their values.
const parameters = new Map([
    ['HEDR_BASE_UM', { type: INT32, value: 400000 }],
    ['HEDR_OFFSET', { type: INT32, value: 0 }],
    ['HEDR_GAIN_URAD', { type: REAL32, value: 20 }],
    ['HEDR_DIRECTIONS', { type: INT32, value: 4, fixed: true }],
])

const MEASURE_BIAS = 31010
const RESET_POSE = 31011
const HEDR_ON = 31012
const SET_MESSAGE_INTERVAL = 511

// The messages, by their ids, that were asked for at the usual rate.
export const askedFor = new Set()

// The four bytes at the payload's beginning, for small negative integers are no number as a float.
// (JavaScript keeps the bits of those above -4194304 on the way back.)
function written(packet, type, byValue) {
    return type === INT32 && !byValue ? packet.payload.readInt32LE(0) : packet.payload.readFloatLE(0)
}

function valueOf({ common }, name, index, byValue) {
    const { type, value } = parameters.get(name)
    const bits = Buffer.alloc(4)
    if (type === INT32 && !byValue) bits.writeInt32LE(value)
    else bits.writeFloatLE(value)
    return Object.assign(new common.ParamValue(), {
        paramId: name, paramValue: bits.readFloatLE(0), paramType: type,
        paramCount: parameters.size, paramIndex: index })
}

function set(mavlink, packet, request, byValue) {
    const parameter = parameters.get(request.paramId)
    if (!parameter) return []
    if (!parameter.fixed) parameter.value = written(packet, request.paramType, byValue)
    return [valueOf(mavlink, request.paramId, [...parameters.keys()].indexOf(request.paramId), byValue)]
}

function read(mavlink, request, byValue) {
    if (!parameters.has(request.paramId) || request.paramIndex !== -1) return []
    return [valueOf(mavlink, request.paramId, [...parameters.keys()].indexOf(request.paramId), byValue)]
}

function obey({ common }, packet, request) {
    const { ACCEPTED, TEMPORARILY_REJECTED, UNSUPPORTED } = common.MavResult
    if (request.command === SET_MESSAGE_INTERVAL && packet.payload.readFloatLE(4) === 50000) {
        askedFor.add(packet.payload.readFloatLE(0))
    }
    const results = { [SET_MESSAGE_INTERVAL]: ACCEPTED, [MEASURE_BIAS]: ACCEPTED, [RESET_POSE]: ACCEPTED, [HEDR_ON]: TEMPORARILY_REJECTED }
    const ack = Object.assign(new common.CommandAck(), {
        command: request.command, result: results[request.command] ?? UNSUPPORTED, progress: 255,
        targetSystem: packet.header.sysid, targetComponent: packet.header.compid })
    if (request.command !== RESET_POSE) return [ack]
    const [north, east, yaw] = [0, 4, 8].map((at) => packet.payload.readFloatLE(at).toFixed(2))
    const said = Object.assign(new common.StatusText(), {
        severity: common.MavSeverity.INFO, text: `at ${north} ${east} yaw ${yaw}` })
    return [ack, said]
}

// `sinceBoot_ms`: the robot's clock. `byValue`: integer parameters travel as ArduPilot's.
export function answersTo(mavlink, packet, system, sinceBoot_ms, byValue) {
    const { common } = mavlink
    const known = [common.ParamSet, common.ParamRequestRead, common.CommandLong, common.TimeSync]
    const Message = known.find((each) => each.MSG_ID === packet.header.msgid)
    if (!Message) return []
    const request = packet.protocol.data(packet.payload, Message)
    if (request.targetSystem !== system && request.targetSystem !== 0) return []
    if (Message === common.ParamSet) return set(mavlink, packet, request, byValue)
    if (Message === common.ParamRequestRead) return read(mavlink, request, byValue)
    if (Message === common.CommandLong) return obey(mavlink, packet, request)
    if (request.tc1 !== 0n) return []
    return [Object.assign(new common.TimeSync(), {
        tc1: BigInt(Math.round(1e6 * sinceBoot_ms())), ts1: request.ts1,
        targetSystem: packet.header.sysid, targetComponent: packet.header.compid })]
}
