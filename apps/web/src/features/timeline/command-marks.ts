/**
 * The commands of scripts on the ribbon, each with its number, from its start to its end. Commands
 * that are too close for their own numbers share a mark: "3–7".
 */
import type { CommandLog } from "@corridor/recording";
import { widthOf } from "./segment-name.ts";
import { xOf, type TimeScale } from "./time-scale.ts";

/** Maximum number of commands that are compared for the result of one mark. */
const MOST_WEIGHED = 256;

/** The part of a command log that is used here. */
export type Commands = Pick<CommandLog, "count" | "at" | "countUpTo">;

export interface CommandMark {
  /** the number, or the first and the last number: "3", "3–7" */
  label: string;
  /** tick at whose end the first command started */
  tick: number;
  /** px from the left end */
  x: number;
  /** width of its commands in px, at least 1 */
  width: number;
  /** width of its label in px, which can be pressed to display the start */
  pressWidth: number;
  /** for several commands, the worst result */
  result: CommandResult;
}

type CommandResult = "running" | "done" | "collided" | "ended";

/** The results, most important first. */
const RANK: readonly CommandResult[] = ["collided", "ended", "running", "done"];

/**
 * The marks from left to right, without overlap.
 * @param endTick last tick of the run, to which a running command extends
 */
export function commandMarksOf(log: Commands, scale: TimeScale, endTick: number): CommandMark[] {
  const marks: CommandMark[] = [];
  const right = scale.from + scale.span;
  let next = Math.max(0, log.countUpTo(scale.from) - 1);
  for (;;) {
    const first = log.at(next);
    if (first === undefined || first.from > right) return marks;
    let after = next + 1;
    let label = String(first.seq);
    const from = Math.max(scale.from, first.from);
    const x = xOf(scale, from);
    // A longer label needs more room, which can include more commands.
    for (;;) {
      const room = (widthOf(label) / scale.width) * scale.span;
      const reached = Math.max(after, log.countUpTo(Math.ceil(from + room) - 1));
      if (reached === after) break;
      after = reached;
      label = `${first.seq}–${log.at(after - 1)?.seq ?? ""}`;
    }
    const end = Math.min(right, log.at(after - 1)?.to ?? endTick);
    if (end < scale.from) {
      next = after;
      continue;
    }
    marks.push({
      label,
      tick: first.from,
      x,
      width: Math.max(1, xOf(scale, end) - x - 1),
      pressWidth: widthOf(label),
      result: worstOf(log, next, Math.min(after, next + MOST_WEIGHED)),
    });
    next = after;
  }
}

/** The mark whose label is under a position, in px from the left end; null if there is none. */
export function commandUnder(marks: readonly CommandMark[], x: number): CommandMark | null {
  return marks.find((mark) => x >= mark.x && x < mark.x + mark.pressWidth) ?? null;
}

function worstOf(log: Commands, from: number, to: number): CommandResult {
  let worst = RANK.length - 1;
  for (let index = from; index < to; index++) {
    worst = Math.min(worst, RANK.indexOf(resultOf(log.at(index)?.ending ?? null)));
  }
  return RANK[worst] ?? "done";
}

function resultOf(ending: NonNullable<ReturnType<Commands["at"]>>["ending"]): CommandResult {
  if (ending === null) return "running";
  if (ending === "completed") return "done";
  return ending === "collided" ? "collided" : "ended";
}
