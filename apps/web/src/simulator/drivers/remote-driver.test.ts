/** Remote commands in the robot, as reported to the relay. */
import type { DeliveredCommand, RemoteCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { firstProgram } from "../protocol/first-project.ts";
import { Bench, deliveryOf } from "../worker/testing/bench.ts";

const MOVE: RemoteCommand = { action: "move", distance: 100 };

function robot() {
  const bench = new Bench();
  bench.loop.setDriver("remote");
  let seq = 0;
  const deliver = (command: RemoteCommand, change: Partial<DeliveredCommand> = {}): void => {
    const acceptedAt = new Date(bench.time).toISOString();
    bench.loop.accept(deliveryOf(++seq, command, { acceptedAt, ...change }));
  };
  return { bench, deliver };
}

describe("a queued remote command", () => {
  it("expires after its ttl, and no command behind it waits for that", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    deliver(MOVE, { remaining: 400 });
    deliver({ action: "left 90" });
    bench.pass(392);
    expect(bench.story).toEqual(["started 1"]);
    bench.pass(16);
    expect(bench.story).toEqual(["started 1", "expired 2"]);
    bench.pass(3_000);
    expect(bench.story.slice(2)).toEqual(["completed 1", "started 3", "completed 3"]);
  });

  it("expires in a paused robot, and does not run when it resumes", () => {
    const { bench, deliver } = robot();
    bench.loop.pause();
    deliver(MOVE, { remaining: 400 });
    bench.pass(500);
    bench.loop.run();
    bench.pass(500);
    expect(bench.story).toEqual(["expired 1"]);
  });

  it("runs to its end once it has started in time", () => {
    const { bench, deliver } = robot();
    deliver(MOVE, { remaining: 200 });
    bench.pass(2_000);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
  });

  it("is discarded when the relay takes it back", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    deliver(MOVE);
    bench.pass(100);
    bench.loop.remote?.reset();
    bench.pass(2_000);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
  });
});

describe("a remote command that replaces", () => {
  it("ends the running and the queued commands, and starts at once", () => {
    const { bench, deliver } = robot();
    deliver({ action: "turn", degrees: 720 });
    deliver(MOVE);
    bench.pass(100);
    deliver({ action: "forward" }, { replace: true });
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "superseded 1", "superseded 2", "started 3"]);
    expect(bench.loop.snapshot()).toMatchObject({ motion: "forward", command: 3 });
  });
});

describe("a remote command that its sender cancels", () => {
  it("stops the robot where it runs", () => {
    const { bench, deliver } = robot();
    deliver({ action: "forward" });
    bench.pass(100);
    bench.loop.remote?.cancelOne(1);
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
    expect(bench.loop.snapshot()).toMatchObject({ motion: "stop", command: null });
  });

  it("leaves the others alone while queued, and has no effect after it ended", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 3; n++) deliver(MOVE);
    bench.pass(100);
    bench.loop.remote?.cancelOne(2);
    bench.loop.remote?.cancelOne(2);
    bench.pass(4_000);
    expect(bench.story).toEqual([
      "started 1",
      "cancelled 2",
      "completed 1",
      "started 3",
      "completed 3",
    ]);
  });
});

describe("a motion without an end", () => {
  const alive = (silentMs = 0) => [{ driver: "Zx81qP", silentMs, connectionMs: null }];

  it("stops 3 s after the last message of its script", () => {
    const { bench, deliver } = robot();
    // Slow enough not to meet a wall: leases count real time.
    bench.loop.setSpeed(0.25);
    deliver({ action: "forward" });
    bench.pass(2_000);
    bench.loop.remote?.renew(alive(500));
    bench.pass(2_400);
    expect(bench.story).toEqual(["started 1"]);
    bench.pass(200);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
    expect(bench.loop.snapshot()).toMatchObject({ motion: "stop", command: null });
  });

  it("is not renewed once it has expired, for example while the page was frozen", () => {
    const { bench, deliver } = robot();
    bench.loop.setSpeed(0.25);
    deliver({ action: "forward" });
    bench.pass(100);
    bench.time += 5_000;
    bench.loop.remote?.renew(alive());
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
  });

  it("is not renewed by another script", () => {
    const { bench, deliver } = robot();
    // Slow enough not to meet a wall: leases count real time.
    bench.loop.setSpeed(0.25);
    deliver({ action: "forward" });
    bench.pass(2_000);
    bench.loop.remote?.renew([{ driver: "other1", silentMs: 0, connectionMs: null }]);
    bench.pass(1_100);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
  });

  it.each([
    { name: "half a second", lease: null, ends: 500 },
    { name: "what the script asked for", lease: 1_500, ends: 1_500 },
  ])("by wheel powers stops after $name without a next one", ({ lease, ends }) => {
    const { bench, deliver } = robot();
    deliver({ action: "drive", left: 0.1, right: -0.1 }, { lease });
    bench.pass(ends - 20);
    bench.loop.remote?.renew(alive());
    expect(bench.story).toEqual(["started 1"]);
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
  });

  it("by wheel powers continues while they are repeated", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 10; n++) {
      deliver({ action: "drive", left: 0.1, right: -0.1 });
      bench.pass(100);
    }
    expect(bench.story.at(-1)).toBe("started 10");
    expect(bench.loop.snapshot()).toMatchObject({ motion: "drive" });
  });

  it("has no lease if it has a duration: it runs to its end", () => {
    const { bench, deliver } = robot();
    deliver({ action: "drive", left: 0.1, right: -0.1, milliseconds: 5_000 });
    bench.pass(5_200);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
  });
});

