/** The sentences of a diagnosis, shared by the card, the mission, messages and speech. */
import {
  causeLine,
  type BumpEvent,
  type Cause,
  type Diagnosis,
  type FailureEvent,
  type WrongNumber,
} from "@corridor/coach";
import type { Condition } from "@corridor/program";
import type { LineRef, SensorName, SensorReadings } from "@corridor/protocol";
import { ROBOT_RADIUS } from "@corridor/simulation";
import type { TFunction } from "i18next";
import { commandText } from "../../text/command-text.ts";
import { roundedReadings, roundedSides } from "../../text/compared.ts";
import { joinSentences } from "../../text/joined.ts";
import { formatSeconds, localNumber } from "../../text/numbers.ts";

/** The translator, and its language. */
export interface DiagnosisWords {
  t: TFunction<["diagnosis", "words"]>;
  language: string;
  /** ticks of waiting for a script up to a tick; displayed seconds exclude them, as on the clock */
  waited: (tick: number) => number;
}

/**
 * Adapts a translator with any first namespace: keys include their namespace.
 * @param t with the namespace "diagnosis" loaded
 */
export function diagnosisWords(
  t: unknown,
  language: string,
  waited: DiagnosisWords["waited"] = () => 0,
): DiagnosisWords {
  return { t: t as DiagnosisWords["t"], language, waited };
}

/** "Bump: look at line 1" */
export function diagnosisTitle({ t }: DiagnosisWords, diagnosis: Diagnosis): string {
  const line = causeLine(diagnosis);
  if (line === null) return t("diagnosis:title.bump");
  return line === "default"
    ? t("diagnosis:title.bumpOtherwise")
    : t("diagnosis:title.bumpLine", { line: line + 1 });
}

/**
 * Describes the event and its cause.
 * @param happened replaces the sentence about the event if a check provides a better one
 */
export function diagnosisText(
  words: DiagnosisWords,
  diagnosis: Diagnosis,
  happened: string = eventText(words, diagnosis),
): string {
  const { event, cause } = diagnosis;
  const corner = event.kind === "bump" && event.contact.isCorner ? [cornerText(words)] : [];
  const none = diagnosis.solvesFromStart ? [words.t("diagnosis:cause.noneFromStart")] : [];
  const reason =
    cause === null ? [...decidedText(words, event), ...none] : [causeText(words, event, cause)];
  return joinSentences(commonWords(words), [happened, ...corner, ...reason]);
}

/** Translates keys of the namespace "words", whatever the first namespace of the translator is. */
function commonWords({ t }: DiagnosisWords): TFunction {
  const say = t as unknown as (key: string, values?: object) => string;
  return ((key: string, values?: object) => say(`words:${key}`, values)) as unknown as TFunction;
}

function secondsAt({ language, waited }: DiagnosisWords, tick: number): string {
  return formatSeconds(tick - waited(tick), language);
}

function cornerText({ t }: DiagnosisWords): string {
  return t("diagnosis:event.corner");
}

/** The line that drove into the wall, as a fact: no cause is known. */
function decidedText(words: DiagnosisWords, event: FailureEvent): string[] {
  if (event.kind !== "bump" || event.line === null) return [];
  const known = { who: who(words, event.line), seconds: secondsAt(words, event.decidedAt) };
  // A motion without an end is decided again at each tick.
  return [
    words.t(
      event.needs === null ? "diagnosis:event.decidedLast" : "diagnosis:event.decided",
      known,
    ),
  ];
}

function eventText(words: DiagnosisWords, { event, cause }: Diagnosis): string {
  const { t } = words;
  const seconds = secondsAt(words, event.tick);
  if (event.kind === "late")
    return t("diagnosis:event.late", { seconds: Math.floor(event.tick / 60) });
  if (event.kind !== "bump") return t(`diagnosis:event.${event.kind}`, { times: event.times });
  // The cause, which follows, has its own numbers.
  if (cause !== null) return t("diagnosis:event.bump", { seconds });
  const known = {
    seconds,
    from: secondsAt(words, event.startedAt),
    ...roomText(words, event, cause),
    action: actionText(words, event.action),
  };
  const isFront = event.side === "front";
  const hadRoom = event.needs !== null && event.reading >= event.needs;
  // The beam measured enough room, so the robot touched something beside the beam.
  switch (hadRoom ? "steady" : event.phase) {
    case "delay":
      return t("diagnosis:event.delay", known);
    case "way-out":
      return t("diagnosis:event.wayOut", known);
    case "measured":
      return t(isFront ? "diagnosis:event.measuredFront" : "diagnosis:event.measuredBack", {
        ...known,
        action: measuredText(words, event),
      });
    case "steady":
      return t(isFront ? "diagnosis:event.steadyFront" : "diagnosis:event.steadyBack", known);
  }
}

