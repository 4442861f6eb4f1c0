// First, because it configures zod before any schema is created.
export {
  MAX_PROBLEMS,
  describeProblem,
  parseJson,
  problem,
  readJson,
  readValue,
  type FieldProblem,
  type ReadResult,
} from "./document-reader.ts";
export { accessProblems, BLOCKED_SCRIPT, UNKNOWN_ROBOT, WRONG_KEY } from "./access-problems.ts";
export { MAX_CLOCK_DRIFT } from "./clock-drift.ts";
export { closeReasonOf, closeReasons, type CloseReason } from "./close-codes.ts";
export {
  classCodeSchema,
  CLASS_CODE_LENGTH,
  classFields,
  classIdSchema,
  classSettingsSchema,
  classViewSchema,
  createdClassSchema,
  joinedClassSchema,
  joinRequestSchema,
  MAX_PROGRAM_LINK,
  MAX_RENAMES,
  MAX_STUDENTS,
  NAME_WORDS,
  paceSchema,
  pauseRequestSchema,
  returnCodeSchema,
  studentNameSchema,
  studentProgramSchema,
  studentViewSchema,
  type ClassCode,
  type ClassSettings,
  type ClassView,
  type CreatedClass,
  type JoinedClass,
  type ReturnCode,
  type StudentName,
  type StudentProgram,
  type StudentView,
} from "./class.ts";
export {
  classHelloSchema,
  classRoles,
  relayToScreenSchema,
  relayToStudentSchema,
  relayToTeacherSchema,
  screenToRelaySchema,
  studentToRelaySchema,
  teacherToRelaySchema,
  type ClassEvent,
  type ClassHello,
  type ClassRole,
  type RelayToScreen,
  type RelayToStudent,
  type RelayToTeacher,
  type ScreenToRelay,
  type StudentTile,
  type StudentToRelay,
  type TeacherToRelay,
} from "./class-messages.ts";
export {
  attemptFailureSchema,
  MAX_BUMP_PLACES,
  progressRecordSchema,
  progressSchema,
  surveyAnswerSchema,
  type Progress,
  type ProgressRecord,
} from "./class-progress.ts";
export { studentNumberSchema } from "./class-quantities.ts";
export { MAX_TILE_LENGTH, tileSchema, type Tile } from "./class-tile.ts";
export { MAX_RACERS } from "./max-racers.ts";
export { REPORT_RATE, TILE_INTERVAL_MS, WATCHED_TILE_INTERVAL_MS } from "./student-rates.ts";
export {
  screenContentSchema,
  type Racer,
  type ScreenContent,
  type ScreenNumbers,
  type ScreenRun,
} from "./screen-content.ts";
export { decodeTeacherFrame, MAX_DISPLAY_LENGTH } from "./teacher-frame.ts";
export { decodeFrame, encodeFrame, MAX_FRAME_BYTES, MAX_HELLO_BYTES } from "./codec.ts";
export {
  actionNames,
  commandSchema,
  isVelocity,
  otherCommandSchema,
  plainActions,
  remoteActionNames,
  remoteCommandSchema,
  type Command,
  type PlainAction,
  type RemoteCommand,
} from "./command.ts";
export { MAX_CONDITIONS, MAX_PLUS, MAX_THAN } from "./condition-bounds.ts";
export {
  ruleConditionSchema,
  untilConditionSchema,
  untilSchema,
  type RuleCondition,
  type UntilCondition,
} from "./condition.ts";
export { commandRecordSchema, idempotencyKeySchema, type CommandRecord } from "./command-record.ts";
export { hasEnded, type CommandState, type EndingState } from "./command-state.ts";
export { expiredReason, waitingReason, type Obstacle } from "./expired-reason.ts";
export {
  BLOCKED_REASON,
  PAUSED_REASON,
  RELOADED_REASON,
  REVOKED_REASON,
  SILENT_REASON,
  SILENT_WORDS,
} from "./owner-reasons.ts";
export {
  eventGapSchema,
  eventPageSchema,
  EVENT_RETENTION_MS,
  MAX_STORED_EVENTS,
  sinceOf,
  sinceSchema,
  type EventGap,
  type EventPage,
  type StateEvent,
} from "./events.ts";
export {
  featureListSchema,
  hostFeatures,
  type FeatureList,
  type HostFeature,
} from "./host-features.ts";
export {
  keyIdSchema,
  keyListSchema,
  keyRequestSchema,
  createdKeySchema,
  MAX_KEYS,
  type KeyList,
  type KeyRequest,
  type CreatedKey,
} from "./keys.ts";
export {
  fetchedMessagesSchema,
  MAX_LONG_POLL_MESSAGES,
  openedConnectionSchema,
  sentMessagesSchema,
  takenMessagesSchema,
  type FetchedMessages,
  type OpenedConnection,
  type SentMessages,
  type TakenMessages,
} from "./long-poll.ts";
export {
  aliveDriverSchema,
  driversSchema,
  driverToRelaySchema,
  helloSchema,
  mazeVersionSchema,
  MAX_RESUMED_ENDINGS,
  pageToRelaySchema,
  recallCauses,
  relayToDriverSchema,
  relayToPageSchema,
  resumeSchema,
  type AliveDriver,
  type DeliveredCommand,
  type Drivers,
  type DriverToRelay,
  type Ending,
  type Hello,
  type PageToRelay,
  type RecallCause,
  type RelayToDriver,
  type RelayToPage,
  type Resume,
} from "./messages.ts";
export {
  marksFields,
  MAX_MARKED_CELLS,
  type CellMark,
  type MarkColor,
  type Marks,
} from "./marks.ts";
export { MAX_AGE_MS, orderSchema, termsOf, type CommandTerms, type Order } from "./order.ts";
export { LEASE_MS, TTL_MS } from "./term-bounds.ts";
export { decodeDriverFrame } from "./driver-frame.ts";
export { findSnapshot, findSnapshotMessage, type SnapshotSpan } from "./snapshot-text.ts";
export {
  PAIRING_LENGTH,
  PAIRING_LETTERS,
  pairingAnswerSchema,
  requestedPairingSchema,
  createdPairingSchema,
  pairingReplySchema,
  pairingSchema,
  pairingRequestSchema,
  type Pairing,
  type PairingAnswer,
  type RequestedPairing,
  type CreatedPairing,
} from "./pairing.ts";
export { problemSchema, type ProblemDocument } from "./problem.ts";
export { driverSchema, type DriverName, type Pose, type SensorReadings } from "./quantities.ts";
export { readRobotAddress, type RobotAddress } from "./robot-address.ts";
export { registrationSchema, robotIdSchema, type Registration } from "./registration.ts";
export {
  storedLinksSchema,
  MAX_DOCUMENT_BYTES,
  MAX_STORED_LINKS,
  shortLinkIdSchema,
  shortLinkSchema,
  type ShortLink,
  readShortCode,
  SHORT_CODE_LENGTHS,
} from "./short-link.ts";
export { frameMarkup, frameSizes, type EmbeddedFrame, type FrameSize } from "./embedded-frame.ts";
export {
  readFrameRequest,
  type FrameProblem,
  type FrameReport,
  type FrameRequest,
} from "./frame-messages.ts";
export { keyPrefixes } from "./key-prefixes.ts";
export { MAX_LINK_LENGTH } from "./link-length.ts";
export { LONG_POLL_SECONDS, SILENCE_MS } from "./connection-times.ts";
export { gatewayNames, type GatewayName } from "./gateway-names.ts";
export { MotionRegister } from "./motion-register.ts";
export {
  bridgeAgent,
  bridgePrefix,
  protocolClients,
  type ClientProtocol,
} from "./protocol-clients.ts";
export {
  checkCommand,
  READ_ONLY,
  RefusedError,
  type PublishedMaze,
  type RobotListener,
  type RobotPort,
} from "./robot-port.ts";
export { sendAndWait } from "./send-and-wait.ts";
export { snapshotSchema, type LineRef, type RobotReport, type Snapshot } from "./snapshot.ts";
export {
  MAX_PROBLEM_TEXT,
  MAX_SENT_NAME,
  MAX_SCRIPT_NAME,
  MAX_SCRIPTS,
  MAX_BLOCKED_SCRIPTS,
  scriptIdSchema,
  scriptListSchema,
  scriptName,
  scriptRefSchema,
  scriptSchema,
  blockedScriptSchema,
  type ScriptList,
  type ScriptRef,
  type ScriptView,
  type BlockedScript,
} from "./scripts.ts";
export type { SocketEvents, SocketFactory, SocketPort } from "./socket-port.ts";
export type { Timers } from "./timers.ts";
export { PROTOCOL_VERSION } from "./version.ts";
export { TICKS_PER_SECOND } from "./ticks.ts";
export { MAX_RUN_INPUTS, MAX_RUN_TICKS } from "./run-bounds.ts";
export { timedCommandsSchema, type TimedCommand } from "./timed-command.ts";
export { sensorNames, type SensorName } from "./sensor-names.ts";
export { isTemporary } from "./temporary-failure.ts";
