import type { Command, PlainAction } from "@corridor/protocol";
import { plainActions } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ProgramRun, type Decider } from "./program-run.ts";
import { Simulation } from "./simulation.ts";
import { SnapshotDigest } from "./snapshot-digest.ts";
import { anyCommand, anyMaze, mazeOf } from "./testing/mazes.ts";

/** Generates programs of lines that compare a sensor with a distance, with one action each. */
const anyDecider: fc.Arbitrary<Decider> = fc
  .record({
    lines: fc.array(
      fc.record({
        sensor: fc.nat({ max: 3 }),
        isLess: fc.boolean(),
        than: fc.integer({ min: 20, max: 260 }),
      }),
      { maxLength: 5 },
    ),
    actions: fc.array(fc.constantFrom<PlainAction>(...plainActions), {
      minLength: 6,
      maxLength: 6,
    }),
  })
  .map(({ lines, actions }) => {
    const commands = actions.map((action) => ({ action }));
    return {
      ruleCount: lines.length,
      decide: (readings) =>
        lines.findIndex(({ sensor, isLess, than }) =>
          isLess ? (readings[sensor] ?? 0) < than : (readings[sensor] ?? 0) > than,
        ),
      commandOf: (rule) => commands[rule + 1] ?? { action: "stop" },
    };
  });

/** Generates commands in tick order. Each applies before its tick. */
const anyInputs = fc
  .array(fc.record({ tick: fc.nat({ max: 300 }), command: anyCommand }), { maxLength: 10 })
  .map((inputs) => inputs.toSorted((a, b) => a.tick - b.tick));

const TICKS = 300;

describe("a robot saved at any tick and restored into a new simulation", () => {
  it("continues bit for bit under commands", () => {
    let saved = 0;
    let savedInContact = 0;
    fc.assert(
      fc.property(anyMaze, anyInputs, fc.nat({ max: TICKS - 1 }), (maze, inputs, at) => {
        const run = (simulation: Simulation, from: number, digest: SnapshotDigest): string => {
          for (let tick = from; tick < TICKS; tick++) {
            for (const input of inputs) if (input.tick === tick) simulation.apply(input.command);
            simulation.step();
            digest.add(simulation.report());
          }
          return digest.toString() + JSON.stringify(simulation.save());
        };
        const through = run(new Simulation(maze), 0, new SnapshotDigest());

        const first = new Simulation(maze);
        const digest = new SnapshotDigest();
        for (let tick = 0; tick < at; tick++) {
          for (const input of inputs) if (input.tick === tick) first.apply(input.command);
          first.step();
          digest.add(first.report());
        }
        const state = structuredClone(first.save());
        // Later steps of the first simulation must not affect the copy.
        first.apply({ action: "turn 180" });
        first.step();
        const second = new Simulation(maze);
        second.restore(state);
        saved++;
        if (state.physics.inContact) savedInContact++;
        expect(second.report().tick).toBe(at);
        expect(run(second, at, digest)).toBe(through);
      }),
      { numRuns: 300 },
    );
    // Both cases occurred. Their numbers depend on the random seed.
    expect(savedInContact).toBeGreaterThan(0);
    expect(saved - savedInContact).toBeGreaterThan(0);
  });

  it("continues bit for bit under a program, with or without a decision, with equal counts", () => {
    fc.assert(
      fc.property(
        anyMaze,
        anyDecider,
        fc.nat({ max: TICKS - 1 }),
        fc.boolean(),
        (maze, decider, at, decidesEarly) => {
          const run = (simulation: Simulation, program: ProgramRun, from: number, to: number) => {
            const digest = new SnapshotDigest();
            for (let tick = from; tick < to; tick++) {
              program.step();
              digest.add(simulation.report());
            }
            return `${digest.toString()} ${program.line} ${program.decisions.join()}`;
          };
          const through = new Simulation(maze);
          const throughRun = new ProgramRun(through, decider);
          run(through, throughRun, 0, at);
          if (decidesEarly) throughRun.decide();
          const robot = structuredClone(through.save());
          const program = structuredClone(throughRun.save());
          const rest = run(through, throughRun, at, TICKS);

          const again = new Simulation(mazeOf(["."], { column: 0, row: 0 }));
          const againRun = new ProgramRun(again, decider);
          again.restore(robot, maze);
          againRun.restore(program);
          expect(run(again, againRun, at, TICKS)).toBe(rest);
        },
      ),
      { numRuns: 300 },
    );
  });
});

it("a reset robot behaves like a new one, bit for bit", () => {
  fc.assert(
    fc.property(anyMaze, fc.array(anyCommand, { maxLength: 6 }), anyCommand, (maze, past, then) => {
      const drive = (simulation: Simulation, command: Command): void => {
        simulation.apply(command);
        for (let tick = 0; tick < 80; tick++) simulation.step();
      };
      const used = new Simulation(maze);
      for (const command of past) drive(used, command);
      used.reset();
      const fresh = new Simulation(maze);
      drive(used, then);
      drive(fresh, then);
      expect(used.save().physics).toEqual(fresh.save().physics);
      expect(used.report()).toEqual(fresh.report());
    }),
    { numRuns: 100 },
  );
});
