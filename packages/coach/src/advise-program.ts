/**
 * Advice on a program in a maze, before it runs. Each advice is a fact about all possible readings
 * in the maze, or about the room that a turn needs, and never a guess from a run.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import type { Advice, Fix, NeverDecides, NeverTrueHere, Side } from "./advice.ts";
import { applyFix } from "./apply-fix.ts";
import { visibilityIn, type MazeVisibility } from "./visibility.ts";
import { ReachingReadings } from "./reaching-readings.ts";
import { drives, OPENING, turnFinding, type TurnFinding } from "./turn-findings.ts";
import { winningLines } from "./winning-lines.ts";

/** An advice without its fix and winning lines. */
type Finding = TurnFinding | Omit<NeverTrueHere, "fix"> | Omit<NeverDecides, "above" | "fix">;

/** The paper's numbers, for fixes, in units. */
const OPEN_SIDE = 60;
const WALL_AHEAD = 50;
const SMALL_DIFFERENCE = 1;

const kinds = [
  "never-decides",
  "never-true-here",
  "delayed-about-front",
  "immediate-into-opening",
] as const satisfies Finding["kind"][];

const delayedTurn = { left: "delayed left 90", right: "delayed right 90" } as const;
const turnOnTheSpot: Record<Side, PlainAction> = { left: "left 90", right: "right 90" };

/**
 * All advice on a program, from the top line down, at most one per line, the default action last.
 * An empty list does not prove that the program is right.
 */
export function adviseProgram(program: ProgramDocument, maze: MazeDocument): Advice[] {
  const visibility = visibilityIn(maze);
  const findings = findingsOf(program, visibility);
  return findings.map((finding) => withFix(finding, program, visibility, findings));
}

function findingsOf(program: ProgramDocument, visibility: MazeVisibility): Finding[] {
  const reaching = new ReachingReadings(visibility.range);
  const anywhere = new ReachingReadings(visibility.range);
  const isDriving = drives(program);
  const findings: Finding[] = [];
  for (const [line, rule] of program.rules.entries()) {
    if (rule.when === null) continue;
    if (!anywhere.allows(rule.when)) {
      findings.push({ kind: "never-true-here", line, ...limitOf(rule.when, visibility) });
    } else if (reaching.allows(rule.when)) {
      const finding = turnFinding(rule, line, reaching, visibility, isDriving);
      if (finding !== null) findings.push(finding);
    } else {
      findings.push({ kind: "never-decides", line });
    }
    reaching.pass(rule.when);
  }
  if (reaching.isEmpty) findings.push({ kind: "never-decides", line: "default" });
  return findings;
}

function limitOf(
  when: Condition,
  { range }: MazeVisibility,
): Pick<NeverTrueHere, "limit" | "bound"> {
  if (when.than === "right") return { limit: "difference", bound: range.max - range.min };
  return when.is === ">"
    ? { limit: "farthest", bound: range.max }
    : { limit: "nearest", bound: range.min };
}

/** Adds the winning lines, and the first fix that causes no new advice. */
function withFix(
  finding: Finding,
  program: ProgramDocument,
  visibility: MazeVisibility,
  findings: readonly Finding[],
): Advice {
  const firstGood = (fixes: readonly Fix[]): Fix | null =>
    fixes.find((fix) => isGood(fix, finding, program, visibility, findings)) ?? null;
  switch (finding.kind) {
    case "never-decides": {
      const line = finding.line === "default" ? program.rules.length : finding.line;
      const above = winningLines(program.rules, line, visibility.range) ?? [];
      if (finding.line === "default") return { ...finding, above, fix: null };
      return { ...finding, above, fix: firstGood(moveUp(program, finding.line, above)) };
    }
    case "never-true-here":
      return { ...finding, fix: firstGood(possibleNumber(program, finding.line)) };
    case "delayed-about-front": {
      const { line, side, why } = finding;
      const fixes: Fix[] =
        why === "near"
          ? [{ kind: "action", line, action: turnAtWall(program, line, side, visibility) }]
          : [
              { kind: "condition", line, when: openSide(side) },
              { kind: "action", line, action: "forward" },
            ];
      return { ...finding, fix: firstGood(fixes) };
    }
    case "immediate-into-opening": {
      const action = delayedTurn[finding.side];
      return { ...finding, fix: firstGood([{ kind: "action", line: finding.line, action }]) };
    }
  }
}

/**
 * The turn on the spot for a line that decides at a wall: to its own side; to the other one if
 * lines above decide for all openings on its own side; back if they decide for both.
 */
function turnAtWall(
  { rules }: ProgramDocument,
  line: number,
  side: Side,
  visibility: MazeVisibility,
): PlainAction {
  const reaching = new ReachingReadings(visibility.range);
  for (const { when } of rules.slice(0, line)) if (when !== null) reaching.pass(when);
  const sides: readonly Side[] = side === "left" ? ["left", "right"] : ["right", "left"];
  const open = sides.find((each) => reaching.max(each) >= OPENING);
  return open === undefined ? "turn 180" : turnOnTheSpot[open];
}

/**
 * Moves the line above the winning ones, unless they have the same action; otherwise deletes it.
 */
function moveUp({ rules }: ProgramDocument, line: number, above: readonly number[]): Fix[] {
  const action = rules[line]?.do;
  const to = above[0];
  const isSame = above.every((winner) => rules[winner]?.do === action);
  const deletion: Fix = { kind: "delete", line };
  return isSame || to === undefined ? [deletion] : [{ kind: "move", line, to }, deletion];
}

/** Sets the paper's number for such a condition; otherwise deletes the line. */
function possibleNumber({ rules }: ProgramDocument, line: number): Fix[] {
  const when = rules[line]?.when ?? null;
  const deletion: Fix = { kind: "delete", line };
  if (when === null) return [deletion];
  const isSide = when.sensor === "left" || when.sensor === "right";
  const usual = isSide ? OPEN_SIDE : WALL_AHEAD;
  return [
    { kind: "number", line, number: when.than === "right" ? SMALL_DIFFERENCE : usual },
    deletion,
  ];
}

function openSide(side: Side): Condition {
  return { sensor: side, is: ">", than: OPEN_SIDE };
}

/** Whether a fix resolves its advice and causes no other one. */
function isGood(
  fix: Fix,
  finding: Finding,
  program: ProgramDocument,
  visibility: MazeVisibility,
  before: readonly Finding[],
): boolean {
  // Deleting a line that never decides changes nothing.
  if (fix.kind === "delete") return true;
  const after = findingsOf(applyFix(program, fix), visibility);
  if (after.length >= before.length) return false;
  const count = (list: readonly Finding[], kind: Finding["kind"]) =>
    list.reduce((sum, each) => sum + (each.kind === kind ? 1 : 0), 0);
  return kinds.every((kind) => {
    const max = count(before, kind) - (kind === finding.kind ? 1 : 0);
    return count(after, kind) <= max;
  });
}
