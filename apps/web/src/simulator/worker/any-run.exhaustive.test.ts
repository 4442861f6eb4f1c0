import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command, DriverName } from "@corridor/protocol";
import { openRun, readRun } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { Bench, momentOf, type TickState } from "./testing/bench.ts";
import { loadRun } from "./testing/load-run.ts";
import type { DriveKey, Speed } from "../protocol/worker-messages.ts";

const speeds: Speed[] = [0.25, 1, 4, 16];
const drivers: DriverName[] = ["me", "program", "remote"];
const keys: DriveKey[] = ["forward", "reverse", "left", "right", "stop", "stop"];
const commands: Command[] = [
  { action: "forward" },
  { action: "move", distance: 120 },
  { action: "right 90" },
  { action: "drive", left: 0.4, right: 0.2 },
  { action: "stop" },
];
const programs: ProgramDocument[] = [
  firstProgram,
  { ...firstProgram, default: "reverse", rules: firstProgram.rules.slice(1) },
  { ...firstProgram, default: "turn 180", rules: [] },
];
const mazes: MazeDocument[] = [
  firstMaze,
  { ...firstMaze, goals: [] },
  { ...firstMaze, blocks: firstMaze.blocks.map((row) => row.replaceAll("#", ".")), goals: [] },
];

/** An action of a user or a script, with a name for failing tests. */
interface Deed {
  name: string;
  act(bench: Bench): void;
}

function deed<T>(
  name: string,
  values: fc.Arbitrary<T>,
  act: (bench: Bench, value: T) => void,
): fc.Arbitrary<Deed> {
  return values.map((value) => ({
    name: `${name} ${String(value)}`,
    act: (bench: Bench) => act(bench, value),
  }));
}

const anyDeed: fc.Arbitrary<Deed> = fc.oneof(
  { weight: 3, arbitrary: deed("run", fc.constant(""), ({ loop }) => loop.run()) },
  deed("pause", fc.constant(""), ({ loop }) => loop.pause()),
  deed("step", fc.constant(""), ({ loop }) => loop.step()),
  deed("hold", fc.constantFrom(...keys), ({ loop }, key) => loop.hold(key)),
  deed("driver", fc.constantFrom(...drivers), ({ loop }, driver) => loop.setDriver(driver)),
  deed("program", fc.nat({ max: 2 }), ({ loop }, which) =>
    loop.editProgram(programs[which] ?? firstProgram),
  ),
  deed("maze", fc.nat({ max: 2 }), ({ loop }, which) => loop.editMaze(mazes[which] ?? firstMaze)),
  deed("speed", fc.constantFrom(...speeds), ({ loop }, speed) => loop.setSpeed(speed)),
  deed("command", fc.nat({ max: 4 }), (bench, which) =>
    bench.deliver(commands[which] ?? { action: "stop" }),
  ),
  deed("cancel", fc.constant(""), ({ loop }) => loop.cancelRemote("stopped")),
);

/** An action, and the real time that passes after it in timer intervals. */
interface Chapter {
  deed: Deed;
  milliseconds: number;
  each: number;
}

const anyStory: fc.Arbitrary<Chapter[]> = fc.array(
  fc.record({
    deed: anyDeed,
    milliseconds: fc.integer({ min: 0, max: 1500 }),
    each: fc.constantFrom(8, 16, 100),
  }),
  { minLength: 1, maxLength: 14 },
);

/** Performs a story, and returns the last state of each tick. */
function live(bench: Bench, story: readonly Chapter[]) {
  const moments = new Map<number, TickState>();
  const note = () => {
    const snapshot = bench.loop.snapshot();
    moments.set(snapshot.tick, momentOf(snapshot));
  };
  note();
  for (const { deed, milliseconds, each } of story) {
    const before = bench.loop.snapshot().tick;
    deed.act(bench);
    // A maze without room for the robot starts a new run.
    if (bench.loop.snapshot().tick < before) moments.clear();
    note();
    for (let passed = 0; passed < milliseconds; passed += each) {
      bench.pass(each, each);
      note();
    }
  }
  const run = bench.loop.saveRun();
  if (!run.ok) throw new Error(run.reason);
  return { moments, run: run.run };
}

describe("any operations on a run", () => {
  it("its file replays to the digest and the tick at which it ended", () => {
    fc.assert(
      fc.property(anyStory, (story) => {
        const bench = new Bench();
        const { run } = live(bench, story);
        const read = readRun(JSON.stringify(run));
        if (!read.ok) throw new Error(JSON.stringify(read.problems));
        const opened = openRun(read.value);
        if (!opened.ok) throw new Error(JSON.stringify(opened.problems));
        const other = new Bench();
        expect(loadRun(other.loop, read.value)).toMatchObject({ ok: true });
        const end = momentOf(bench.loop.snapshot());
        const { line, driver, command } = opened.value.run;
        expect({ ...opened.value.run.report(), line, driver, command }).toEqual(end);
        expect(other.loop.snapshot()).toMatchObject({ tick: end.tick, pose: end.pose });
      }),
      { numRuns: 120 },
    );
  });

  it("displays any tick bit for bit as it was live", () => {
    fc.assert(
      fc.property(anyStory, fc.array(fc.nat(), { minLength: 1, maxLength: 6 }), (story, asked) => {
        const bench = new Bench();
        const { moments } = live(bench, story);
        const wasEdited = story.some(({ deed: { name } }) => name.startsWith("program"));
        const ticks = [...moments.keys()];
        for (const number of asked) {
          const tick = ticks[number % ticks.length] ?? 0;
          bench.loop.seek(tick);
          const { snapshot, hasEnded } = bench.frame();
          const shown = momentOf(snapshot);
          // The line of the past is the one that the newest program would choose there. At the end
          // of a run, it is the one that drove last.
          const line = wasEdited || hasEnded ? shown.line : moments.get(tick)?.line;
          // A script's command begins with the next tick: seen again, it is there at the end of
          // this one.
          const begun =
            shown.driver === "remote" ? { command: shown.command, motion: shown.motion } : {};
          expect(shown).toEqual({ ...moments.get(tick), line, ...begun });
        }
      }),
      { numRuns: 120 },
    );
  });

  it("continued from any tick, it can be replayed from its file alone", () => {
    fc.assert(
      fc.property(anyStory, fc.nat(), anyStory, (story, number, later) => {
        const bench = new Bench();
        const { moments } = live(bench, story);
        const ticks = [...moments.keys()];
        bench.loop.seek(ticks[number % ticks.length] ?? 0);
        bench.loop.run();
        const { run } = live(bench, later);
        expect(openRun(run)).toMatchObject({ ok: true });
      }),
      { numRuns: 120 },
    );
  });
});
