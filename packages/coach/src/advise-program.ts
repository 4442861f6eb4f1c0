/**
 * Advice on a program in a maze, before it runs. Every advice is a fact about all readings that this
 * maze can give, or about the room that a turn takes; none is a guess from a run.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import type { Advice, Mend, NeverDecides, NeverTrueHere, Side } from "./advice.ts";
import { applyMend } from "./apply-fix.ts";
import { sightIn, type MazeSight } from "./visibility.ts";
import { ReachingReadings } from "./reaching-readings.ts";
import { drives, OPENING, turnFinding, type TurnFinding } from "./turn-findings.ts";
import { winningLines } from "./winning-lines.ts";

/** What is wrong with a line, before it is known which lines win and what would mend it. */
type Finding = TurnFinding | Omit<NeverTrueHere, "mend"> | Omit<NeverDecides, "above" | "mend">;

/** Numbers of the paper that a mend falls back on, in units. */
const OPEN_SIDE = 60;
const WALL_AHEAD = 50;
const LITTLE_MORE = 1;

const kinds = [
  "never-decides",
  "never-true-here",
  "delayed-about-front",
  "immediate-into-opening",
] as const satisfies Finding["kind"][];

const delayedTurn = { left: "delayed left 90", right: "delayed right 90" } as const;
const turnOnTheSpot: Record<Side, PlainAction> = { left: "left 90", right: "right 90" };

/**
 * All advice on a program, from the top line down, "otherwise" last; at most one for each. An empty
 * list says that nothing was found, not that the program is right.
 */
export function adviseProgram(program: ProgramDocument, maze: MazeDocument): Advice[] {
  const sight = sightIn(maze);
  const findings = findingsOf(program, sight);
  return findings.map((finding) => mended(finding, program, sight, findings));
}

function findingsOf(program: ProgramDocument, sight: MazeSight): Finding[] {
  const reaching = new ReachingReadings(sight.range);
  const anywhere = new ReachingReadings(sight.range);
  const isDriving = drives(program);
  const findings: Finding[] = [];
  for (const [line, rule] of program.rules.entries()) {
    if (rule.when === null) continue;
    if (!anywhere.allows(rule.when)) {
      findings.push({ kind: "never-true-here", line, ...limitOf(rule.when, sight) });
    } else if (reaching.allows(rule.when)) {
      const finding = turnFinding(rule, line, reaching, sight, isDriving);
      if (finding !== null) findings.push(finding);
    } else {
      findings.push({ kind: "never-decides", line });
    }
    reaching.pass(rule.when);
  }
  if (reaching.isEmpty) findings.push({ kind: "never-decides", line: "default" });
  return findings;
}

function limitOf(when: Condition, { range }: MazeSight): Pick<NeverTrueHere, "limit" | "bound"> {
  if (when.than === "right") return { limit: "difference", bound: range.max - range.min };
  return when.is === ">"
    ? { limit: "farthest", bound: range.max }
    : { limit: "nearest", bound: range.min };
}

/** Adds which lines win, and the first mend that brings no new advice. */
function mended(
  finding: Finding,
  program: ProgramDocument,
  sight: MazeSight,
  findings: readonly Finding[],
): Advice {
  const firstGood = (mends: readonly Mend[]): Mend | null =>
    mends.find((mend) => isGood(mend, finding, program, sight, findings)) ?? null;
  switch (finding.kind) {
    case "never-decides": {
      const line = finding.line === "default" ? program.rules.length : finding.line;
      const above = winningLines(program.rules, line, sight.range) ?? [];
      if (finding.line === "default") return { ...finding, above, mend: null };
      return { ...finding, above, mend: firstGood(wayUp(program, finding.line, above)) };
    }
    case "never-true-here":
      return { ...finding, mend: firstGood(possibleNumber(program, finding.line)) };
    case "delayed-about-front": {
      const { line, side, why } = finding;
      const mends: Mend[] =
        why === "near"
          ? [{ kind: "action", line, action: turnAtWall(program, line, side, sight) }]
          : [
              { kind: "condition", line, when: openSide(side) },
              { kind: "action", line, action: "forward" },
            ];
      return { ...finding, mend: firstGood(mends) };
    }
    case "immediate-into-opening": {
      const action = delayedTurn[finding.side];
      return { ...finding, mend: firstGood([{ kind: "action", line: finding.line, action }]) };
    }
  }
}

/**
 * The turn on the spot for a line that decides at a wall: to its own side, to the other one where lines
 * above have taken all that are open on its own, back where they have taken both.
 */
function turnAtWall(
  { rules }: ProgramDocument,
  line: number,
  side: Side,
  sight: MazeSight,
): PlainAction {
  const reaching = new ReachingReadings(sight.range);
  for (const { when } of rules.slice(0, line)) if (when !== null) reaching.pass(when);
  const sides: readonly Side[] = side === "left" ? ["left", "right"] : ["right", "left"];
  const open = sides.find((each) => reaching.max(each) >= OPENING);
  return open === undefined ? "turn 180" : turnOnTheSpot[open];
}

/** Above the lines that win, unless they do the same; else away, which changes nothing that the robot does. */
function wayUp({ rules }: ProgramDocument, line: number, above: readonly number[]): Mend[] {
  const action = rules[line]?.do;
  const to = above[0];
  const isSame = above.every((winner) => rules[winner]?.do === action);
  const away: Mend = { kind: "delete", line };
  return isSame || to === undefined ? [away] : [{ kind: "move", line, to }, away];
}

/** The paper's number for such a condition; away where that one does not help. */
function possibleNumber({ rules }: ProgramDocument, line: number): Mend[] {
  const when = rules[line]?.when ?? null;
  const away: Mend = { kind: "delete", line };
  if (when === null) return [away];
  const isSide = when.sensor === "left" || when.sensor === "right";
  const usual = isSide ? OPEN_SIDE : WALL_AHEAD;
  return [{ kind: "number", line, number: when.than === "right" ? LITTLE_MORE : usual }, away];
}

function openSide(side: Side): Condition {
  return { sensor: side, is: ">", than: OPEN_SIDE };
}

/** Whether a mend answers its advice and calls for no other one. */
function isGood(
  mend: Mend,
  finding: Finding,
  program: ProgramDocument,
  sight: MazeSight,
  before: readonly Finding[],
): boolean {
  // A line that never decides can go without a trace.
  if (mend.kind === "delete") return true;
  const after = findingsOf(applyMend(program, mend), sight);
  if (after.length >= before.length) return false;
  const count = (list: readonly Finding[], kind: Finding["kind"]) =>
    list.reduce((sum, each) => sum + (each.kind === kind ? 1 : 0), 0);
  return kinds.every((kind) => {
    const most = count(before, kind) - (kind === finding.kind ? 1 : 0);
    return count(after, kind) <= most;
  });
}
