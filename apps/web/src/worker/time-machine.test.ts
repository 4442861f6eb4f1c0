import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command, DriverName, Snapshot } from "@corridor/protocol";
import { openRun, readRun } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "./first-work.ts";
import { RunLoop } from "./run-loop.ts";
import { loadRun } from "./testing/load-run.ts";
import type { DriveKey, Frame, Speed } from "./worker-messages.ts";

/** A loop whose real time passes when the test says so. */
class Bench {
  time = 0;
  story: string[] = [];
  readonly loop: RunLoop;
  #seq = 0;

  constructor(maze: MazeDocument = firstMaze, program: ProgramDocument = firstProgram) {
    const started = (seq: number) => void this.story.push(`started ${seq}`);
    const ended = (seq: number, { state }: { state: string }) =>
      void this.story.push(`${state} ${seq}`);
    this.loop = new RunLoop(maze, program, () => this.time, { started, ended });
  }

  /** @returns the last frame */
  pass(milliseconds: number, each = 8): Frame | null {
    let frame: Frame | null = null;
    for (const end = this.time + milliseconds; this.time < end;) {
      this.time += each;
      this.loop.advance();
      frame = this.loop.takeNews()?.frame ?? frame;
    }
    return frame;
  }

  frame(): Frame {
    this.loop.pause();
    const news = this.loop.takeNews();
    if (news === null) throw new Error("no news after a pause");
    return news.frame;
  }

