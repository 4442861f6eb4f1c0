import type { ProgramDocument } from "@corridor/program";
import { findSnapshotMessage, type Command, type Snapshot } from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import { beforeEach, describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import type { Ending } from "../drivers/remote-driver.ts";
import { RemoteDriver } from "../drivers/remote-driver.ts";
import * as diagnostics from "./diagnose-run.ts";
import { RunLoop } from "./run-loop.ts";
import { deliveryOf } from "./testing/bench.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

let time = 0;
let endings: Record<number, Ending> = {};

const events = {
  started: () => undefined,
  ended: (seq: number, ending: Ending) => {
    endings[seq] = ending;
  },
};

beforeEach(() => {
  time = 0;
  endings = {};
});

function loopOf(maze: MazeDocument = firstMaze, program: ProgramDocument = firstProgram): RunLoop {
  const loop = new RunLoop(maze, program, () => time);
  loop.connect((robot) => new RemoteDriver(events, robot, () => time));
  loop.updates.useDiagnostics(diagnostics);
  return loop;
}

/** Lets real time pass in timer intervals, and collects the events. */
function pass(loop: RunLoop, milliseconds: number): RunEvent[] {
  const events: RunEvent[] = [];
  for (const end = time + milliseconds; time < end;) {
    time += 8;
    loop.advance();
    const update = loop.updates.take();
    events.push(...(update?.events ?? []));
  }
  return events;
}

function deliver(loop: RunLoop, seq: number, command: Command): void {
  loop.accept(deliveryOf(seq, command));
}

it("reports the robot in a form that a relay forwards without parsing it further", () => {
  const loop = loopOf();
  loop.run();
  for (let turn = 0; turn < 20; turn++) {
    pass(loop, 300);
    const message = { type: "snapshot", epoch: 1, snapshot: loop.snapshot() };
    expect(findSnapshotMessage(JSON.stringify(message))).not.toBeNull();
  }
});

describe("a program", () => {
  it("waits until Run and shows at once which line will decide", () => {
    const loop = loopOf();
    pass(loop, 1000);
    expect(loop.snapshot()).toMatchObject({ tick: 0, state: "paused", line: "default" });
  });

  it("drives to the goal, pauses there once, and reports where, when and by which line", () => {
    const loop = loopOf();
    loop.run();
    const events = pass(loop, 60_000);
    expect(events).toMatchObject([{ kind: "goal", tick: 2380, line: "default", bumps: 0 }]);
    expect(loop.snapshot()).toMatchObject({ tick: 2380, state: "paused", goalReached: true });
    loop.run();
    expect(pass(loop, 2000)).toEqual([]);
    expect(loop.snapshot().tick).toBeGreaterThan(2400);
  });

  it("reports a bump with the line that was in charge", () => {
    const loop = loopOf(firstMaze, { ...firstProgram, rules: [] });
    loop.run();
    expect(pass(loop, 5000)).toMatchObject([{ kind: "bump", line: "default", bumps: 1 }]);
  });

  it("shows true numbers for a line at the tick at which it is lit", () => {
    const loop = loopOf();
    loop.run();
    let line: Snapshot["line"] = null;
    let lit = 0;
    while (loop.isRunning) {
      time += 8;
      loop.advance();
      const snapshot = loop.updates.take()?.frame.snapshot;
      if (snapshot === undefined || snapshot.line === line) continue;
      line = snapshot.line;
      lit++;
      const { front, right } = snapshot.sensors;
      expect(line).toBe(right > 60 ? 0 : front < 50 ? 1 : "default");
    }
    expect(lit).toBeGreaterThan(20);
  });

  it("can be edited while it runs: the next decision uses the new lines", () => {
    const loop = loopOf();
    loop.run();
    pass(loop, 500);
    loop.editProgram({ ...firstProgram, rules: [], default: "reverse" });
    expect(loop.snapshot().motion).toBe("reverse");
    const before = loop.snapshot().pose.x;
    pass(loop, 200);
    expect(loop.snapshot().pose.x).toBeLessThan(before);
  });
});

describe("time", () => {
  it.each([0.25, 0.5, 1, 2, 4, 8, 16] as const)("flows %f times as fast", (speed) => {
    const loop = loopOf(firstMaze, { ...firstProgram, rules: [], default: "stop" });
    loop.setSpeed(speed);
    loop.run();
    pass(loop, 2000);
    expect(Math.abs(loop.snapshot().tick - 120 * speed)).toBeLessThanOrEqual(1);
  });

  it.each([0.25, 4, 16, "max"] as const)(
    "passes in real time at speed %s while the robot waits for its script",
    (speed) => {
      const loop = loopOf();
      loop.setDriver("remote");
      loop.setSpeed(speed);
      pass(loop, 2000);
      expect(Math.abs(loop.snapshot().tick - 120)).toBeLessThanOrEqual(1);
      deliver(loop, 1, { action: "left 90" });
      pass(loop, 8000);
      const turned = endings[1]?.state === "completed" ? loop.snapshot().tick : 0;
      pass(loop, 2000);
      expect(Math.abs(loop.snapshot().tick - turned - 120)).toBeLessThanOrEqual(1);
    },
  );

  it("flows at the chosen speed while a command of a script runs", () => {
    const loop = loopOf();
    loop.setDriver("remote");
    loop.setSpeed(16);
    deliver(loop, 1, { action: "drive", left: 0, right: 0, milliseconds: 5000 });
    pass(loop, 160);
    expect(Math.abs(loop.snapshot().tick - 16 * 0.16 * 60)).toBeLessThanOrEqual(2);
  });

  it("does not change what happens: every speed ends in the same snapshot", () => {
    const ends = ([0.5, 1, 16] as const).map((speed) => {
      const loop = loopOf();
      loop.setSpeed(speed);
      loop.run();
      pass(loop, 90_000);
      return { ...loop.snapshot(), seq: 0 };
    });
    expect(ends[0]?.goalReached).toBe(true);
    expect(ends[1]).toEqual(ends[0]);
    expect(ends[2]).toEqual(ends[0]);
  });

  it("gives the same snapshots in chunks of 1, 7 and 60 ticks, for 100,000 ticks", () => {
    const maze = { ...firstMaze, goals: [] };
    const scraping: ProgramDocument = {
      ...firstProgram,
      rules: [
        { when: { sensor: "front", is: "<", than: 30 }, do: "right 90" },
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
      ],
    };
    const together = 1 * 7 * 60;
    const runs = [1, 7, 60].map((chunk) => {
      const loop = loopOf(maze, scraping);
      loop.setSpeed(16);
      // The first bump of each line pauses the run for an explanation; these ticks include them.
      while (loop.snapshot().tick < 2_100) {
        loop.run();
        time += 1000 / 60 / 16 + 1e-9;
        loop.advance();
      }
      const snapshots: Snapshot[] = [];
      for (let ticks = chunk; ticks <= 100_000; ticks += chunk) {
        // Slightly more than the chunk takes, so that rounding never omits a tick.
        time += (chunk * 1000) / 60 / 16 + 1e-9;
        loop.advance();
        const snapshot = loop.snapshot();
        if (ticks % together === 0) snapshots.push({ ...snapshot, seq: 0 });
      }
      return snapshots;
    });
    expect(runs[0]).toHaveLength(Math.floor(100_000 / together));
    expect(runs[0]?.at(-1)).toMatchObject({ tick: 2_100 + 99_960 });
    expect(runs[0]?.at(-1)?.bumps).toBeGreaterThan(0);
    expect(runs[1]).toEqual(runs[0]);
    expect(runs[2]).toEqual(runs[0]);
  });

  it("does not pass while paused, and is not caught up after a sleep", () => {
    const loop = loopOf();
    loop.run();
    pass(loop, 100);
    loop.pause();
    const { tick } = loop.snapshot();
    pass(loop, 1000);
    expect(loop.snapshot().tick).toBe(tick);
    loop.run();
    time += 3_600_000;
    loop.advance();
    expect(loop.snapshot().tick - tick).toBeLessThanOrEqual(15);
  });
});

describe("Reset", () => {
  it("resets the robot, starts a new trail and retains the driver", () => {
    const loop = loopOf();
    loop.run();
    pass(loop, 3000);
    loop.reset();
    const frame = loop.updates.take()?.frame;
    expect(frame).toMatchObject({
      trailReset: true,
      corners: [50, 650],
      snapshot: { tick: 0, bumps: 0, state: "paused", driver: "program" },
    });
  });
});

describe("a hand", () => {
  it("drives while a key is held, and release stops robot and clock", () => {
    const loop = loopOf();
    loop.hold("forward");
    pass(loop, 500);
    expect(loop.snapshot()).toMatchObject({ driver: "me", state: "running", motion: "forward" });
    loop.hold("stop");
    const still = loop.snapshot();
    expect(still.pose.x).toBeCloseTo(100, -1);
    pass(loop, 500);
    expect(loop.snapshot()).toMatchObject({ tick: still.tick, pose: still.pose, motion: "stop" });
  });

  it("turns in whole steps, so that a quarter turn can be met exactly", () => {
    const loop = loopOf();
    loop.hold("right");
    pass(loop, 600);
    loop.hold("stop");
    expect(loop.snapshot().pose.heading % 2.5).toBe(0);
  });

  it("takes over from a running program, and Run returns the robot to the program", () => {
    const loop = loopOf();
    loop.run();
    pass(loop, 300);
    loop.hold("left");
    expect(loop.snapshot()).toMatchObject({ driver: "me", line: null });
    loop.hold("stop");
    loop.run();
    expect(loop.snapshot()).toMatchObject({ driver: "program", state: "running" });
  });

  it("rests at the goal under a key that is still held, and drives on at the next press", () => {
    const loop = loopOf({ ...firstMaze, goals: [{ column: 2, row: 6 }] });
    loop.hold("forward");
    expect(pass(loop, 4000)).toMatchObject([{ kind: "goal", driver: "me" }]);
    expect(loop.snapshot().state).toBe("paused");
    const goal = loop.snapshot().pose.x;
    loop.hold("stop");
    loop.hold("forward");
    pass(loop, 500);
    expect(loop.snapshot().pose.x).toBeGreaterThan(goal);
  });

  it("releasing a key that was pressed before the program ran does not stop the program", () => {
    const loop = loopOf();
    loop.run();
    loop.hold("stop");
    expect(loop.snapshot()).toMatchObject({ driver: "program", state: "running" });
  });
});

describe("an offered driver", () => {
  it("takes a robot that waits at its start", () => {
    const loop = loopOf();
    loop.offerDriver("me");
    expect(loop.driver).toBe("me");
  });

  it.each([
    { name: "the program has just been started", act: (loop: RunLoop) => loop.run() },
    { name: "a script has been chosen", act: (loop: RunLoop) => loop.setDriver("remote") },
    { name: "a run has begun", act: (loop: RunLoop) => (loop.step(), void pass(loop, 500)) },
  ])("is not taken where $name", ({ act }) => {
    const loop = loopOf();
    act(loop);
    const { driver, isRunning } = loop;
    loop.offerDriver("me");
    expect(loop.driver).toBe(driver);
    expect(loop.isRunning).toBe(isRunning);
  });
});

describe("editing the maze", () => {
  it("under way leaves the robot where it is", () => {
    const loop = loopOf();
    loop.run();
    pass(loop, 1000);
    const { pose } = loop.snapshot();
    loop.editMaze({ ...firstMaze, name: "edited" });
    expect(loop.snapshot().pose).toEqual(pose);
    expect(loop.isRunning).toBe(true);
  });

  it("before the first tick moves the robot with the start", () => {
    const loop = loopOf();
    loop.editMaze({ ...firstMaze, start: { column: 4, row: 0, heading: "south" } });
    expect(loop.snapshot().pose).toEqual({ x: 450, y: 50, heading: 180 });
  });
});
