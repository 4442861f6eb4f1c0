/**
 * A program as a script of guarded motions, in process: at every decision the same line and, bit
 * for bit, the same pose as the program, whatever the delays of the script are.
 */
import { createRandom, generateMaze, type MazeDocument, type Random } from "@corridor/maze";
import {
  CompiledProgram,
  conditionKinds,
  conditionOf,
  evaluateCondition,
  menuActions,
  programPresets,
  scriptLines,
  type Condition,
  type ConditionKind,
  type ProgramDocument,
  type Rule,
  type ScriptLine,
} from "@corridor/program";
import { paperPrograms } from "@corridor/program/testing";
import type { EndingState, LineRef, PlainAction, Pose, RemoteCommand } from "@corridor/protocol";
import { Run } from "@corridor/recording";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { deliveryOf } from "../worker/testing/bench.ts";
import { RemoteDriver } from "./remote-driver.ts";

/** Simulated time of a program, in ticks. */
const TICKS = 1_200;
/** Longest pause of the script before a command, in ticks. */
const MAX_PAUSE = 12;
const RANDOM_PROGRAMS = 100;

/** 20 mazes: trees, loops and rooms. */
const mazes: MazeDocument[] = Array.from({ length: 20 }, (_none, n) => {
  const kind = (["tree", "loops", "rooms"] as const)[n % 3] ?? "tree";
  const side = 5 + 2 * (n % 4);
  return generateMaze({ kind, columns: side, rows: side, seed: n, name: kind });
});

/** A program of up to 8 lines with numbers as in mazes. Most programs turn before a wall. */
function randomProgram(seed: number): ProgramDocument {
  const random = createRandom(seed);
  const oneOf = <T>(list: readonly T[]): T => list[random.below(list.length)] as T;
  const action = (): PlainAction => (random.below(2) === 0 ? "forward" : oneOf(menuActions));
  const rules: Rule[] = Array.from({ length: random.below(8) }, () => {
    const when = random.below(8) === 0 ? null : randomCondition(random, oneOf(conditionKinds));
    return { when, do: action() };
  });
  if (random.below(4) === 0) return programOf(action(), rules);
  const near: Condition = { sensor: "front", is: "<", than: 30 + random.below(40) };
  const turn = oneOf(["left 90", "right 90", "turn 180"] as const);
  return programOf("forward", [{ when: near, do: turn }, ...rules]);
}

function randomCondition(random: Random, kind: ConditionKind): Condition {
  const isPlus = kind.than === "right";
  const whole = isPlus ? random.below(201) - 100 : 20 + random.below(180);
  return conditionOf(kind, random.below(3) === 0 ? whole + random.below(1_000) / 1_000 : whole);
}

function programOf(otherwise: PlainAction, rules: Rule[] = []): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: otherwise, rules };
}

/** The distinct consecutive poses of a robot, and the line that decided at each of them. */
class Path {
  readonly poses: Pose[] = [];
  readonly lines: (LineRef | null)[] = [];

  add({ pose }: { pose: Pose }): void {
    if (isSamePose(pose, this.poses.at(-1))) return;
    this.poses.push(pose);
    this.lines.push(null);
  }

  decide(line: LineRef): void {
    this.lines[this.lines.length - 1] ??= line;
  }
}

/** Whether no bit differs. */
function isSamePose(one: Pose, other: Pose | undefined): boolean {
  if (other === undefined) return false;
  const { x, y, heading } = other;
  return Object.is(one.x, x) && Object.is(one.y, y) && Object.is(one.heading, heading);
}

interface ProgramPath {
  path: Path;
  /** index of the pose at which the robot reached a goal; null if it did not */
  goal: number | null;
}

/** What `simulate` does. */
function pathOfProgram(maze: MazeDocument, program: ProgramDocument): ProgramPath {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const path = new Path();
  let goal: number | null = null;
  for (path.add(simulation); simulation.tick < TICKS; path.add(simulation)) {
    if (goal === null && simulation.isInGoal) goal = path.poses.length - 1;
    if (run.decide() !== null) path.decide(run.line);
    run.step();
  }
  return { path, goal };
}

type ScriptEnd = "goal" | "wall" | "stop" | "time";

