/** The one-line story of the run: which sentence tells the newest goal or bump, and its numbers. */
import type { DriverName } from "@corridor/protocol";
import type { TFunction } from "i18next";
import type { RunEvent } from "../../worker/worker-messages.ts";
import { formatSeconds } from "../../text/numbers.ts";

/** Side of a square of the maze, in cm. */
const SQUARE = 100;

/** Who or what was in charge; the sentence names it. */
export type Teller = "line" | "otherwise" | DriverName;

export interface Story {
  kind: RunEvent["kind"];
  teller: Teller;
  /** 1 for the first line; 0 when no numbered line was in charge */
  line: number;
  seconds: string;
  /** those seconds in ticks */
  after: number;
  tick: number;
  /** square of the maze, counted from 1 as the maze's grid says it */
  column: number;
  row: number;
}

/**
 * What there is to tell about a moment.
 * @param waited ticks up to it in which a script let the robot wait, which the clock counts apart
 */
export function storyOf({ kind, line, driver, tick, pose }: RunEvent, waited = 0): Story {
  const isNumbered = typeof line === "number" && kind === "goal";
  const after = tick - waited;
  return {
    kind,
    teller:
      kind === "bump" ? driver : isNumbered ? "line" : line === "default" ? "otherwise" : driver,
    line: isNumbered ? line + 1 : 0,
    seconds: formatSeconds(after),
    after,
    tick,
    column: Math.floor(pose.x / SQUARE) + 1,
    row: Math.floor(pose.y / SQUARE) + 1,
  };
}

/**
 * The sentence of a story. Which line caused a bump is for the diagnosis to say.
 * @param t with the namespace "runDetails" loaded
 */
export function storyText(t: unknown, story: Story): string {
  const { kind, teller } = story;
  const words = t as TFunction<["words", "runDetails"]>;
  return words(`runDetails:story.${kind}.${teller}` as StoryKey, { ...story });
}

type StoryKey = `runDetails:story.goal.${Teller}` | `runDetails:story.bump.${DriverName}`;
