/**
 * Finds the line to blame for an attempt that failed in a maze. What can be tried is tried: an order is
 * only called wrong where the other one passes, a turn only too early where the delayed one gets by.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { DELAY_DISTANCE, ProgramRun, ROBOT_RADIUS, Simulation } from "@corridor/simulation";
import type { Side } from "./advice.ts";
import { applyMend } from "./apply-mend.ts";
import { actionOf, traceAttempt, type AttemptTrace, type DecisionMoment } from "./attempt-trace.ts";
import type { AlwaysTrue, Blame, NoRoom, NoTurn, Overruled, Undoing, WallTurn } from "./blame.ts";
import { delayed } from "./bump-mends.ts";
import { OPENING } from "./turn-findings.ts";

export interface FailedAttempt {
  program: ProgramDocument;
  maze: MazeDocument;
  /** how long it was allowed to take */
  ticks: number;
  /** whether a bump ended it */
  endsAtBump: boolean;
  /** whether another program would pass here */
  passes: (program: ProgramDocument) => boolean;
}

/** From the robot's middle to the wall: what a delayed turn needs ahead. */
const ROOM = DELAY_DISTANCE + ROBOT_RADIUS;
/** A robot that turned too early may turn again at once, as its side is still open. */
const MOST_TURNS = 3;
/** A delayed turn takes about a second longer; with it the robot has to get on for another one. */
const PROVING_TICKS = 120;
/** So many times forward and back are no coincidence. */
const MANY_REVERSALS = 10;

/** @returns null where no line can be named */
export function findBlame(attempt: FailedAttempt): Blame | null {
  const { program, maze, ticks, endsAtBump } = attempt;
  const trace = traceAttempt(program, maze, ticks, endsAtBump);
  const isBump = endsAtBump && trace.hasBumped;
  return (
    (isBump ? (noRoom(trace) ?? earlyTurn(attempt, trace)) : null) ??
    alwaysTrue(program, trace) ??
    overruled(attempt, trace) ??
    (isBump ? null : undoing(program, trace)) ??
    wallTurn(program, trace) ??
    noTurn(program, trace) ??
    (isBump || trace.notice === null ? null : { kind: "nowhere", notice: trace.notice })
  );
}

function noRoom({ last }: AttemptTrace): NoRoom | null {
  if (last === null || !last.action.startsWith("delayed")) return null;
  const { line, action, readings } = last;
  return readings.front < ROOM
    ? { kind: "no-room", line, action, front: readings.front, needs: ROOM }
    : null;
}

/** A turn shortly before the bump that gets past the place when it is delayed. */
function earlyTurn({ program, maze }: FailedAttempt, { turns, ticks }: AttemptTrace): Blame | null {
  for (const { line, action, tick, readings } of turns.slice(-MOST_TURNS).toReversed()) {
    const instead = delayed[action];
    if (line === "default" || instead === undefined) continue;
    if (readings[sideOf(action)] < OPENING) continue;
    const mended = applyMend(program, { kind: "action", line, action: instead });
    if (!drivesWell(mended, maze, ticks + PROVING_TICKS)) continue;
    return { kind: "early-turn", line, action, tick, drivesOn: DELAY_DISTANCE };
  }
  return null;
}

/** Whether a program drives so many ticks without a bump, or up to a goal. */
function drivesWell(program: ProgramDocument, maze: MazeDocument, ticks: number): boolean {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  while (simulation.tick < ticks && simulation.goalTick === null) {
    run.step();
    if (simulation.bumps > 0) return false;
  }
  return true;
}

/** A line that decided, and that no reading can make false. */
function alwaysTrue({ rules }: ProgramDocument, { last }: AttemptTrace): AlwaysTrue | null {
  const line = last?.line;
  if (typeof line !== "number") return null;
  const when = rules[line]?.when ?? null;
  if (when === null || when.than === "right" || when.is !== ">") return null;
  return when.than < ROBOT_RADIUS - 1
    ? {
        kind: "always-true",
        line,
        sensor: when.sensor,
        number: when.than,
        nearest: ROBOT_RADIUS,
      }
    : null;
}

function overruled({ program, passes }: FailedAttempt, { unread }: AttemptTrace): Overruled | null {
  for (const { line, above, tick, readings } of unread) {
    const when = program.rules[line]?.when;
    if (when === null || when === undefined) continue;
    if (!passes(applyMend(program, { kind: "move", line, to: above }))) continue;
    const { sensor } = when;
    return { kind: "overruled", line, above, tick, sensor, reading: readings[sensor] };
  }
  return null;
}

function undoing({ rules }: ProgramDocument, { reversals, last }: AttemptTrace): Undoing | null {
  if (reversals < MANY_REVERSALS || last === null) return null;
  const line = rules.findIndex((rule) => rule.when !== null && rule.do === "reverse");
  if (line < 0) return null;
  const forward = rules.findIndex((rule) => rule.when !== null && rule.do === "forward");
  const other = forward < 0 ? "default" : forward;
  return { kind: "undoing", line, other, front: last.readings.front };
}

/** The first turn towards a wall, or to the nearer side where no line knows the other one. */
function wallTurn(program: ProgramDocument, { turns }: AttemptTrace): WallTurn | null {
  for (const moment of turns) {
    const { line, action, tick, readings } = moment;
    const side = sideOf(action);
    const open = openWay(moment, side);
    if (open === null) continue;
    const isMissing = open !== "front" && !turnsTo(program, open);
    const isNearer = readings[side] < readings[open];
    if (!isNearer || (readings[side] >= ROOM && !isMissing)) continue;
    return {
      kind: "wall-turn",
      line,
      action,
      tick,
      side,
      reading: readings[side],
      open,
      free: readings[open],
      isMissing,
    };
  }
  return null;
}

/** The way that a turn left aside; straight on counts where the wall is not yet near. */
function openWay({ readings }: DecisionMoment, side: Side): WallTurn["open"] | null {
  const other = side === "left" ? "right" : "left";
  if (readings[other] >= OPENING) return other;
  return readings.front >= OPENING ? "front" : null;
}

/** At the wall that it met, or else at an opening that it passed. */
function noTurn(program: ProgramDocument, trace: AttemptTrace): NoTurn | null {
  const { left, right } = trace.readings;
  const byRoom: readonly Side[] = left > right ? ["left", "right"] : ["right", "left"];
  const missing = byRoom.filter((side) => !turnsTo(program, side));
  for (const side of missing) {
    if (trace.readings[side] < OPENING) continue;
    return { kind: "no-turn", side, tick: trace.ticks, reading: trace.readings[side] };
  }
  for (const side of missing) {
    const opening = trace.openings[side];
    if (opening === undefined) continue;
    return { kind: "no-turn", side, tick: opening.tick, reading: opening.readings[side] };
  }
  return null;
}

/** Whether any line turns to this side. */
function turnsTo(program: ProgramDocument, side: Side): boolean {
  const lines = ["default" as const, ...program.rules.keys()];
  return lines.some((line) => {
    if (line !== "default" && program.rules[line]?.when === null) return false;
    const action = actionOf(program, line);
    return action.endsWith("90") && sideOf(action) === side;
  });
}

function sideOf(action: string): Side {
  return action.includes("left") ? "left" : "right";
}
