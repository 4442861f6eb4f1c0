import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { openRun } from "./open-run.ts";
import { Recording } from "./recording.ts";
import { readRun } from "./run-schema.ts";
import { anyLivelyProgram, anyOperations, anySmallMaze, perform } from "./testing/operations.ts";
import { Timeline } from "./timeline.ts";

/** All commands and waiting times of a timeline. */
function logOf({ commands }: Timeline, ticks: number) {
  return {
    commands: Array.from({ length: commands.count }, (_, index) => commands.at(index)),
    waited: Array.from({ length: ticks + 1 }, (_, tick) => commands.waitedUpTo(tick)),
  };
}

function resultsOf({ timeline }: Recording) {
  return logOf(timeline, 0).commands.map((each) => [each?.seq, each?.from, each?.to, each?.ending]);
}

/** A recording of a robot in a corridor of three cells, driven by a script. */
function scripted(): Recording {
  const recording = new Recording(
    {
      format: "corridor/maze",
      version: 1,
      name: "any",
      blocks: ["..."],
      start: { column: 0, row: 0, heading: "east" },
      goals: [],
    },
    { format: "corridor/program", version: 1, name: "any", rules: [], default: "stop" },
  );
  recording.addInput({ do: "driver", driver: "remote" });
  return recording;
}

function run(recording: Recording, ticks: number): void {
  for (let tick = 0; tick < ticks; tick++) recording.step();
}

describe("the commands of a script", () => {
  it("are recorded with their endings", () => {
    const recording = scripted();
    recording.addInput({ do: "command", command: { action: "move", distance: 20 }, seq: 4 });
    run(recording, 60);
    recording.addInput({ do: "command", command: { action: "forward" }, seq: 5 });
    run(recording, 10);
    recording.addInput({ do: "command", command: { action: "stop" }, seq: 6 });
    recording.addInput({ do: "command", command: { action: "forward" }, seq: 7 });
    run(recording, 10);
    recording.addInput({ do: "cancel", superseded: true });
    recording.addInput({ do: "command", command: { action: "turn", degrees: 90 }, seq: 8 });
    run(recording, 2);
    recording.addInput({ do: "cancel" });
    recording.addInput({ do: "command", command: { action: "reverse" }, seq: 9 });
    run(recording, 2);
    recording.addInput({ do: "driver", driver: "me" });
    const [first, ...rest] = resultsOf(recording);
    expect(first?.slice(0, 2)).toEqual([4, 0]);
    expect(first?.[2]).toBeLessThan(60);
    expect(first?.[3]).toBe("completed");
    expect(rest).toEqual([
      [5, 60, 70, "completed"],
      [6, 70, 70, "completed"],
      [7, 70, 80, "superseded"],
      [8, 80, 82, "cancelled"],
      [9, 82, 84, "cancelled"],
    ]);
  });

  it("end as collided after a collision, and have no ending while they run", () => {
    const recording = scripted();
    recording.addInput({ do: "command", command: { action: "move", distance: 500 }, seq: 1 });
    run(recording, 10);
    expect(resultsOf(recording)).toEqual([[1, 0, null, null]]);
    run(recording, 600);
    expect(resultsOf(recording)[0]?.[3]).toBe("collided");
  });

  it("do not include manual commands", () => {
    const recording = scripted();
    recording.addInput({ do: "driver", driver: "me" });
    recording.addInput({ do: "command", command: { action: "forward" } });
    run(recording, 10);
    expect(resultsOf(recording)).toEqual([]);
    expect(recording.timeline.commands.waitedUpTo(10)).toBe(0);
  });
});

describe("waiting time", () => {
  it("is the time in which a script is the driver but no command runs", () => {
    const recording = scripted();
    run(recording, 100);
    recording.addInput({ do: "command", command: { action: "forward" }, seq: 1 });
    run(recording, 30);
    recording.addInput({ do: "command", command: { action: "stop" }, seq: 2 });
    run(recording, 50);
    const { commands } = recording.timeline;
    expect([0, 60, 100, 130, 150, 180].map((tick) => commands.waitedUpTo(tick))).toEqual([
      0, 60, 100, 100, 120, 150,
    ]);
  });
});

it("is empty on the page when another run begins without a script", () => {
  const page = new Timeline();
  const sync = ({ timeline }: Recording) => {
    const delta = timeline.takeDelta();
    if (delta !== null) page.applyDelta(structuredClone(delta));
  };
  const recording = scripted();
  run(recording, 10);
  recording.addInput({ do: "command", command: { action: "forward" }, seq: 1 });
  run(recording, 10);
  sync(recording);
  expect(logOf(page, 20)).toEqual(logOf(recording.timeline, 20));
  expect(page.commands.count).toBe(1);
  const next = new Recording(recording.run.maze, recording.run.program);
  run(next, 20);
  sync(next);
  expect(logOf(page, 20)).toEqual(logOf(next.timeline, 20));
  expect(page.commands.count).toBe(0);
  expect(next.timeline.takeDelta()).toBeNull();
});

it("is the same on the page, in an opened file and after a truncation", () => {
  let commands = 0;
  let waits = 0;
  fc.assert(
    fc.property(
      anySmallMaze,
      anyLivelyProgram,
      anyOperations,
      anyOperations,
      fc.double({ min: 0, max: 1, noNaN: true }),
      (maze, program, before, after, part) => {
        const recording = new Recording(maze, program);
        const page = new Timeline();
        const sync = () => {
          const delta = recording.timeline.takeDelta();
          if (delta !== null) page.applyDelta(structuredClone(delta));
        };
        recording.addInput({ do: "driver", driver: "remote" });
        let waited = 0;
        const perTick = [0];
        let isWaiting = true;
        const countTick = () => {
          if (isWaiting) waited++;
          perTick.push(waited);
        };
        const drive = (operations: typeof before) => {
          for (const operation of operations) {
            const { run: live } = recording;
            isWaiting = live.driver === "remote" && live.command === null;
            perform(recording, operation, () => {
              countTick();
              isWaiting = live.driver === "remote" && live.command === null;
            });
            sync();
          }
        };
        drive(before);
        const tick = Math.floor(part * recording.run.tick);
        recording.truncate(tick);
        perTick.length = tick + 1;
        waited = perTick[tick] ?? 0;
        sync();
        drive(after);
        const end = recording.run.tick;
        const log = logOf(recording.timeline, end);
        expect(log.waited).toEqual(perTick);
        expect(logOf(page, end)).toEqual(log);
        const written = recording.toDocument("any");
        if (!written.ok) throw new Error(written.reason);
        const read = readRun(written.text);
        if (!read.ok) throw new Error(JSON.stringify(read.problems));
        const opened = openRun(read.value);
        if (!opened.ok) throw new Error(JSON.stringify(opened.problems));
        // Compared as JSON, which writes the power -0 as 0.
        expect(JSON.stringify(logOf(opened.value.timeline, end))).toBe(JSON.stringify(log));
        commands += log.commands.length;
        waits += waited;
      },
    ),
  );
  expect(commands).toBeGreaterThan(20);
  expect(waits).toBeGreaterThan(100);
});
