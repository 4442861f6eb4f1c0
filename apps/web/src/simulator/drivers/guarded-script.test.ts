/** A script of guarded motions against the program that decides the same: no bit differs. */
import { createRandom, generateMaze, mazePresets, type MazeDocument } from "@corridor/maze";
import {
  CompiledProgram,
  programPresets,
  scriptLines,
  type ProgramDocument,
  type Rule,
} from "@corridor/program";
import type { PlainAction, RemoteCommand } from "@corridor/protocol";
import { openRun, readRun, Recording } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { deliveryOf } from "../worker/testing/bench.ts";
import { RemoteDriver } from "./remote-driver.ts";

const TICKS = 6_000;
const MAX_PAUSE = 12;

const mazes: MazeDocument[] = [
  ...(["tree", "loops", "rooms"] as const).flatMap((kind) =>
    [1, 2].map((seed) => generateMaze({ kind, columns: 9, rows: 9, seed, name: kind })),
  ),
  ...mazePresets.slice(0, 2).map(({ maze }) => maze),
];

/** Programs with bumps, pushing against walls, and reverse, besides those of the menu. */
const programs: ProgramDocument[] = [
  ...programPresets.map(({ program }) => program),
  programOf("reverse", [
    { when: { sensor: "back", is: "<", than: 45 }, do: "right 90" },
    { when: { sensor: "left", is: ">", than: "right", plus: 100 }, do: "forward" },
  ]),
  programOf("forward", [
    { when: { sensor: "right", is: ">", than: 60 }, do: "right 90" },
    { when: { sensor: "front", is: "<", than: 26 }, do: "left 90" },
  ]),
];

function programOf(otherwise: PlainAction, rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: otherwise, rules };
}

/** The command of a rule; a motion ends as soon as the program may decide otherwise. */
function commandOf(program: ProgramDocument, rule: number): RemoteCommand {
  const script = scriptLines(program);
  const line =
    script.ok && script.lines.find((each) => each.line === (rule < 0 ? "default" : rule));
  if (!line) throw new Error(`no line ${rule}`);
  const { action, until } = line;
  return until === null ? { action } : { action, until: [...until] };
}

/** The poses of a robot, without those where it stood still. */
class Path {
  readonly poses: string[] = [];

  add({ run }: Recording): void {
    // JSON writes numbers so that they are read as the same bits.
    const pose = JSON.stringify(run.pose);
    if (pose !== this.poses.at(-1)) this.poses.push(pose);
  }
}

function pathOfProgram(maze: MazeDocument, program: ProgramDocument): Path {
  const recording = new Recording(maze, program);
  const path = new Path();
  for (path.add(recording); recording.run.tick < TICKS; path.add(recording)) recording.step();
  return path;
}

/** Drives as a script would: reads, decides, sends one command, and waits for its end. */
function driveByScript(maze: MazeDocument, program: ProgramDocument, seed: number) {
  const recording = new Recording(maze, program);
  recording.addInput({ do: "driver", driver: "remote" });
  const random = createRandom(seed);
  const states: string[] = [];
  let isOver = true;
  const ended = (_seq: number, { state }: { state: string }) => {
    isOver = true;
    states.push(state);
  };
  const driver = new RemoteDriver(
    { started: () => undefined, ended },
    () => recording,
    () => 0,
  );
  const compiled = new CompiledProgram(program);
  const path = new Path();
  let pause = 0;
  path.add(recording);
  while (recording.run.tick < TICKS) {
    if (isOver && pause-- === 0) {
      isOver = false;
      pause = random.below(MAX_PAUSE);
      const rule = compiled.decide(recording.run.readings);
      driver.accept(deliveryOf(states.length + 1, commandOf(program, rule)));
    }
    driver.start();
    recording.step();
    driver.finish();
    path.add(recording);
  }
  return { path, recording, states };
}

describe.each(
  programs.map((program, index) => ({ name: program.name || `program ${index}`, program })),
)("a script that decides as $name", ({ program }) => {
  it.each(mazes.map((maze, seed) => ({ maze, seed })))(
    "drives through the same poses in maze $seed, whatever its delays are",
    ({ maze, seed }) => {
      const wanted = pathOfProgram(maze, program).poses;
      const { path, recording } = driveByScript(maze, program, seed);
      const length = Math.min(path.poses.length, wanted.length);
      expect(length).toBeGreaterThan(wanted.length / 4);
      expect(path.poses.slice(0, length)).toEqual(wanted.slice(0, length));
      const written = recording.toDocument("");
      if (!written.ok) throw new Error(written.reason);
      expect(written.text).not.toContain("until");
      const read = readRun(written.text);
      if (!read.ok) throw new Error("unreadable run");
      expect(openRun(read.value)).toMatchObject({ ok: true });
    },
  );
});
