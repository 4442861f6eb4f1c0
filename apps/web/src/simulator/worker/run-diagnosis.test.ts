import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument, Rule } from "@corridor/program";
import { describe, expect, it } from "vitest";
import * as diagnostics from "./diagnose-run.ts";
import { RunLoop } from "./run-loop.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

let time = 0;

function mazeOf(blocks: string[], row: number): MazeDocument {
  const start = { column: 0, row, heading: "east" } as const;
  return { format: "corridor/maze", version: 1, name: "", blocks, start, goals: [] };
}

function programOf(rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: "forward", rules };
}

/** With the diagnostics loaded from the start. */
function newLoop(...[maze, program, now]: ConstructorParameters<typeof RunLoop>): RunLoop {
  const loop = new RunLoop(maze, program, now);
  loop.updates.useDiagnostics(diagnostics);
  return loop;
}

/**
 * Lets real time pass in frames.
 * @returns the reported events
 */
function pass(loop: RunLoop, seconds: number): RunEvent[] {
  const moments: RunEvent[] = [];
  for (let frame = 0; frame < seconds * 60; frame++) {
    time += 1000 / 60 + 1e-9;
    loop.advance();
    moments.push(...(loop.updates.take()?.events ?? []));
  }
  return moments;
}

const corner = mazeOf(["##.", "##.", "..."], 2);
const delayedAtTheWall = programOf([
  { when: { sensor: "front", is: "<", than: 60 }, do: "delayed left 90" },
]);

/** Drives the same way but is another program. */
const other = { ...programOf([]), name: "other" };

