// What the robot does, in MAVLink's axes and units: a circle to the right, 1 m/s and 0.2 rad/s, from
// the origin northwards. Every other field has a value of its own, so that none can be taken for its
// neighbour; tests/e2e/mavlink_peer/expected.h says the same in C++.

const RATE = 0.2
const RADIUS_M = 5
const TRACK_M = 0.5

// `mavlink`: the classes of node-mavlink; `s`: since the drive began; `ms`: since boot.
export function messagesAt(mavlink, autopilot, s, ms) {
    const { minimal, common } = mavlink
    const usec = 1000n * BigInt(ms)
    const yaw = RATE * s
    const north = RADIUS_M * Math.sin(yaw)
    const east = RADIUS_M * (1 - Math.cos(yaw))
    const ramp = (n, from) => Array.from({ length: n }, (_, i) => from + i)
    const said = (Message, fields) => Object.assign(new Message(), fields)
    return {
        HEARTBEAT: said(minimal.Heartbeat, {
            customMode: 305419896, type: minimal.MavType.GROUND_ROVER, autopilot, baseMode: 81,
            systemStatus: minimal.MavState.ACTIVE, mavlinkVersion: 3 }),
        ATTITUDE: said(common.Attitude, {
            timeBootMs: ms, roll: 0.0625, pitch: -0.125, yaw, rollspeed: 0.03125,
            pitchspeed: -0.25, yawspeed: RATE }),
        LOCAL_POSITION_NED: said(common.LocalPositionNed, {
            timeBootMs: ms, x: north, y: east, z: -0.5, vx: Math.cos(yaw), vy: Math.sin(yaw),
            vz: 0.0625 }),
        ODOMETRY: said(common.Odometry, {
            timeUsec: usec, frameId: common.MavFrame.LOCAL_NED, childFrameId: 12 /* BODY_FRD */,
            x: north, y: east, z: -0.5, q: [Math.cos(yaw / 2), 0, 0, Math.sin(yaw / 2)], vx: 1,
            vy: 0.5, vz: 0.0625, rollspeed: 0.03125, pitchspeed: -0.25, yawspeed: RATE,
            poseCovariance: ramp(21, 1), velocityCovariance: ramp(21, 101), resetCounter: 3,
            estimatorType: 2, quality: 88 }),
        WHEEL_DISTANCE: said(common.WheelDistance, {
            timeUsec: usec, count: 2,
            distance: [(1 + RATE * TRACK_M / 2) * s, (1 - RATE * TRACK_M / 2) * s, ...ramp(14, 2)] }),
        SCALED_IMU: said(common.ScaledImu, {
            timeBootMs: ms, xacc: 11, yacc: -12, zacc: -1001, xgyro: 21, ygyro: -22, zgyro: 200,
            xmag: 210, ymag: 30, zmag: -430, temperature: 2150 }),
        RAW_IMU: said(common.RawImu, {
            timeUsec: usec, xacc: 13, yacc: -14, zacc: -1002, xgyro: 23, ygyro: -24, zgyro: 200,
            xmag: 220, ymag: -40, zmag: 440, id: 1, temperature: -350 }),
        HIGHRES_IMU: said(common.HighresImu, {
            timeUsec: usec, xacc: 0.5, yacc: -0.25, zacc: -9.75, xgyro: 0.03125, ygyro: -0.0625,
            zgyro: RATE, xmag: 0.25, ymag: 0.125, zmag: -0.5, absPressure: 1013.25,
            diffPressure: 0.75, pressureAlt: 120.5, temperature: 36.5, fieldsUpdated: 0x1fff,
            id: 2 }),
        SYS_STATUS: said(common.SysStatus, {
            onboardControlSensorsPresent: 0x02008001, onboardControlSensorsEnabled: 0x02008001,
            onboardControlSensorsHealth: 0x00008000, load: 321, voltageBattery: 12340,
            currentBattery: -567, dropRateComm: 89, errorsComm: 12, errorsCount1: 1,
            errorsCount2: 2, errorsCount3: 3, errorsCount4: 4, batteryRemaining: 76,
            onboardControlSensorsPresentExtended: 5, onboardControlSensorsEnabledExtended: 6,
            onboardControlSensorsHealthExtended: 7 }),
        RADIO_STATUS: said(common.RadioStatus, {
            rssi: 190, remrssi: 171, txbuf: 99, noise: 38, remnoise: 39, rxerrors: 513, fixed: 258 }),
    }
}
