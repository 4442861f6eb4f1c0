/** The texts of the announced run and of Describe. */
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { TFunction } from "i18next";
import { asSentence, joinList, joinSentences } from "../../text/joined.ts";
import { formatReading, localNumber } from "../../text/numbers.ts";
import {
  decidingLine,
  isDecidedHere,
  isDriving,
  shownProgress,
  shownTruth,
} from "../run/line-state.ts";
import type { RunState } from "../run/run-store.ts";
import { timeText } from "../run/time-text.ts";
import { lineName } from "../run/line-name.ts";
import { cellOf, facingOf } from "../../stage/page/robot-place.ts";

/** A translator and its language. */
export interface Words {
  t: TFunction;
  language: string;
}

/** The translator, typed for the namespace "runDetails", which must be loaded. */
export function spoken(t: unknown): TFunction<["words", "runDetails"]> {
  return t as TFunction<["words", "runDetails"]>;
}

/** The displayed tick of the run. */
type Displayed = Pick<RunState, "snapshot" | "hasEnded" | "progress">;

/**
 * Example: "Line 1: delayed right 90. Right is 250 cm." Without the reading where the line decided on
 * an earlier one.
 */
export function decisionText(
  { t, language }: Words,
  program: ProgramDocument,
  line: LineRef,
  state: Displayed,
  hasTruth: boolean,
): string {
  const { snapshot } = state;
  if (snapshot === null) return "";
  if (!hasTruth || !isDecidedHere(state)) return actionText(t, program, line);
  const { rules, default: otherwise } = program;
  const rule = line === "default" ? undefined : rules[line];
  const truth = shownTruth(rule?.when ?? null, snapshot);
  if (line === "default" || !rule?.when || truth === null) {
    return spoken(t)("runDetails:speech.otherwise", {
      action: t(`program.action.${otherwise}`),
      number: formatReading(snapshot.sensors.front, language),
    });
  }
  return spoken(t)("runDetails:speech.line", {
    line: line + 1,
    action: t(`program.action.${rule.do}`),
    sensor: t(`program.sensorFirst.${rule.when.sensor}`),
    number: localNumber(truth.left, language),
  });
}

/**
 * "Line 1: right 90."
 * @param rest of its manoeuvre: "Line 1: right 90, 43 degrees to go."
 */
function actionText(
  t: TFunction,
  { rules, default: otherwise }: ProgramDocument,
  line: LineRef,
  rest: string | null = null,
): string {
  const rule = line === "default" ? undefined : rules[line];
  const name = t(`program.action.${rule?.do ?? otherwise}`);
  const action = rest === null ? name : joinList(t, [name, rest]);
  return line === "default" || rule === undefined
    ? spoken(t)("runDetails:speech.otherwiseActs", { action })
    : spoken(t)("runDetails:speech.lineActs", { line: line + 1, action });
}

/** What is left of the displayed manoeuvre, such as "43 degrees to go"; null if none runs. */
function restText(t: TFunction, state: Displayed): string | null {
  const progress = shownProgress(decidingLine(state.snapshot), state);
  return progress && t(`program.progress.${progress.kind}`, { count: progress.left });
}

/** Three or four sentences: the position of the robot, its readings and the driver. */
export function describeText(
  { t, language }: Words,
  program: ProgramDocument,
  state: Displayed,
  hasTruth: boolean,
): string {
  const { snapshot } = state;
  if (snapshot === null) return "";
  const { rules, default: otherwise } = program;
  const { tick, pose, sensors, driver } = snapshot;
  const { column, row } = cellOf(pose);
  const reading = (centimetres: number): string => formatReading(centimetres, language);
  const sentences = [
    spoken(t)("runDetails:speech.describe.place", {
      time: timeText(t, tick, language),
      row: row + 1,
      column: column + 1,
      facing: t(`stage.facing.${facingOf(pose.heading)}`),
    }),
    spoken(t)("runDetails:speech.describe.readings", {
      front: reading(sensors.front),
      right: reading(sensors.right),
      back: reading(sensors.back),
      left: reading(sensors.left),
    }),
  ];
  const line = decidingLine(snapshot);
  const rule = typeof line === "number" ? rules[line] : undefined;
  const rest = restText(t, state);
  if (driver !== "program") sentences.push(t(`drive.status.${driver}`));
  else if (line === null && rest !== null) sentences.push(asSentence(t, rest));
  else if (line === null) sentences.push(spoken(t)("runDetails:speech.describe.noLine"));
  else if (!isDecidedHere(state)) sentences.push(actionText(t, program, line, rest));
  else if (line === "default" || rule === undefined) {
    const action = t(`program.action.${otherwise}`);
    sentences.push(spoken(t)("runDetails:speech.describe.otherwise", { action }));
  } else {
    const truth = hasTruth ? shownTruth(rule.when, snapshot) : null;
    const state = isDriving(line, snapshot) ? "running" : "resting";
    sentences.push(lineName(t, { index: line, rule, state, truth, advice: null }));
  }
  return joinSentences(t, sentences);
}
