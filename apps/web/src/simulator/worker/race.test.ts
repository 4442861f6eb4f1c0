import { openRun, type RunDocument } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { Race } from "./race.ts";
import { Bench } from "./testing/bench.ts";
import type { AddedGhost, Speed } from "../protocol/worker-messages.ts";
import { GHOST_BADGES, type GhostPose } from "../../stage/drawing/frame.ts";

/** A run of the first maze that lasts so many seconds. */
function recorded(seconds: number, program = firstProgram): RunDocument {
  const bench = new Bench(firstMaze, program);
  bench.loop.run();
  bench.pass(seconds * 1000);
  const saved = bench.loop.saveRun();
  if (!saved.ok) throw new Error(saved.reason);
  return saved.run;
}

const rightWall = recorded(8);
const straight = recorded(4, { ...firstProgram, rules: [] });

/** A race whose slices run when the test requests them, with its answers. */
function raceOf(bench: Bench | null = null) {
  const answers = new Map<number, AddedGhost>();
  let due = 0;
  let time = 0;
  const race: Race = new Race({
    // Each call of the clock takes a millisecond, so that a slice ends.
    now: () => ++time,
    later: () => void due++,
    post: ({ id, added }) => void answers.set(id, added),
    onChange: () => bench?.loop.updates.raceWith(race),
  });
  const settle = () => {
    for (; due > 0; due--) race.next();
  };
  return { race, answers, settle };
}

/** Position of a recording at the end of a tick, by an independent replay. */
function poseIn(run: RunDocument, tick: number): Omit<GhostPose, "badge"> {
  const opened = openRun(run);
  if (!opened.ok) throw new Error("the run cannot be opened");
  const playback = opened.value.playback();
  playback.seek(Math.min(tick, run.ticks));
  const { x, y, heading } = playback.run.pose;
  return { x, y, heading };
}

describe("the ghosts of a race", () => {
  it("are loaded in slices, with the result of their run", () => {
    const { race, answers, settle } = raceOf();
    race.add({ type: "add-ghost", id: 1, badge: "A", run: rightWall });
    expect(answers.size).toBe(0);
    expect(race.posesAt(0)).toEqual([]);
    settle();
    expect(answers.get(1)).toEqual({
      ok: true,
      finish: { goalTick: null, bumps: 0, driver: "program", lines: firstProgram.rules.length },
    });
    expect(race.posesAt(60)).toEqual([{ badge: "A", ...poseIn(rightWall, 60) }]);
  });

  it("count bumps up to the goal", () => {
    const bench = new Bench();
    bench.loop.run();
    bench.loop.setSpeed("max");
    bench.time += 1;
    for (let i = 0; i < 200 && bench.loop.isRunning; i++) bench.pass(100);
    const saved = bench.loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const { race, answers, settle } = raceOf();
    race.add({ type: "add-ghost", id: 1, badge: "A", run: saved.run });
    settle();
    const goalTick = bench.loop.snapshot().tick;
    expect(bench.loop.snapshot().goalReached).toBe(true);
    expect(answers.get(1)).toMatchObject({ ok: true, finish: { goalTick, bumps: 0 } });
  });

  it("refuse a run that does not end in its own digest", () => {
    const { race, answers, settle } = raceOf();
    race.add({
      type: "add-ghost",
      id: 7,
      badge: "A",
      run: { ...rightWall, digest: "0".repeat(16) },
    });
    settle();
    expect(answers.get(7)).toMatchObject({ ok: false, problems: [{ path: "digest" }] });
    expect(race.posesAt(0)).toEqual([]);
  });

  it("are seven at most, and can be taken out, also while they are loading", () => {
    const { race, answers, settle } = raceOf();
    for (const [id, badge] of GHOST_BADGES.entries()) {
      race.add({ type: "add-ghost", id, badge, run: straight });
    }
    race.add({ type: "add-ghost", id: 9, badge: "H", run: straight });
    expect(answers.get(9)).toEqual({ ok: false, problems: [] });
    race.remove(2);
    settle();
    race.remove(0);
    expect(race.posesAt(10).map(({ badge }) => badge)).toEqual(["B", "D", "E", "F", "G"]);
  });

  it("are displayed at the displayed tick after any run, pause, seek, speed and Reset", () => {
    const speeds: Speed[] = [0.25, 1, 4, 16];
    const deed = fc.oneof(
      fc.record({ do: fc.constant("run" as const), ms: fc.integer({ min: 1, max: 900 }) }),
      fc.record({ do: fc.constant("pause" as const) }),
      fc.record({ do: fc.constant("seek" as const), tick: fc.integer({ min: 0, max: 900 }) }),
      fc.record({ do: fc.constant("step" as const), by: fc.constantFrom(1 as const, -1 as const) }),
      fc.record({ do: fc.constant("play" as const), ms: fc.integer({ min: 1, max: 400 }) }),
      fc.record({ do: fc.constant("speed" as const), speed: fc.constantFrom(...speeds) }),
      fc.record({ do: fc.constant("now" as const) }),
      fc.record({ do: fc.constant("hold" as const), ms: fc.integer({ min: 1, max: 400 }) }),
      fc.record({ do: fc.constant("reset" as const) }),
    );
    fc.assert(
      fc.property(fc.array(deed, { minLength: 1, maxLength: 14 }), (deeds) => {
        const bench = new Bench();
        const { race, settle } = raceOf(bench);
        race.add({ type: "add-ghost", id: 1, badge: "A", run: rightWall });
        race.add({ type: "add-ghost", id: 2, badge: "B", run: straight });
        settle();
        const { loop } = bench;
        for (const each of deeds) {
          if (each.do === "run") {
            loop.run();
            bench.pass(each.ms);
          } else if (each.do === "seek") loop.seek(each.tick);
          else if (each.do === "step") loop.seekStep(each.by);
          else if (each.do === "play") {
            loop.play();
            bench.pass(each.ms);
          } else if (each.do === "speed") loop.setSpeed(each.speed);
          else if (each.do === "now") loop.now();
          else if (each.do === "hold") {
            loop.hold("forward");
            bench.pass(each.ms);
            loop.hold("stop");
          } else if (each.do === "reset") loop.reset();
          else loop.pause();
          const frame = loop.updates.take()?.frame ?? bench.frame();
          const { tick } = frame.snapshot;
          expect(frame.ghosts).toEqual([
            { badge: "A", ...poseIn(rightWall, tick) },
            { badge: "B", ...poseIn(straight, tick) },
          ]);
        }
      }),
      { numRuns: 25 },
    );
  });

  it("leave the robot's own run as it is", () => {
    const alone = new Bench();
    const raced = new Bench();
    const { race, settle } = raceOf(raced);
    race.add({ type: "add-ghost", id: 1, badge: "A", run: straight });
    settle();
    for (const bench of [alone, raced]) {
      bench.loop.run();
      bench.pass(6000);
    }
    expect(raced.loop.saveRun()).toEqual(alone.loop.saveRun());
  });
});
