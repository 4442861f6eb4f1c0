import { describe, expect, it } from "vitest";
import type { Frame } from "../../stage/drawing/frame.ts";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";
import { RunAttempts, type FinishedRun } from "./run-attempts.ts";

/** The runs that are found in messages of the worker. */
function newAttempts(start = { tick: 0, bumps: 0 }) {
  const runs: FinishedRun[] = [];
  const timers = new Set<() => void>();
  let program = "a";
  let maze: string | null = "g1";
  const attempts = new RunAttempts(
    {
      program: () => program,
      maze: () => maze,
      onFinished: (run) => runs.push(run),
      later: (call) => {
        timers.add(call);
        return () => void timers.delete(call);
      },
    },
    start,
  );
  const frame = (tick: number, change: Partial<Frame> = {}): void => {
    attempts.receive({ type: "frame", frame: frameOf(tick, change), timeline: null });
  };
  // The page has just opened.
  frame(start.tick, bumped(start.bumps, "paused"));
  return {
    attempts,
    runs,
    edit: (text: string): void => {
      program = text;
      attempts.edited();
    },
    /** Opens another maze; null: none of the task. */
    open: (name: string | null): void => void (maze = name),
    bump: (tick: number, bumps: number, driver: "me" | "program" = "program"): void => {
      const pose = { x: 350 + bumps * 100, y: 150, heading: 90 };
      const event = { kind: "bump", tick, bumps, line: "default", driver, pose };
      attempts.receive({ type: "event", event } as FromWorker);
    },
    drive: (tick: number) => frame(tick),
    driveByHand: (tick: number, bumps = 0) => frame(tick, { nowDriver: "me", ...bumped(bumps) }),
    driveByScript: (tick: number, x: number) =>
      frame(tick, { nowDriver: "remote", ...bumped(0, "running", x) }),
    showPast: (tick: number, x: number) =>
      frame(tick, { nowDriver: "remote", view: "past", ...bumped(0, "running", x) }),
    end: (tick: number, bumps = 0) => frame(tick, { hasEnded: true, ...bumped(bumps, "paused") }),
    pause: (tick: number) => frame(tick, bumped(0, "paused")),
    reset: (after = -1) => attempts.receive({ type: "truncated", after }),
    wait: (): void => {
      for (const call of timers) call();
      timers.clear();
    },
  };
}

function frameOf(tick: number, change: Partial<Frame>): Frame {
  const shown = { nowTick: tick, nowDriver: "program", view: "now", hasEnded: false } as const;
  return { ...bumped(0), ...shown, ...change } as Frame;
}

function bumped(
  bumps: number,
  state: "running" | "paused" = "running",
  x = 150,
): Pick<Frame, "snapshot"> {
  return { snapshot: { bumps, state, pose: { x, y: 150, heading: 0 } } as Frame["snapshot"] };
}

const passed = { bumps: 0, mistakes: 0, failure: null };