function causeText(words: DiagnosisWords, event: FailureEvent, cause: Cause): string {
  const { t } = words;
  const { moment } = cause;
  const { tick, line, action } = moment;
  const seconds = secondsAt(words, tick);
  const known = { who: who(words, line), action: t(`words:program.action.${action}`), seconds };
  const shown = shownReadings(words, event, cause);
  const { front, left, right } = shown;
  const sensor = (name: SensorName) => ({
    sensor: t(`words:program.sensor.${name}`),
    reading: shown[name],
  });
  /** The readings that the condition of a line compares: one, or left and right. */
  const read = (when: Condition) =>
    when.than === "right"
      ? t("diagnosis:cause.readSides", { left, right })
      : t("diagnosis:cause.read", sensor(when.sensor));
  const side = (name: "left" | "right") => ({
    side: t(`words:program.sensor.${name}`),
    reading: shown[name],
  });
  const noRoom = (needs: number) => t("diagnosis:cause.noRoom", { ...known, front, needs });
  switch (cause.kind) {
    case "not-delayed":
      return cause.isAtEdge
        ? t("diagnosis:cause.atEdge", { ...known, ...side(cause.side), drivesOn: cause.drivesOn })
        : t("diagnosis:cause.notDelayed", { ...known, drivesOn: cause.drivesOn });
    case "delayed":
      return moment.readings.front < cause.needs
        ? noRoom(cause.needs)
        : t("diagnosis:cause.delayed", known);
    case "order":
      return t("diagnosis:cause.order", {
        read: read(cause.when),
        seconds,
        line: cause.line + 1,
        inner: inner(words, line),
      });
    case "too-early":
    case "too-long":
    case "too-late":
    case "too-short":
      return numberText(words, cause, seconds, shown);
    case "comparison": {
      const decided = line === cause.line;
      return t(decided ? "diagnosis:cause.comparisonTrue" : "diagnosis:cause.comparisonFalse", {
        read: read(cause.when),
        who: who(words, cause.line),
        seconds,
        sign: cause.when.is,
      });
    }
    case "sensor":
      return t("diagnosis:cause.sensor", {
        who: who(words, cause.line),
        seconds,
        sensor: t(`words:program.sensor.${cause.when.sensor}`),
        front,
        left,
        right,
      });
    case "action": {
      const { detail } = cause;
      if (detail?.kind === "no-room") return noRoom(detail.needs);
      if (detail?.kind === "into-wall") {
        return t("diagnosis:cause.intoWall", {
          ...known,
          ...side(detail.side),
          open: t(`words:program.sensor.${detail.open}`),
          free: shown[detail.open],
        });
      }
      if (detail?.kind === "undoing") {
        return t("diagnosis:cause.undoing", { who: known.who, inner: inner(words, detail.other) });
      }
      return t("diagnosis:cause.action", { ...known, front, left, right });
    }
    case "missing": {
      const about = { ...known, ...sensor(cause.sensor), inner: inner(words, line) };
      if (cause.sensor === "front") {
        return t(
          cause.isWall ? "diagnosis:cause.missingFront" : "diagnosis:cause.noForward",
          about,
        );
      }
      if (cause.sensor === "back") return t("diagnosis:cause.missingBack", about);
      if (cause.hasTurn) return t("diagnosis:cause.missingSide", about);
      return t(
        cause.sensor === "left" ? "diagnosis:cause.noTurnLeft" : "diagnosis:cause.noTurnRight",
        about,
      );
    }
    case "extra":
      return t("diagnosis:cause.extra", known);
  }
}

function numberText(
  words: DiagnosisWords,
  cause: WrongNumber,
  seconds: string,
  shown: Record<SensorName, string>,
): string {
  const { t } = words;
  const { when, moment, better, number } = cause;
  const reading = moment.readings[when.sensor];
  // `by` is the distance from the reading at the moment to another reading. There the condition
  // should change (too early, too short) or does change (too late, too long).
  const isFar = cause.kind === "too-early" || cause.kind === "too-short";
  const by = Math.round(Math.abs(reading - (isFar ? better : number)));
  const known = {
    who: who(words, cause.line),
    seconds,
    action: t(`words:program.action.${moment.action}`),
    sensor: t(`words:program.sensor.${when.sensor}`),
    reading: shown[when.sensor],
    by: Math.round(Math.abs(better - number)),
  };
  if (cause.extreme === "always") {
    return t("diagnosis:cause.always", { ...known, nearest: ROBOT_RADIUS });
  }
  if (when.than === "right") {
    const { left, right } = shown;
    return t("diagnosis:cause.sides", { ...known, left, right });
  }
  if (cause.extreme === "never") return t("diagnosis:cause.never", known);
  // Driving on brings the robot no nearer to what is beside it, so no place is `by` cm farther on.
  const isBeside = when.sensor === "left" || when.sensor === "right";
  if (cause.extreme === "missed" || (isBeside && moment.line !== cause.line)) {
    return t("diagnosis:cause.missed", known);
  }
  // If the better number equals the reading, there is no distance to report either.
  const isTrue = moment.line === cause.line;
  if (isBeside || by === 0)
    return t(isTrue ? "diagnosis:cause.off" : "diagnosis:cause.missed", known);
  return t(numberKeys[cause.kind], { ...known, by });
}

