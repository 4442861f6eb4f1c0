/**
 * Names of the schemas, as generated clients show them. Nested objects are named too, because
 * generators create long names for them, and some fail on unnamed alternatives.
 */
import {
  challengeOrLessonSchema,
  challengeSchema,
  lessonSchema,
} from "@corridor/challenge/document";
import { projectSchema } from "@corridor/link/project";
import { mazeSchema } from "@corridor/maze";
import { programSchema } from "@corridor/program";
import {
  attemptFailureSchema,
  classCodeSchema,
  classHelloSchema,
  classSettingsSchema,
  classViewSchema,
  commandRecordSchema,
  eventPageSchema,
  fetchedMessagesSchema,
  helloSchema,
  keyListSchema,
  keyRequestSchema,
  createdClassSchema,
  createdKeySchema,
  joinedClassSchema,
  joinRequestSchema,
  openedConnectionSchema,
  orderSchema,
  otherCommandSchema,
  paceSchema,
  pairingAnswerSchema,
  requestedPairingSchema,
  createdPairingSchema,
  pairingReplySchema,
  pairingSchema,
  pairingRequestSchema,
  pauseRequestSchema,
  problemSchema,
  progressRecordSchema,
  progressSchema,
  registrationSchema,
  remoteCommandSchema,
  returnCodeSchema,
  ruleConditionSchema,
  scriptListSchema,
  scriptRefSchema,
  blockedScriptSchema,
  sentMessagesSchema,
  shortLinkSchema,
  snapshotSchema,
  studentNameSchema,
  studentProgramSchema,
  surveyAnswerSchema,
  takenMessagesSchema,
  untilConditionSchema,
} from "@corridor/protocol";
import type { z } from "zod";
import { createSchema, type oas31, type ZodOpenApiOverride } from "zod-openapi";
import { documentSchema } from "../short-links/document-schema.ts";
import { classRequestSchema } from "./rest/classes/reading.ts";
import { commandLogSchema } from "./rest/commands/openapi.ts";
import { oembedSchema } from "./rest/embedding/oembed.ts";
import { heldSessionSchema } from "./rest/robots/openapi.ts";
import { describeByExpectation } from "../platform/openapi/describe-by-expectation.ts";
import { streamedEventSchema } from "./sse/streamed-event.ts";

const { gap, states } = eventPageSchema.shape;
const script = scriptListSchema.shape.scripts.element;

const task = lessonSchema.shape.tasks.element;
const { allowed } = task.shape;

const [untilSensor, untilLeftRight, untilGoal] = untilConditionSchema.def.out.options;
const [ruleSensor, ruleLeftRight] = ruleConditionSchema.def.out.options;

/** Kinds of the conditions, by the name of the schema that accepts all of them. */
const conditionKinds: Record<string, Record<string, z.ZodType>> = {
  UntilCondition: {
    SensorUntilCondition: untilSensor,
    LeftRightUntilCondition: untilLeftRight,
    GoalUntilCondition: untilGoal,
  },
  RuleCondition: { SensorRuleCondition: ruleSensor, LeftRightRuleCondition: ruleLeftRight },
};