  deliver(command: Command): void {
    this.loop.accept({ seq: ++this.#seq, command, key: null, acceptedAt: "2026-01-01T00:00:00Z" });
  }
}

/** What a snapshot shows of its moment. */
type Moment = Omit<Snapshot, "seq" | "state">;

function momentOf(snapshot: Snapshot): Moment {
  const { seq: _seq, state: _state, ...moment } = snapshot;
  return moment;
}

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

/** What a reader, or a script, does with the page, by a name that a failing test tells. */
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

/** A deed, and the real time that passes after it in the intervals of a timer. */
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

/** Lives a story; with what the newest moment of each tick was when it was left. */
function live(bench: Bench, story: readonly Chapter[]) {
  const moments = new Map<number, Moment>();
  const note = () => {
    const snapshot = bench.loop.snapshot();
    moments.set(snapshot.tick, momentOf(snapshot));
  };
  note();
  for (const { deed, milliseconds, each } of story) {
    const before = bench.loop.snapshot().tick;
    deed.act(bench);
    // A maze without room for the robot begins a new run.
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

describe("whatever is done with a run", () => {
  it("its file replays to the digest and the moment that it ended with", () => {
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

  it("any moment of it is shown bit for bit as it was live", () => {
    fc.assert(
      fc.property(anyStory, fc.array(fc.nat(), { minLength: 1, maxLength: 6 }), (story, asked) => {
        const bench = new Bench();
        const { moments } = live(bench, story);
        const wasEdited = story.some(({ deed: { name } }) => name.startsWith("program"));
        const ticks = [...moments.keys()];
        for (const number of asked) {
          const tick = ticks[number % ticks.length] ?? 0;
          bench.loop.seek(tick);
          const shown = momentOf(bench.frame().snapshot);
          // The line of the past is the one that the newest program would choose there.
          const line = wasEdited ? shown.line : moments.get(tick)?.line;
          // A script's command begins with the next tick: seen again, it is there at the end of this one.
          const begun =
            shown.driver === "remote" ? { command: shown.command, motion: shown.motion } : {};
          expect(shown).toEqual({ ...moments.get(tick), line, ...begun });
        }
      }),
      { numRuns: 120 },
    );
  });

  it("run on from any moment of it, it is a run that its file alone makes again", () => {
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

/** A run of the right-wall program, paused after ten seconds. */
function tenSeconds(): Bench {
  const bench = new Bench();
  bench.loop.run();
  bench.pass(10_000);
  bench.loop.pause();
  return bench;
}

describe("the shown past", () => {
  it("waits for nobody: the live run is paused and scripts still see the newest moment", () => {
    const bench = tenSeconds();
    const live = bench.loop.snapshot();
    bench.loop.seek(120);
    expect(bench.frame()).toMatchObject({
      view: "past",
      nowTick: live.tick,
      snapshot: { tick: 120, state: "paused" },
    });
    bench.pass(1000);
    expect(momentOf(bench.loop.snapshot())).toEqual(momentOf(live));
  });

  it("ends at now when the last moment is asked for", () => {
    const bench = tenSeconds();
    bench.loop.seek(60);
    bench.loop.seek(99_999_999);
    expect(bench.frame()).toMatchObject({ view: "now" });
  });

  it("sends the trail up to the shown moment: what was gained forward, all of it back", () => {
    const bench = tenSeconds();
    const all = bench.frame();
    bench.loop.seek(100);
    const early = bench.frame();
    expect(early.trailReset).toBe(true);
    bench.loop.seek(500);
    const later = bench.frame();
    expect(later.trailReset).toBe(false);
    bench.loop.now();
    const rest = bench.frame();
    expect(rest.trailReset).toBe(false);
    const whole = new Bench();
    whole.loop.run();
    const corners = [...(whole.loop.takeNews()?.frame.corners ?? [])];
    for (let i = 0; i < 10_000 / 8; i++) {
      whole.time += 8;
      whole.loop.advance();
      corners.push(...(whole.loop.takeNews()?.frame.corners ?? []));
    }
    expect([...early.corners, ...later.corners, ...rest.corners]).toEqual(corners);
    expect(all.snapshot.tick).toBe(whole.loop.snapshot().tick);
  });

  it("is played on at the chosen speed up to now, and changes nothing", () => {
    const bench = tenSeconds();
    const saved = bench.loop.saveRun();
    bench.loop.seek(60);
    bench.loop.play();
    const playing = bench.pass(2000);
    expect(playing).toMatchObject({ view: "playing", snapshot: { state: "running" } });
    expect(Math.abs((playing?.snapshot.tick ?? 0) - 180)).toBeLessThanOrEqual(1);
    bench.loop.setSpeed("max");
    bench.pass(2000);
    expect(bench.frame()).toMatchObject({ view: "now", snapshot: { state: "paused" } });
    expect(bench.loop.saveRun()).toEqual(saved);
  });

  it("can be paused while it is played", () => {
    const bench = tenSeconds();
    bench.loop.seek(60);
    bench.loop.play();
    bench.pass(500);
    bench.loop.pause();
    const { tick } = bench.frame().snapshot;
    bench.pass(500);
    expect(bench.frame()).toMatchObject({ view: "past", snapshot: { tick } });
  });

  it("is stepped through decision by decision, and after the last one it is now", () => {
    const bench = tenSeconds();
    const lines: Snapshot["line"][] = [];
    bench.loop.seekStep(-1);
    const first = bench.frame();
    expect(first.view).toBe("past");
    bench.loop.seekStep(-1);
    expect(bench.frame().snapshot.tick).toBeLessThan(first.snapshot.tick);
    bench.loop.seek(0);
    for (let frame = bench.frame(); frame.view === "past"; frame = bench.frame()) {
      lines.push(frame.snapshot.line);
      bench.loop.seekStep(1);
    }
    expect(lines.length).toBeGreaterThan(4);
    expect(lines.slice(0, -1).every((line, index) => line !== lines[index + 1])).toBe(true);
  });

  it("shows what the newest program would do there; going on, the robot does it", () => {
    const bench = tenSeconds();
    bench.loop.seek(30);
    expect(bench.frame().snapshot.line).toBe("default");
    const backward: ProgramDocument = {
      ...firstProgram,
      rules: [{ when: { sensor: "front", is: ">", than: 0 }, do: "reverse" }],
    };
    bench.loop.editProgram(backward);
    expect(bench.frame()).toMatchObject({ view: "past", snapshot: { line: 0, tick: 30 } });
    bench.loop.run();
    const frame = bench.pass(100);
    expect(frame).toMatchObject({ view: "now", snapshot: { motion: "reverse", line: 0 } });
    expect(frame?.nowTick).toBeLessThan(40);
  });

  it("keeps the recording when the program was edited and now is shown again", () => {
    const bench = tenSeconds();
    const { tick } = bench.loop.snapshot();
    bench.loop.seek(30);
    const still: ProgramDocument = { ...firstProgram, rules: [], default: "stop" };
    bench.loop.editProgram(still);
    bench.loop.now();
    expect(bench.frame()).toMatchObject({ nowTick: tick, snapshot: { tick } });
    expect(bench.loop.saveRun()).toMatchObject({
      run: { program: firstProgram, inputs: [{ tick, do: "program", program: still }] },
    });
    bench.loop.seek(30);
    expect(bench.frame().snapshot.motion).toBe("forward");
  });

  it("shows the maze as it was then, and only while it differs", () => {
    const bench = tenSeconds();
    const then = firstMaze;
    bench.loop.editMaze({ ...firstMaze, goals: [] });
    expect(bench.loop.shownMaze).toBeNull();
    bench.loop.seek(30);
    expect(bench.loop.shownMaze).toEqual(then);
    bench.loop.editMaze({ ...firstMaze, name: "another" });
    expect(bench.frame().view).toBe("now");
    expect(bench.loop.shownMaze).toBeNull();
  });

  it("is gone on from by hand with a drive key", () => {
    const bench = tenSeconds();
    bench.loop.seek(30);
    bench.loop.hold("reverse");
    const frame = bench.pass(200);
    expect(frame).toMatchObject({ view: "now", snapshot: { driver: "me", motion: "reverse" } });
    expect(frame?.nowTick).toBeLessThan(50);
  });

  it("is left for now when a script sends a command, whose robot goes on", () => {
    const bench = new Bench();
    bench.loop.setDriver("remote");
    bench.deliver({ action: "move", distance: 100 });
    bench.pass(3000);
    bench.loop.seek(20);
    bench.deliver({ action: "left 90" });
    expect(bench.pass(2000)).toMatchObject({ view: "now", snapshot: { state: "running" } });
    expect(bench.story).toEqual(["started 1", "completed 1", "started 2", "completed 2"]);
  });

  it("gone on from ends what a script had asked for, each command once", () => {
    const bench = new Bench();
    bench.loop.setDriver("remote");
    bench.deliver({ action: "move", distance: 300 });
    bench.pass(1000);
    bench.loop.seek(20);
    bench.loop.run();
    expect(bench.pass(500)).toMatchObject({
      view: "now",
      snapshot: { driver: "remote", command: null, motion: "stop" },
    });
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
  });
});

describe("a bump", () => {
  it("is told with the decision that led to it and the room that it had", () => {
    const bench = new Bench(firstMaze, { ...firstProgram, rules: [] });
    bench.loop.run();
    let cause = null;
    while (cause === null && bench.time < 20_000) {
      bench.time += 8;
      bench.loop.advance();
      cause = bench.loop.takeNews()?.moments[0]?.cause ?? null;
    }
    expect(cause).toMatchObject({
      decidedAt: 0,
      action: "forward",
      part: 0,
      parts: 1,
      side: "front",
      needed: null,
    });
    // It drives until its edge, 25 from the middle, is at the wall.
    expect(cause?.driven).toBeCloseTo((cause?.reading ?? 0) - 25, 6);
    expect(cause?.readings.front).toBe(cause?.reading);
  });

  it("on the way out of a delayed turn names the part and what it needed", () => {
    const box: MazeDocument = {
      ...firstMaze,
      blocks: ["..", ".#"],
      start: { column: 0, row: 0, heading: "east" },
      goals: [],
    };
    const bench = new Bench(box, { ...firstProgram, rules: [], default: "delayed left 90" });
    bench.loop.run();
    let cause = null;
    while (cause === null && bench.time < 20_000) {
      bench.time += 8;
      bench.loop.advance();
      cause = bench.loop.takeNews()?.moments[0]?.cause ?? null;
    }
    expect(cause).toMatchObject({ action: "delayed left 90", part: 2, parts: 3, needed: 60 });
    expect(cause?.driven).toBeCloseTo((cause?.reading ?? 0) - 25, 6);
  });
});

describe("an edit that is taken back while the past is shown", () => {
  it.each([
    { name: "back to now", goOn: ({ loop }: Bench) => loop.now() },
    { name: "on from there", goOn: ({ loop }: Bench) => loop.run() },
  ])("changes nothing of the run that goes $name", ({ goOn }) => {
    const bench = tenSeconds();
    bench.loop.pause();
    bench.loop.seek(300);
    const shown = bench.frame().snapshot.line;
    bench.loop.editProgram({ ...firstProgram, default: "reverse", rules: [] });
    bench.loop.editProgram(structuredClone(firstProgram));
    expect(bench.frame().snapshot.line).toBe(shown);
    goOn(bench);
    const saved = bench.loop.saveRun();
    expect(saved).toMatchObject({ ok: true, run: { program: firstProgram, inputs: [] } });
  });
});

describe("a file", () => {
  it("opened later goes on as the run itself would have", () => {
    const bench = tenSeconds();
    const saved = bench.loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const other = new Bench();
    const tick = bench.loop.snapshot().tick + 77;
    expect(loadRun(other.loop, saved.run, tick)).toMatchObject({ ok: true });
    expect(other.frame()).toMatchObject({ view: "now", trailReset: true, snapshot: { tick } });
    for (const { loop } of [bench, other]) loop.run();
    bench.pass(1000 + (77 * 1000) / 60, 1000 / 60);
    other.pass(1000, 1000 / 60);
    for (const { loop } of [bench, other]) loop.pause();
    const ticks = [bench, other].map(({ loop }) => loop.snapshot().tick);
    const least = Math.min(...ticks);
    const moments = [bench, other].map((each) => {
      each.loop.seek(least);
      return momentOf(each.frame().snapshot);
    });
    expect(moments[0]).toEqual(moments[1]);
  });

  it("whose digest is not what the run ends in is refused, and nothing has changed", () => {
    const bench = tenSeconds();
    const saved = bench.loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const { tick } = bench.loop.snapshot();
    const loaded = loadRun(bench.loop, { ...saved.run, digest: "0123456789abcdef" });
    expect(loaded).toMatchObject({
      ok: false,
      problems: [{ path: "digest", found: "0123456789abcdef" }],
    });
    expect(bench.loop.snapshot().tick).toBe(tick);
  });
});
