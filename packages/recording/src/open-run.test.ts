import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { openRun, Replay } from "./open-run.ts";
import { Recording } from "./recording.ts";
import type { RunDocument } from "./run-document.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Hall",
  blocks: ["....", "....", "...."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};
const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Round",
  default: "forward",
  rules: [{ when: { sensor: "front", is: "<", than: 50 }, do: "right 90" }],
};

function recorded(ticks: number): RunDocument {
  const recording = new Recording(maze, program);
  while (recording.run.tick < ticks) {
    if (recording.run.tick % 500 === 250) {
      recording.addInput({
        do: "program",
        program: { ...program, name: `at ${recording.run.tick}` },
      });
    }
    recording.step();
  }
  const written = recording.toDocument("Round");
  if (!written.ok) throw new Error(written.reason);
  return written.run;
}

/** Replays in the smallest steps. */
function replaySlowly(run: RunDocument, until?: number) {
  const replay = new Replay(run, until);
  const reached = [replay.tick];
  for (;;) {
    const end = replay.advance(() => false);
    reached.push(replay.tick);
    if (end !== null) return { end, reached, ticks: replay.ticks };
  }
}

describe("a run replayed in small steps", () => {
  it("ends like a replay in one call, and yields at least every 64 ticks", () => {
    const run = recorded(3_000);
    const { end, reached, ticks } = replaySlowly(run, 3_500);
    const whole = openRun(run, 3_500);
    if (!end.ok || !whole.ok) throw new Error("not opened");
    expect(end.value.run.save()).toEqual(whole.value.run.save());
    expect(end.value.toDocument("")).toEqual(whole.value.toDocument(""));
    expect(ticks).toBe(3_500);
    expect(reached.at(-1)).toBe(3_500);
    const steps = reached.slice(1).map((tick, index) => tick - (reached[index] ?? 0));
    expect(Math.max(...steps)).toBeLessThanOrEqual(64);
  });

  it("is rejected for a wrong digest, before any tick after its end", () => {
    const run = { ...recorded(700), digest: "0123456789abcdef" };
    const { end, reached } = replaySlowly(run, 5_000);
    expect(end).toMatchObject({ ok: false, problems: [{ path: "digest" }] });
    expect(reached.at(-1)).toBe(700);
  });

  it("never exceeds the maximum length of a run", () => {
    expect(new Replay(recorded(10), Infinity).ticks).toBe(24 * 60 * 60 * 60);
  });
});
