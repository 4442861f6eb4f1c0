import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { Bench, momentOf, tenSeconds } from "./testing/bench.ts";

describe("the displayed past", () => {
  it("delays nobody: the live run is paused and scripts still receive the newest state", () => {
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

  it("ends at the newest tick if the last one is requested", () => {
    const bench = tenSeconds();
    bench.loop.seek(60);
    bench.loop.seek(99_999_999);
    expect(bench.frame()).toMatchObject({ view: "now" });
  });

  it("sends the trail up to the displayed tick: the new part forwards, all of it backwards", () => {
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
    const corners = [...(whole.loop.updates.take()?.frame.corners ?? [])];
    for (let i = 0; i < 10_000 / 8; i++) {
      whole.time += 8;
      whole.loop.advance();
      corners.push(...(whole.loop.updates.take()?.frame.corners ?? []));
    }
    expect([...early.corners, ...later.corners, ...rest.corners]).toEqual(corners);
    expect(all.snapshot.tick).toBe(whole.loop.snapshot().tick);
  });

  it("is played at the chosen speed up to the newest tick, and changes nothing", () => {
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

  it("is stepped through decision by decision, up to the newest tick", () => {
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

  it("shows what the newest program would do there; after resuming, the robot does it", () => {
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

  it("retains the recording if the program was edited and the newest tick is displayed again", () => {
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
    expect(bench.loop.updates.pastMaze).toBeNull();
    bench.loop.seek(30);
    expect(bench.loop.updates.pastMaze).toEqual(then);
    bench.loop.editMaze({ ...firstMaze, name: "another" });
    expect(bench.frame().view).toBe("now");
    expect(bench.loop.updates.pastMaze).toBeNull();
  });

  it("is continued by hand with a drive key", () => {
    const bench = tenSeconds();
    bench.loop.seek(30);
    bench.loop.hold("reverse");
    const frame = bench.pass(200);
    expect(frame).toMatchObject({ view: "now", snapshot: { driver: "me", motion: "reverse" } });
    expect(frame?.nowTick).toBeLessThan(50);
  });

  it("is left when a script sends a command, whose robot continues", () => {
    const bench = new Bench();
    bench.loop.setDriver("remote");
    bench.deliver({ action: "move", distance: 100 });
    bench.pass(3000);
    bench.loop.seek(20);
    bench.deliver({ action: "left 90" });
    expect(bench.pass(2000)).toMatchObject({ view: "now", snapshot: { state: "running" } });
    expect(bench.story).toEqual(["started 1", "completed 1", "started 2", "completed 2"]);
  });

  it("cancels a script's commands when it is continued, each command once", () => {
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

describe("an edit that is reverted while the past is displayed", () => {
  it.each([
    { name: "back to now", goOn: ({ loop }: Bench) => loop.now() },
    { name: "on from there", goOn: ({ loop }: Bench) => loop.run() },
  ])("changes nothing in the run that continues $name", ({ goOn }) => {
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
