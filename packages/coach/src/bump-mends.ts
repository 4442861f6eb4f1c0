/**
 * How a program could have kept the robot from a bump. Candidates come in the order in which a teacher
 * would try them; each is driven through the very place before it is offered, so that what is offered
 * works.
 */
import { CompiledProgram, MAX_RULES, type ProgramDocument, type Rule } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import { ProgramRun, type Simulation } from "@corridor/simulation";
import type { Mend } from "./advice.ts";
import { applyMend } from "./apply-mend.ts";
import type { BumpStory } from "./bump-story.ts";

export interface BumpScene {
  program: ProgramDocument;
  /** the line that drove into the wall */
  line: LineRef;
  story: BumpStory;
  /** what the sensors measured at the wall */
  readings: SensorReadings;
  /** the robot at the end of the tick of the decision: a new one at each call */
  atDecision: () => Simulation;
  /** ticks from that decision to the bump */
  ticks: number;
  /** whether it had been at the goal before: then to get there proves nothing of the way after it */
  hasReachedGoal: boolean;
}

/** A mended program has to get by so long after the place of the bump, in ticks. */
const PROVING_TICKS = 300;
/** And to get on meanwhile: a robot that stands or dances is no better off. In units. */
const PROVING_DISTANCE = 150;
/** Numbers that leave room to stop at a wall. */
const ROOMY = [50, 60, 75];
/** Numbers that tell an opening from a niche. */
const OPENINGS = [100, 125, 150, 200];

const immediate: Partial<Record<PlainAction, PlainAction>> = {
  "delayed left 90": "left 90",
  "delayed right 90": "right 90",
};

/** The first mends that work, at most `most` of them. */
export function mendsForBump(scene: BumpScene, most: number): Mend[] {
  const mends: Mend[] = [];
  for (const mend of candidates(scene)) {
    if (mends.length >= most) break;
    if (works(scene, applyMend(scene.program, mend))) mends.push(mend);
  }
  return mends.length > 0 ? mends : turnBack(scene);
}

/** At a dead end nothing else helps; anywhere else it would lead the robot back, away from its goal. */
function turnBack(scene: BumpScene): Mend[] {
  const { program, line, story } = scene;
  if (typeof line !== "number" || story.kind !== "delay") return [];
  const mend: Mend = { kind: "action", line, action: "turn 180" };
  return works(scene, applyMend(program, mend)) ? [mend] : [];
}

/** The same turn in the middle of an opening. */
export const delayed: Partial<Record<PlainAction, PlainAction>> = {
  "left 90": "delayed left 90",
  "right 90": "delayed right 90",
};

/**
 * The bump of a robot that turned too early: a turn on the spot at the edge of an opening, and then
 * straight into its corner. The line that drove into it is not the one to blame.
 * @param turn the decision before the one that led into the wall
 * @returns the turn as a delayed one, where that gets past the place; null where it is not at fault
 */
export function mendOfEarlierTurn(
  turn: Pick<BumpScene, "program" | "line" | "atDecision" | "ticks" | "hasReachedGoal">,
): Mend | null {
  const { program, line } = turn;
  if (typeof line !== "number") return null;
  const action = delayed[program.rules[line]?.do ?? "stop"];
  if (action === undefined) return null;
  const mend: Mend = { kind: "action", line, action };
  return works(turn, applyMend(program, mend)) ? mend : null;
}

function candidates(scene: BumpScene): Mend[] {
  const { program, line, story } = scene;
  const rule = typeof line === "number" ? program.rules[line] : undefined;
  const isDelayed = story.kind === "delay" || story.kind === "way-out";
  if (!isDelayed) return wallMends(scene, rule);
  if (rule === undefined || typeof line !== "number") return [];
  const instead = immediate[rule.do];
  const turnAtOnce: Mend[] =
    instead === undefined ? [] : [{ kind: "action", line, action: instead }];
  const askForMore = numbersAbove(rule, OPENINGS).map((number): Mend => ({
    kind: "number",
    line,
    number,
  }));
  return story.kind === "delay" ? [...turnAtOnce, ...askForMore] : [...askForMore, ...turnAtOnce];
}

/** For a motion that nothing ended in time: let a line about the wall win, earlier or at all. */
function wallMends({ program, line, story, readings }: BumpScene, rule: Rule | undefined): Mend[] {
  const at = typeof line === "number" ? line : program.rules.length;
  const own: Mend[] = [];
  if (rule?.when?.sensor === story.side && rule.when.is === ">" && typeof line === "number") {
    own.push(
      ...numbersAbove(rule, ROOMY).map((number): Mend => ({ kind: "number", line, number })),
    );
  }
  const raised: Mend[] = [];
  const moved: Mend[] = [];
  for (const [index, { when }] of program.rules.entries()) {
    if (when === null || when.sensor !== story.side || when.is !== "<") continue;
    if (index > at) moved.push({ kind: "move", line: index, to: at });
    for (const number of ROOMY) {
      if (number > when.than) {
        raised.push({ kind: "number", line: index, number });
      }
    }
  }
  return [...moved, ...raised, ...own, ...newLines(program, at, story, readings)];
}

/** A new line that turns at the wall, to the roomier side first. */
function newLines(
  program: ProgramDocument,
  at: number,
  { side }: BumpStory,
  { left, right }: SensorReadings,
): Mend[] {
  if (program.rules.length >= MAX_RULES) return [];
  const turns: PlainAction[] =
    left > right ? ["left 90", "right 90", "turn 180"] : ["right 90", "left 90", "turn 180"];
  const when = { sensor: side, is: "<", than: 50 } as const;
  return turns.map((turn): Mend => ({ kind: "insert", at, rule: { when, do: turn } }));
}

function numbersAbove({ when }: Rule, numbers: readonly number[]): number[] {
  if (when === null || when.is !== ">") return [];
  const own = when.than === "right" ? when.plus : when.than;
  return numbers.filter((number) => number > own);
}

/** Whether the program gets past the place and on from there without a bump. */
function works(
  { atDecision, ticks, hasReachedGoal }: Pick<BumpScene, "atDecision" | "ticks" | "hasReachedGoal">,
  program: ProgramDocument,
): boolean {
  const simulation = atDecision();
  const { bumps } = simulation;
  // What runs was chosen by the program that bumped.
  simulation.apply({ action: "stop" });
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  let distance = 0;
  for (let tick = 0; tick < ticks + PROVING_TICKS; tick++) {
    if (tick === ticks) distance = simulation.distance;
    run.step();
    if (simulation.bumps > bumps) return false;
    if (simulation.goalTick !== null && !hasReachedGoal) return true;
  }
  return simulation.distance - distance >= PROVING_DISTANCE;
}