describe("the runs of a student", () => {
  it("end at a bump, with the reason that follows", () => {
    const { attempts, runs, drive, end, wait } = newAttempts();
    drive(10);
    end(90, 1);
    expect(runs).toEqual([]);
    attempts.failed({ code: "bump", line: 2 }, 1, 90);
    wait();
    expect(runs).toEqual([
      { program: "a", bumps: 1, mistakes: 1, failure: { code: "bump", line: 2 } },
    ]);
  });

  it("are one run with a pause", () => {
    const { attempts, runs, drive, pause } = newAttempts();
    drive(10);
    pause(20);
    drive(30);
    attempts.met();
    expect(runs).toEqual([{ program: "a", ...passed }]);
  });

  it("are two runs if the robot drives on after a bump", () => {
    const { attempts, runs, edit, drive, end } = newAttempts();
    drive(10);
    end(90, 1);
    edit("b");
    drive(100);
    attempts.met();
    expect(runs.map(({ program }) => program)).toEqual(["a", "b"]);
  });

  it("end with an edit after the robot drove in circles", () => {
    const { attempts, runs, edit, drive } = newAttempts();
    drive(10);
    attempts.failed({ code: "circles", line: 0 }, 1, 10);
    edit("b");
    drive(20);
    attempts.met();
    expect(runs).toEqual([
      { program: "a", bumps: 0, mistakes: 1, failure: { code: "circles", line: 0 } },
      { program: "b", ...passed },
    ]);
  });

  it("have the newest program that drove, not one that was edited after it", () => {
    const { runs, edit, drive, reset } = newAttempts();
    drive(10);
    edit("b");
    drive(20);
    edit("c");
    reset();
    expect(runs).toEqual([{ program: "b", ...passed }]);
  });

  it("are found if a fast run begins and ends between two frames", () => {
    const { runs, end, wait } = newAttempts();
    end(300, 1);
    wait();
    expect(runs).toHaveLength(1);
    expect(runs[0]?.bumps).toBe(1);
  });

  it("have the reason of a bump that arrives before its frame", () => {
    const { runs, bump, end, wait } = newAttempts();
    bump(300, 1);
    end(300, 1);
    wait();
    const failure = { code: "bump", line: "default" };
    const bumpPlaces = [{ maze: "g1", column: 4, row: 1 }];
    expect(runs).toEqual([{ program: "a", bumps: 1, bumpPlaces, mistakes: 0, failure }]);
  });

  it("have the places of their first 20 bumps in mazes of the task", () => {
    const { runs, bump, open, driveByHand, reset } = newAttempts();
    driveByHand(10);
    open(null);
    bump(11, 1, "me");
    open("g2");
    for (let bumps = 2; bumps <= 30; bumps++) bump(10 + bumps, bumps, "me");
    reset();
    expect(runs[0]?.bumps).toBe(30);
    expect(runs[0]?.bumpPlaces).toHaveLength(20);
    expect(runs[0]?.bumpPlaces?.[0]).toEqual({ maze: "g2", column: 5, row: 1 });
    driveByHand(5);
    reset();
    expect(runs[1]).toEqual({ program: null, ...passed });
  });

  it("end with the time of the task, also before the next frame", () => {
    const { attempts, runs, pause, wait } = newAttempts();
    attempts.failed({ code: "late", line: null }, 0, 3_600);
    pause(3_600);
    wait();
    expect(runs).toEqual([{ program: "a", ...passed, failure: { code: "late", line: null } }]);
  });

  it("end when the robot is reset, or the past replaces them", () => {
    const { runs, drive, reset } = newAttempts();
    drive(10);
    reset();
    drive(40);
    reset(20);
    drive(30);
    expect(runs).toHaveLength(2);
  });

  it("are one drive by hand until the robot is reset, also after it failed", () => {
    const { attempts, runs, driveByHand, reset } = newAttempts();
    driveByHand(10);
    driveByHand(20, 1);
    attempts.failed({ code: "bump", line: null }, 0, 20);
    driveByHand(30, 2);
    expect(runs).toEqual([
      { program: null, bumps: 1, mistakes: 0, failure: { code: "bump", line: null } },
    ]);
    reset();
    driveByHand(5);
    attempts.met();
    expect(runs[1]).toEqual({ program: null, ...passed });
  });

  it("are one drive while hands and scripts drive in turn", () => {
    const { attempts, runs, drive, driveByHand, driveByScript } = newAttempts();
    driveByScript(10, 160);
    driveByHand(20);
    driveByScript(30, 170);
    attempts.met();
    expect(runs).toEqual([{ program: null, ...passed }]);
    drive(40);
    attempts.met();
    expect(runs[1]).toEqual({ program: "a", ...passed });
  });

  it("begin when a script moves the robot, not while the robot waits for one", () => {
    const { runs, driveByScript, showPast, reset } = newAttempts();
    driveByScript(10, 150);
    driveByScript(20, 150);
    // The student looks at the past of the robot meanwhile.
    showPast(30, 600);
    driveByScript(40, 150);
    reset();
    driveByScript(10, 150);
    driveByScript(20, 190);
    driveByScript(90, 190);
    reset();
    expect(runs).toEqual([{ program: null, ...passed }]);
  });

  it("are not the run that a reload restores", () => {
    const { attempts, runs, reset, pause, drive, wait } = newAttempts({ tick: 500, bumps: 1 });
    reset();
    attempts.receive({ type: "run-loaded", id: 1, loaded: { ok: true } as never } as FromWorker);
    pause(800);
    wait();
    reset();
    expect(runs).toEqual([]);
    drive(10);
    reset();
    expect(runs).toHaveLength(1);
  });
});