const numberKeys = {
  "too-early": "diagnosis:cause.tooEarly",
  "too-long": "diagnosis:cause.tooLong",
  "too-late": "diagnosis:cause.tooLate",
  "too-short": "diagnosis:cause.tooShort",
} as const;

/** The readings at the moment of the cause. */
function shownReadings(
  { language }: DiagnosisWords,
  event: FailureEvent,
  cause: Cause,
): Record<SensorName, string> {
  const shown = roundedReadings(cause.moment.readings, comparisonsAt(event, cause));
  const text = (name: SensorName) => localNumber(String(shown[name]), language);
  return { front: text("front"), right: text("right"), back: text("back"), left: text("left") };
}

/** All comparisons that the diagnosis makes with the readings at the moment of the cause. */
function comparisonsAt(event: FailureEvent, cause: Cause): (Condition | null)[] {
  const { moment } = cause;
  const needs = delayedNeeds(cause);
  return [
    moment.when,
    "when" in cause ? cause.when : null,
    needs === null ? null : { sensor: "front", is: "<", than: needs },
    event.kind === "bump" && event.startedAt === moment.tick ? roomCondition(event) : null,
  ];
}

/** The front reading that the cause says a delayed turn needs. */
function delayedNeeds(cause: Cause): number | null {
  if (cause.kind === "delayed") return cause.needs;
  if (cause.kind !== "action" || cause.detail?.kind !== "no-room") return null;
  return cause.detail.needs;
}

/** Whether the sentence about the cause names the room of a turn that began before the last motion. */
export function statesOtherRoom(event: BumpEvent, cause: Cause): boolean {
  return delayedNeeds(cause) !== null && cause.moment.tick !== event.startedAt;
}

/** "The reading is less than the motion needs", with the needed number as it is displayed. */
function roomCondition({ side, reading, needs }: BumpEvent): Condition | null {
  return needs === null ? null : { sensor: side, is: "<", than: shownNeeds(reading, needs) };
}

function shownNeeds(reading: number, needs: number): number {
  const isTrue = reading < needs;
  return roundedSides({ left: reading, is: "<", right: needs, isTrue }, 0).right;
}

/**
 * The room that a motion needed, and its reading. The reading is the same number as in the sentence
 * about the cause.
 */
export function roomText(
  { language }: DiagnosisWords,
  event: BumpEvent,
  cause: Cause | null,
): { reading: string; needs: string } {
  const { side, reading, needs, startedAt } = event;
  const isMoment = cause !== null && cause.moment.tick === startedAt;
  const shown: SensorReadings = isMoment
    ? roundedReadings(cause.moment.readings, comparisonsAt(event, cause))
    : roundedReadings({ ...noReadings, [side]: reading }, [roomCondition(event)]);
  const text = (number: number) => localNumber(String(number), language);
  return { reading: text(shown[side]), needs: text(shownNeeds(reading, needs ?? 0)) };
}

const noReadings: SensorReadings = { front: 0, right: 0, back: 0, left: 0 };

/** The name of an action in the menus, or in the API for actions that only scripts can request. */
function actionText({ t }: DiagnosisWords, action: BumpEvent["action"]): string {
  return action === "move" || action === "turn" || action === "drive"
    ? action
    : t(`words:program.action.${action}`);
}

/** The name of a move as in the list of commands: "move 120", or "move -120" backwards. */
function measuredText(words: DiagnosisWords, { action, needs, side }: BumpEvent): string {
  if (action !== "move" || needs === null) return actionText(words, action);
  const distance = Math.round(needs - ROBOT_RADIUS);
  return commandText({ action, distance: side === "front" ? distance : -distance });
}

/** "Line 1" or "“otherwise”" at the start of a sentence. */
function who({ t }: DiagnosisWords, line: LineRef): string {
  return line === "default"
    ? t("diagnosis:who.otherwise")
    : t("diagnosis:who.line", { line: line + 1 });
}

/** The same within a sentence. */
function inner({ t }: DiagnosisWords, line: LineRef): string {
  return line === "default"
    ? t("diagnosis:who.innerOtherwise")
    : t("diagnosis:who.innerLine", { line: line + 1 });
}