/** Drives as the exported script: it reads, decides, sends one command and waits for its end. */
function driveByScript(maze: MazeDocument, lines: readonly ScriptLine[], seed: number) {
  const run = new Run(maze, programOf("stop"));
  run.apply({ do: "driver", driver: "remote" });
  const random = createRandom(seed);
  const path = new Path();
  let ending = "completed" as EndingState | null;
  let seq = 0;
  const driver = new RemoteDriver(
    { started: () => undefined, ended: (_seq, { state }) => void (ending = state) },
    () => ({ run, addInput: (input) => run.apply(input) }),
    () => 0,
  );
  let pause = 0;
  let sentAt: Pose | undefined;
  let end: ScriptEnd = "time";
  path.add(run);
  while (run.tick < TICKS) {
    if (ending !== null && pause-- === 0) {
      if (run.report().goalReached) {
        end = "goal";
        break;
      }
      // A push that moves nothing is repeated without end. Contact with a corner may first move the
      // robot by a rounding error.
      if (ending === "collided" && isSamePose(run.pose, sentAt)) {
        end = "wall";
        break;
      }
      const { line, action, until } = lineFor(lines, run);
      path.decide(line);
      if (action === "stop") {
        end = "stop";
        break;
      }
      const command = until === null ? { action } : { action, until: [...until, { goal: true }] };
      driver.accept(deliveryOf(++seq, command as RemoteCommand));
      sentAt = run.pose;
      ending = null;
      pause = random.below(MAX_PAUSE);
    }
    driver.start();
    run.step();
    driver.finish();
    path.add(run);
  }
  return { path, end };
}

function lineFor(lines: readonly ScriptLine[], run: Run): ScriptLine {
  const { sensors } = run.report();
  const found = lines.find(
    ({ when }) => when === null || evaluateCondition(when, sensors)?.isTrue === true,
  );
  if (found === undefined) throw new Error("a script without a default");
  return found;
}

/** How a script ended, and how its path differs from that of its program. */
interface Comparison {
  end: ScriptEnd;
  difference: string | null;
}

function compareInAllMazes(program: ProgramDocument): Comparison[] {
  const script = scriptLines(program);
  if (!script.ok) throw new Error("expected a program with few lines");
  return mazes.map((maze, seed) => {
    const { path, end } = driveByScript(maze, script.lines, seed);
    return { end, difference: differenceOf(path, end, pathOfProgram(maze, program)) };
  });
}

function differenceOf(
  { poses, lines }: Path,
  end: ScriptEnd,
  { path: wanted, goal }: ProgramPath,
): string | null {
  const pose = poses.findIndex((each, at) => !isSamePose(each, wanted.poses[at]));
  if (pose >= 0) return `pose ${pose}`;
  // The script decides at some of the poses, by the same line.
  const line = lines.findIndex((each, at) => each !== null && each !== wanted.lines[at]);
  if (line >= 0) return `line at pose ${line}`;
  if (end === "goal" && goal === null) return "a goal that the program does not reach";
  // Where the script has ended, the program never moves the robot again.
  const isLast = poses.length === wanted.poses.length;
  return (end === "wall" || end === "stop") && !isLast ? "an end before the program's" : null;
}

function differencesOf(comparisons: readonly Comparison[]): string[] {
  return comparisons.flatMap(({ difference }, maze) =>
    difference === null ? [] : [`maze ${maze}: ${difference}`],
  );
}

describe("a program as a script of guarded motions", () => {
  it.each([
    ...paperPrograms.map(({ figure, program }) => ({ name: `figure ${figure}`, program })),
    ...programPresets.map(({ id, program }) => ({ name: id, program })),
  ])("drives the same path as the program: $name", ({ program }) => {
    expect(differencesOf(compareInAllMazes(program))).toEqual([]);
  });

  it("drives the same path as each of 100 random programs", { timeout: 120_000 }, () => {
    const ends = { goal: 0, wall: 0, stop: 0, time: 0 };
    const differences: string[] = [];
    for (let seed = 0; seed < RANDOM_PROGRAMS; seed++) {
      const comparisons = compareInAllMazes(randomProgram(seed));
      differences.push(...differencesOf(comparisons).map((each) => `program ${seed}, ${each}`));
      for (const { end } of comparisons) ends[end] += 1;
    }
    expect(differences).toEqual([]);
    // Every kind of end is among them.
    expect(Math.min(...Object.values(ends))).toBeGreaterThan(100);
  });
});