describe("a bump of the program", () => {
  it("pauses the run, with an edit that would have prevented it", () => {
    const loop = newLoop(corner, delayedAtTheWall, () => time);
    loop.run();
    const [moment] = pass(loop, 5);
    expect(moment).toMatchObject({ kind: "bump", line: 0, bumps: 1 });
    expect(moment?.diagnosis?.fixes[0]).toEqual({ kind: "action", line: 0, action: "left 90" });
    expect(moment?.cause).toMatchObject({ part: 0, parts: 3, needed: 50 });
    expect(loop.isRunning).toBe(false);
    expect(loop.snapshot().tick).toBe(moment?.tick);
  });

  describe("while the diagnostics load", () => {
    function bumped(): RunLoop {
      const loop = new RunLoop(corner, delayedAtTheWall, () => time);
      loop.updates.awaitDiagnostics(true);
      loop.run();
      expect(pass(loop, 5)).toEqual([]);
      expect(loop.isRunning).toBe(false);
      return loop;
    }
    const unexplained = [{ kind: "bump", line: 0, bumps: 1, diagnosis: null }];

    it("is reported once, with its explanation", () => {
      const loop = bumped();
      loop.updates.useDiagnostics(diagnostics);
      const [bump, ...others] = pass(loop, 1);
      expect(others).toEqual([]);
      expect(bump).toMatchObject({ kind: "bump", tick: loop.snapshot().tick });
      expect(bump?.diagnosis?.fixes[0]).toEqual({ kind: "action", line: 0, action: "left 90" });
    });

    it.each([
      {
        cause: "they cannot be loaded",
        act: (loop: RunLoop) => loop.updates.awaitDiagnostics(false),
      },
      { cause: "the robot drives on", act: (loop: RunLoop) => loop.run() },
    ])("is reported without an explanation if $cause", ({ act }) => {
      const loop = bumped();
      act(loop);
      expect(pass(loop, 0.1)).toMatchObject(unexplained);
      loop.updates.useDiagnostics(diagnostics);
      expect(pass(loop, 0.1)).toEqual([]);
    });

    it("is not reported any more after a reset", () => {
      const loop = bumped();
      loop.reset();
      loop.updates.useDiagnostics(diagnostics);
      expect(pass(loop, 1)).toEqual([]);
    });
  });

  it("reports the program that drove, although another one arrived before the report", () => {
    const loop = newLoop(corner, delayedAtTheWall, () => time);
    loop.run();
    while (loop.snapshot().bumps === 0) {
      time += 8;
      loop.advance();
    }
    loop.editProgram(other);
    const [moment] = loop.updates.take()?.events ?? [];
    expect(moment?.program).toEqual(delayedAtTheWall);
  });

  it("of a turn that started before an edit is explained by the program that started it", () => {
    const loop = newLoop(corner, delayedAtTheWall, () => time);
    loop.run();
    while (loop.snapshot().line !== 0) {
      time += 8;
      loop.advance();
    }
    // Two ticks into it.
    time += 40;
    loop.advance();
    loop.editProgram(other);
    const [moment] = pass(loop, 5);
    expect(moment).toMatchObject({ kind: "bump", line: 0 });
    expect(moment?.program).toEqual(delayedAtTheWall);
    expect(moment?.diagnosis?.fixes[0]).toEqual({ kind: "action", line: 0, action: "left 90" });
  });

  it("is explained as it happened, although the same turn has bumped before", () => {
    const maze = mazeOf(["#####", "....#", "###.#", "#...#"], 1);
    const loop = newLoop(maze, delayedAtTheWall, () => time);
    loop.run();
    const [first] = pass(loop, 8);
    expect(first).toMatchObject({ kind: "bump", line: 0 });
    loop.editProgram(programOf([{ when: { sensor: "front", is: "<", than: 60 }, do: "left 90" }]));
    loop.run();
    const [second] = pass(loop, 8);
    expect(second).toMatchObject({ kind: "bump", bumps: 2 });
    expect(second?.diagnosis?.event.tick).toBe(second?.tick);
    expect(second?.tick).toBeGreaterThan(first?.tick ?? 0);
  });

  it("offers the delayed turn where the line before turned at the edge of an opening", () => {
    const way = Array.from({ length: 8 }, () => "##.##");
    const opening = mazeOf(["#####", ".....", ...way], 1);
    const tooEarly = programOf([{ when: { sensor: "right", is: ">", than: 60 }, do: "right 90" }]);
    const loop = newLoop(opening, tooEarly, () => time);
    loop.run();
    const [moment] = pass(loop, 8);
    expect(moment).toMatchObject({ kind: "bump", line: "default" });
    expect(moment?.diagnosis?.fixes[0]).toEqual({
      kind: "action",
      line: 0,
      action: "delayed right 90",
    });
  });

  it("is explained once per line: a user who continues is not stopped again", () => {
    const loop = newLoop(corner, programOf([]), () => time);
    loop.run();
    pass(loop, 5);
    expect(loop.isRunning).toBe(false);
    loop.run();
    pass(loop, 5);
    expect(loop.isRunning).toBe(true);
  });

  it.each([
    { name: "another program", change: (loop: RunLoop) => loop.editProgram(other) },
    { name: "a new run", change: (loop: RunLoop) => loop.reset() },
  ])("is explained again to $name", ({ change }) => {
    const loop = newLoop(corner, programOf([]), () => time);
    loop.run();
    pass(loop, 5);
    change(loop);
    loop.reset();
    loop.run();
    expect(pass(loop, 5)).toHaveLength(1);
    expect(loop.isRunning).toBe(false);
  });

  it("does not stop a user who bumps", () => {
    const loop = newLoop(corner, programOf([]), () => time);
    loop.hold("forward");
    const [moment] = pass(loop, 5);
    expect(moment).toMatchObject({ kind: "bump", driver: "me", diagnosis: null, program: null });
    expect(loop.isRunning).toBe(true);
  });
});

describe("a robot that gets nowhere", () => {
  it("is diagnosed from the tick of the sign, even if the diagnostics load later", () => {
    const loop = new RunLoop(corner, programOf([]), () => time);
    loop.run();
    pass(loop, 5);
    loop.run();
    pass(loop, 3);
    expect(loop.updates.takeDiagnosed()).toBeNull();
    const { tick } = loop.snapshot();
    loop.updates.useDiagnostics(diagnostics);
    const event = loop.updates.takeDiagnosed()?.diagnosis.event;
    expect(event).toMatchObject({ kind: "pushing", line: "default" });
    expect(event?.tick).toBeLessThan(tick);
  });

  it("is detected once while it pushes a wall, and again after a change", () => {
    const loop = newLoop(corner, programOf([]), () => time);
    loop.run();
    pass(loop, 5);
    loop.run();
    pass(loop, 1);
    expect(loop.updates.takeDiagnosed()).toBeNull();
    pass(loop, 2);
    expect(loop.updates.takeDiagnosed()).toMatchObject({
      diagnosis: { event: { kind: "pushing", line: "default" } },
    });
    pass(loop, 5);
    expect(loop.updates.takeDiagnosed()).toBeNull();
    loop.editProgram(other);
    pass(loop, 3);
    expect(loop.updates.takeDiagnosed()).toMatchObject({
      diagnosis: { event: { kind: "pushing" } },
    });
  });
});