describe("a guarded motion", () => {
  const until = (than: number) => [{ sensor: "front" as const, is: "<=" as const, than }];
  /** The first maze: a corridor ahead of the robot. */
  const front = ({ loop }: Bench) => loop.snapshot().sensors.front;

  it("ends as completed on the first tick on which a condition is true", () => {
    const { bench, deliver } = robot();
    const limit = front(bench) - 30.5;
    deliver({ action: "forward", until: until(limit) });
    bench.pass(2_000);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
    expect(front(bench)).toBeLessThanOrEqual(limit);
    // One tick of forward is less than 2 cm.
    expect(front(bench)).toBeGreaterThan(limit - 2);
    expect(bench.endings.get(1)).toMatchObject({ pose: bench.loop.snapshot().pose });
    expect(bench.loop.snapshot()).toMatchObject({ motion: "stop", command: null });
  });

  it("does not move if a condition is true at its start, and stops the motion before it", () => {
    const { bench, deliver } = robot();
    deliver({ action: "forward" });
    bench.pass(100);
    const { pose } = bench.loop.snapshot();
    deliver({ action: "forward", until: until(10_000) });
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "completed 1", "started 2", "completed 2"]);
    expect(bench.endings.get(2)).toMatchObject({ distance: 0, pose });
    expect(bench.loop.snapshot()).toMatchObject({ motion: "stop", pose });
  });

  it("ends as collided if it meets a wall, even on the tick on which a condition is true", () => {
    const { bench, deliver } = robot();
    // No reading is smaller than the robot's radius, so this is true only in contact.
    deliver({ action: "forward", until: until(25) });
    bench.pass(20_000);
    expect(bench.story).toEqual(["started 1", "collided 1"]);
    expect(front(bench)).toBeLessThanOrEqual(25);
  });

  it("lets the next command wait for its end, also a stop in the queue and another drive", () => {
    const { bench, deliver } = robot();
    deliver({ action: "drive", left: 0.2, right: 0.2, until: until(front(bench) - 50) });
    deliver({ action: "drive", left: 0.1, right: 0.1, until: until(0) });
    deliver({ action: "drive", left: -0.1, right: -0.1, until: until(10_000) });
    bench.pass(600);
    expect(bench.story).toEqual(["started 1"]);
    bench.pass(800);
    expect(bench.story).toEqual(["started 1", "completed 1", "started 2"]);
  });

  it.each([
    { name: "its sender", cancel: ({ loop }: Bench) => loop.remote?.cancelOne(1) },
    { name: "a stop", cancel: ({ loop }: Bench) => loop.cancelRemote("stopped") },
  ])("is cancelled by $name", ({ cancel }) => {
    const { bench, deliver } = robot();
    deliver({ action: "forward", until: until(0) });
    bench.pass(100);
    cancel(bench);
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
  });

  it("is superseded by a command that replaces", () => {
    const { bench, deliver } = robot();
    deliver({ action: "forward", until: until(0) });
    bench.pass(100);
    deliver(MOVE, { replace: true });
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "superseded 1", "started 2"]);
  });

  it("is not part of a burst of wheel powers: each one runs", () => {
    const { bench, deliver } = robot();
    bench.loop.remote?.reset();
    for (let n = 0; n < 6; n++) {
      deliver({ action: "drive", left: 0.1, right: 0.1, until: until(10_000) });
    }
    bench.pass(200);
    expect(bench.story.filter((each) => each.startsWith("completed"))).toHaveLength(6);
  });

  it.each([
    { name: "forward", command: { action: "forward", until: until(0) } },
    { name: "drive", command: { action: "drive", left: 0.1, right: -0.1, until: until(0) } },
  ] satisfies { name: string; command: RemoteCommand }[])(
    "by $name stops 3 s after the last message of its script",
    ({ command }) => {
      const { bench, deliver } = robot();
      bench.loop.setSpeed(0.25);
      deliver(command);
      bench.pass(2_000);
      bench.loop.remote?.renew([{ driver: "Zx81qP", silentMs: 0, connectionMs: null }]);
      bench.pass(2_900);
      expect(bench.story).toEqual(["started 1"]);
      bench.pass(200);
      expect(bench.story).toEqual(["started 1", "cancelled 1"]);
    },
  );

  it("ends in a goal", () => {
    const { bench, deliver } = robot();
    const { start } = bench.loop.maze;
    bench.loop.editMaze({
      ...bench.loop.maze,
      goals: [{ column: start.column, row: start.row }],
    });
    deliver({ action: "forward", until: [{ goal: true }] });
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
    expect(bench.endings.get(1)).toMatchObject({ distance: 0 });
  });
});

