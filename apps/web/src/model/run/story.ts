/** The one-line story of the run: the sentence for the newest goal or bump, and its numbers. */
import { CELL } from "@corridor/maze";
import type { DriverName } from "@corridor/protocol";
import type { TFunction } from "i18next";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { timeText } from "./time-text.ts";

/** The driver or line in charge, which the sentence names. */
export type Teller = "line" | "otherwise" | DriverName;

export interface Story {
  kind: RunEvent["kind"];
  teller: Teller;
  /** 1 for the first line; 0 when no numbered line was in charge */
  line: number;
  /** ticks in which it drove, which the clock counts */
  after: number;
  /** tick of the run; that of a script counts its waiting too, so no sentence says both */
  tick: number;
  /** square of the maze, counted from 1 as in the labels of the grid */
  column: number;
  row: number;
}

/**
 * The story of a run event.
 * @param waited ticks up to it in which the robot waited for a script, which the clock counts
 * separately
 */
export function storyOf({ kind, line, driver, tick, pose }: RunEvent, waited = 0): Story {
  const isNumbered = typeof line === "number" && kind === "goal";
  const after = tick - waited;
  return {
    kind,
    teller:
      kind === "bump" ? driver : isNumbered ? "line" : line === "default" ? "otherwise" : driver,
    line: isNumbered ? line + 1 : 0,
    after,
    tick,
    column: Math.floor(pose.x / CELL) + 1,
    row: Math.floor(pose.y / CELL) + 1,
  };
}

/**
 * The sentence of a story. The diagnosis names the line that caused a bump.
 * @param t with the namespace "runDetails" loaded
 */
export function storyText(t: unknown, story: Story, language: string): string {
  const { kind, teller } = story;
  const words = t as TFunction<["words", "runDetails"]>;
  return words(`runDetails:story.${kind}.${teller}` as StoryKey, {
    ...story,
    time: timeText(words, story.after, language),
  });
}

type StoryKey = `runDetails:story.goal.${Teller}` | `runDetails:story.bump.${DriverName}`;