export const schemas: Record<string, z.ZodType> = {
  Command: remoteCommandSchema,
  ...alternatives("Command", "action", remoteCommandSchema),
  OtherCommand: otherCommandSchema,
  UntilCondition: untilConditionSchema,
  RuleCondition: ruleConditionSchema,
  ...Object.assign({}, ...Object.values(conditionKinds)),
  CommandLog: commandLogSchema,
  CommandRecord: commandRecordSchema,
  Order: orderSchema,
  ...alternatives("Order", "action", orderSchema),
  Snapshot: snapshotSchema,
  Pose: snapshotSchema.shape.pose,
  SensorReadings: snapshotSchema.shape.sensors,
  EventPage: eventPageSchema,
  Gap: gap.unwrap(),
  OpenCommand: gap.unwrap().shape.open.element,
  NumberedState: states.element,
  StreamedEvent: streamedEventSchema,
  ...alternatives("Event", "event", streamedEventSchema),
  Problem: problemSchema,
  FieldProblem: problemSchema.shape.errors.element,
  Registration: registrationSchema,
  HeldSession: heldSessionSchema,
  Drivers: heldSessionSchema.shape.drivers,
  KeyRequest: keyRequestSchema,
  CreatedKey: createdKeySchema,
  KeyUrls: createdKeySchema.shape.urls.unwrap(),
  KeyList: keyListSchema,
  Key: keyListSchema.shape.keys.element,
  ScriptList: scriptListSchema,
  Script: script,
  ScriptProblem: script.shape.lastProblem.unwrap(),
  LastCommand: script.shape.last.unwrap(),
  ScriptRef: scriptRefSchema,
  BlockedScript: blockedScriptSchema,
  CreatedPairing: createdPairingSchema,
  Pairing: pairingSchema,
  PairingQuestion: pairingSchema.shape.question.unwrap(),
  PairingReply: pairingReplySchema,
  PairingRequest: pairingRequestSchema,
  RequestedPairing: requestedPairingSchema,
  PairingAnswer: pairingAnswerSchema,
  Hello: helloSchema,
  OpenedConnection: openedConnectionSchema,
  SentMessages: sentMessagesSchema,
  TakenMessages: takenMessagesSchema,
  FetchedMessages: fetchedMessagesSchema,
  Message: sentMessagesSchema.shape.messages.element,
  CloseReason: fetchedMessagesSchema.shape.closed.unwrap(),
  SharedDocument: documentSchema,
  ShortLink: shortLinkSchema,
  Oembed: oembedSchema,
  Maze: mazeSchema,
  MazeStart: mazeSchema.shape.start,
  MazeCell: mazeSchema.shape.goals.element,
  Program: programSchema,
  Rule: programSchema.shape.rules.element,
  Challenge: challengeSchema,
  ChallengeWords: challengeSchema.shape.words,
  Goal: challengeSchema.shape.goal,
  ...alternatives("Goal", "kind", challengeSchema.shape.goal),
  Allowed: challengeSchema.shape.allowed,
  Checks: challengeSchema.shape.checks,
  Par: challengeSchema.shape.par.unwrap(),
  ChallengeOrLesson: challengeOrLessonSchema,
  Lesson: lessonSchema,
  Task: task,
  LessonGoal: task.shape.goal,
  ...alternatives("LessonGoal", "kind", task.shape.goal),
  LessonAllowed: allowed,
  // Named, because generators of Java write no valid code for sets of unnamed enums.
  AllowedDriver: allowed.shape.drivers.element,
  AllowedCondition: allowed.shape.conditions.unwrap().element,
  AllowedAction: allowed.shape.actions.unwrap().element,
  AllowedEdit: allowed.shape.edits.element,
  AllowedTool: allowed.shape.tools.unwrap().element,
  AllowedHelp: allowed.shape.help.unwrap().element,
  LessonChecks: task.shape.checks,
  LessonPar: task.shape.par.unwrap(),
  UnseenMazes: task.shape.unseen.unwrap(),
  SurveyQuestion: lessonSchema.shape.survey.element,
  Project: projectSchema,
  ClassHello: classHelloSchema,
  ClassRequest: classRequestSchema,
  CreatedClass: createdClassSchema,
  JoinRequest: joinRequestSchema,
  JoinedClass: joinedClassSchema,
  StudentName: studentNameSchema,
  Class: classViewSchema,
  ClassSettings: classSettingsSchema,
  Student: classViewSchema.shape.students.element,
  ProgressRecord: progressRecordSchema,
  Progress: progressSchema,
  ...alternatives("Progress", "kind", progressSchema),
  AttemptFailure: attemptFailureSchema,
  SurveyAnswer: surveyAnswerSchema,
  PauseRequest: pauseRequestSchema,
  Pace: paceSchema,
  ClassCode: classCodeSchema,
  ReturnCode: returnCodeSchema,
  StudentProgram: studentProgramSchema,
};

/** Conditions have a custom parser. This describes the expected value. */
export const describeCondition: ZodOpenApiOverride = ({ zodSchema, jsonSchema }) => {
  const condition = [ruleConditionSchema, untilConditionSchema].find((each) => each === zodSchema);
  if (condition === undefined) return;
  const opts = { override: describeByExpectation };
  Object.assign(jsonSchema, createSchema(condition.def.out, { opts }).schema);
};

/** References the kinds of the conditions by name, so that generated clients show these names. */
export function withConditionKinds(document: oas31.OpenAPIObject): oas31.OpenAPIObject {
  for (const [name, kinds] of Object.entries(conditionKinds)) {
    const condition = document.components?.schemas?.[name];
    const anyOf = Object.keys(kinds).map((kind) => ({ $ref: `#/components/schemas/${kind}` }));
    if (condition !== undefined) Object.assign(condition, { anyOf });
  }
  return document;
}

/**
 * A discriminator of OpenAPI is a string, and the version of a lesson is a number. Versions are whole
 * numbers, because a constant of Java cannot be a decimal number.
 */
export const describeVersions: ZodOpenApiOverride = ({ zodSchema, jsonSchema }) => {
  if (zodSchema === challengeOrLessonSchema) delete jsonSchema["discriminator"];
  if (Number.isInteger(jsonSchema.const)) jsonSchema.type = "integer";
};

/**
 * Names the alternatives of a union by their discriminator: `left 90` of Command is
 * `Left90Command`.
 */
function alternatives(
  name: string,
  field: string,
  { options }: { options: readonly z.ZodObject[] },
): Record<string, z.ZodType> {
  return Object.fromEntries(
    options.map((option) => {
      const literal = option.shape[field] as z.ZodLiteral<string>;
      const words = literal.value.split(" ");
      return [words.map((word) => word[0]?.toUpperCase() + word.slice(1)).join("") + name, option];
    }),
  );
}