describe("a burst of wheel powers", () => {
  const drive = (left: number): RemoteCommand => ({ action: "drive", left, right: 0.1 });

  it("counts only the newest, between two ticks", () => {
    const { bench, deliver } = robot();
    for (const left of [0.1, 0.2, 0.3]) deliver(drive(left));
    bench.pass(100);
    expect(bench.story).toEqual(["superseded 1", "superseded 2", "started 3"]);
  });

  it("counts only the newest, if more than three arrive within 50 ms", () => {
    const { bench, deliver } = robot();
    for (const left of [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]) {
      deliver(drive(left));
      bench.time += 2;
    }
    bench.pass(40);
    expect(bench.story.filter((received) => received.startsWith("started"))).toEqual([]);
    bench.pass(40);
    expect(bench.story.at(-1)).toBe("started 6");
  });

  it("counts only the newest, if the relay stretches the burst by storing each", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 46; n++) {
      deliver(drive(0.1));
      bench.pass(8);
    }
    bench.pass(100);
    const begun = bench.story.filter((received) => received.startsWith("started"));
    // The first ones are not known to be a burst.
    expect(begun.length).toBeLessThanOrEqual(2);
    expect(begun.at(-1)).toBe("started 46");
  });

  it("counts only the newest, if a slow disk of the relay stretches the burst to a second", () => {
    const { bench, deliver } = robot();
    const acceptedAt = new Date(bench.time).toISOString();
    for (let n = 0; n < 40; n++) {
      deliver(drive(0.1), { acceptedAt });
      bench.pass(n % 4 === 3 ? 64 : 24);
    }
    bench.pass(200);
    const begun = bench.story.filter((received) => received.startsWith("started"));
    // The first ones are not known to be a burst.
    expect(begun.length).toBeLessThanOrEqual(4);
    expect(begun.at(-1)).toBe("started 40");
  });

  it("counts only the newest, if the relay stored the commands one by one while the page was gone", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 20; n++) {
      deliver(drive(0.1), { acceptedAt: new Date(1_000 + n * 200).toISOString() });
      bench.time += 1;
    }
    bench.pass(100);
    const begun = bench.story.filter((received) => received.startsWith("started"));
    expect(begun).toEqual(["started 20"]);
  });

  it("moves the robot under continuous load, too", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 200; n++) {
      deliver(drive(0.1));
      bench.pass(8);
    }
    expect(bench.story.filter((received) => received.startsWith("started")).length).toBeGreaterThan(
      10,
    );
  });

  it.each([
    { name: "the page's own line", begin: (bench: Bench) => bench.loop.remote?.reset() },
    {
      name: "the script's line",
      begin: (bench: Bench) =>
        bench.loop.remote?.renew([{ driver: "Zx81qP", silentMs: 0, connectionMs: 0 }]),
    },
  ])("counts only the last of the first 100 ms of $name", ({ begin }) => {
    const { bench, deliver } = robot();
    begin(bench);
    deliver(drive(0.1));
    bench.pass(56);
    deliver(drive(0.2));
    bench.pass(56);
    expect(bench.story).toEqual(["superseded 1", "started 2"]);
  });

  it("waits for a newer one after long delays, but not repeatedly", () => {
    const { bench, deliver } = robot();
    const wait = { ttl: 10_000, remaining: 8_000 };
    deliver(drive(0.1), wait);
    bench.pass(160);
    deliver(drive(0.2));
    bench.pass(32);
    expect(bench.story).toEqual(["superseded 1", "started 2"]);
    deliver(drive(0.3), wait);
    bench.pass(32);
    expect(bench.story).toEqual(["superseded 1", "started 2", "completed 2", "started 3"]);
  });

  it("does not affect a stop and a manoeuvre", () => {
    const { bench, deliver } = robot();
    bench.loop.remote?.reset();
    deliver({ action: "left 90" });
    bench.pass(30);
    expect(bench.story).toEqual(["started 1"]);
  });
});

