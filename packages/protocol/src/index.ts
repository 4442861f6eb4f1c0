export { commandSchema, plainActions, type Command, type PlainAction } from "./command.ts";
export {
  commandRecordSchema,
  hasEnded,
  type CommandRecord,
  type CommandState,
  type EndingState,
} from "./command-record.ts";
export {
  describeProblem,
  problem,
  readJson,
  readValue,
  type FieldProblem,
  type ReadResult,
} from "./document-reader.ts";
export { problemSchema, type ProblemDocument } from "./problem.ts";
export {
  sensorNames,
  type DriverName,
  type Pose,
  type SensorName,
  type SensorReadings,
} from "./quantities.ts";
export { snapshotSchema, type LineRef, type RobotReport, type Snapshot } from "./snapshot.ts";