describe("a reset by a script", () => {
  const RESET: RemoteCommand = { action: "reset" };

  it("ends all earlier commands, puts the robot at its start and begins a run that Remote drives", () => {
    const { bench, deliver } = robot();
    const start = bench.loop.snapshot().pose;
    const { recording } = bench.loop;
    deliver({ action: "forward" });
    deliver(MOVE);
    bench.pass(500);
    deliver({ action: "turn", degrees: 720 });
    deliver(RESET);
    bench.pass(8);
    expect(bench.story.slice(-4)).toEqual([
      "superseded 2",
      "superseded 3",
      "started 4",
      "completed 4",
    ]);
    expect(bench.endings.get(4)).toEqual({
      state: "completed",
      reason: null,
      pose: start,
      distance: 0,
    });
    expect(bench.loop.recording).not.toBe(recording);
    expect(bench.loop.snapshot()).toMatchObject({
      state: "running",
      driver: "remote",
      pose: start,
      bumps: 0,
      command: null,
    });
    expect(bench.loop.snapshot().tick).toBeLessThan(2);
    deliver(MOVE);
    bench.pass(2_000);
    expect(bench.endings.get(5)).toMatchObject({ state: "completed" });
  });

  it.each(["max", 16, 0.25] as const)(
    "is possible at speed %s, before any other command",
    (speed) => {
      const { bench, deliver } = robot();
      bench.loop.setSpeed(speed);
      deliver(RESET);
      bench.pass(16);
      expect(bench.story).toEqual(["started 1", "completed 1"]);
    },
  );

  it("waits while the robot is paused, and expires like any command", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    bench.pass(2_000);
    bench.loop.pause();
    const { tick } = bench.loop.snapshot();
    deliver(RESET);
    bench.pass(100);
    expect(bench.loop.snapshot()).toMatchObject({ tick, state: "paused" });
    bench.loop.run();
    bench.pass(8);
    expect(bench.endings.get(2)).toMatchObject({ state: "completed" });
    bench.loop.pause();
    deliver(RESET, { remaining: 200 });
    bench.pass(300);
    expect(bench.endings.get(3)).toMatchObject({ state: "expired" });
  });

  it.each(["me", "program"] as const)(
    "is cancelled while %s drives, and the run continues",
    (driver) => {
      const { bench, deliver } = robot();
      bench.loop.setDriver(driver);
      if (driver === "program") bench.loop.run();
      else bench.loop.hold("forward");
      bench.pass(500);
      const { recording } = bench.loop;
      deliver(RESET);
      bench.pass(100);
      expect(bench.endings.get(1)).toMatchObject({ state: "cancelled", reason: "notRemote" });
      expect(bench.loop.recording).toBe(recording);
      expect(bench.loop.snapshot().tick).toBeGreaterThan(30);
    },
  );

  it("is superseded by a later replacement, and taken back with the other queued commands", () => {
    const { bench, deliver } = robot();
    deliver(RESET);
    deliver(MOVE, { replace: true });
    bench.pass(100);
    expect(bench.story).toEqual(["superseded 1", "started 2"]);
    deliver(RESET);
    bench.loop.remote?.reset();
    bench.pass(2_000);
    expect(bench.endings.has(3)).toBe(false);
  });

  it("starts with the newest program, and displays the newest tick again", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    bench.pass(2_000);
    bench.loop.seek(10);
    const edited = { ...firstProgram, rules: firstProgram.rules.slice(1) };
    bench.loop.editProgram(edited);
    deliver(RESET);
    bench.pass(8);
    expect(bench.endings.get(2)).toMatchObject({ state: "completed" });
    expect(bench.frame().view).toBe("now");
    expect(bench.loop.recording.run.program).toEqual(edited);
  });
});
