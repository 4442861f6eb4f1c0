import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import type { RunLoop } from "../../simulator/worker/run-loop.ts";
import { MemoryWorldStore } from "../../simulator/worker/testing/memory-world-store.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { openPage, settle } from "./testing/restorable-page.ts";

describe("a run over a reload", () => {
  it("is restored paused, at most a quarter of a second before the reload", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(4_000);
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    const { tick, pose, state } = reloaded.loop.snapshot();
    expect(state).toBe("paused");
    expect(page.loop.snapshot().tick - tick).toBeLessThanOrEqual(16);
    const again = page.loop.recording.playback();
    again.seek(tick);
    expect(pose).toEqual(again.run.pose);
  });

  it("restores a paused robot bit for bit, including earlier driving by hand", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(500);
    page.loop.hold("left");
    await page.pass(300);
    page.loop.hold("stop");
    await page.pass(300);
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    const { tick, pose, driver } = page.loop.snapshot();
    expect(reloaded.loop.snapshot()).toMatchObject({ tick, pose, driver });
    for (const each of [page, reloaded]) {
      each.loop.run();
      await each.pass(1_000);
    }
    expect(reloaded.loop.snapshot().pose).toEqual(page.loop.snapshot().pose);
  });

  it("contains everything up to an ending that was sent, and how its commands ended", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(100);
    page.of.journal = { robot: "AAAA", lastApplied: 7, endings: [], running: null };
    await page.worlds.save();
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().pose).toEqual(page.loop.snapshot().pose);
    expect(reloaded.of.restored).toEqual(page.of.journal);
  });

  it("ends the running command where the restored robot stands", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    page.loop.pause();
    const running = { seq: 8, distance: 20 };
    page.of.journal = { robot: "AAAA", lastApplied: 8, endings: [], running };
    await page.worlds.save();
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    const { pose } = page.loop.snapshot();
    const distance = page.loop.recording.run.distance - 20;
    const reason = "The robot's page was reloaded and ended this command. Send a new command.";
    expect(distance).toBeGreaterThan(0);
    expect(reloaded.of.restored).toMatchObject({
      running: null,
      endings: [{ seq: 8, state: "cancelled", reason, pose, distance }],
    });
  });

  it("is written once for all concurrent requests", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(100);
    const before = page.store.writes;
    const saves = Array.from({ length: 50 }, () => page.worlds.save());
    await Promise.all(saves);
    expect(page.store.writes - before).toBeLessThanOrEqual(2);
  });

  it("belongs to the other page if a tab was duplicated, and this one stores another", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    const tab = new MemoryStorage();
    tab.setItem("corridor.run", page.tab.getItem("corridor.run") ?? "");
    const double = openPage({ tab, store: page.store });
    await double.restorer.resume();
    expect(double.loop.snapshot().tick).toBeGreaterThan(0);
    // This page's later changes are not stored there.
    await page.worlds.save();
    expect(page.lost).toEqual(["claimed"]);
    await page.pass(300);
    expect(page.tab.getItem("corridor.run")).not.toBe(tab.getItem("corridor.run"));
    await page.worlds.save();
    expect(page.lost).toEqual(["claimed"]);
  });

  it("reports to a page that its world was claimed before it sends the next ending", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    await page.store.claim(page.tab.getItem("corridor.run") ?? "", "another page");
    // No request depends on this write, which stores the progress of the run.
    await page.pass(300);
    expect(page.lost).toEqual(["claimed"]);
    // This page has its own world from now on.
    await page.pass(300);
    await page.worlds.save();
    expect(page.lost).toEqual(["claimed"]);
    expect(page.store.worlds.size).toBe(2);
  });

  it.each([
    { name: "Reset", begin: (loop: RunLoop) => loop.reset() },
    { name: "Reset and Run", begin: (loop: RunLoop) => (loop.reset(), loop.run()) },
    { name: "Run from an earlier moment", begin: (loop: RunLoop) => (loop.seek(6), loop.run()) },
  ])("is the new one right after $name, never the one before", async ({ begin }) => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    page.loop.hold("left");
    await page.pass(1_000);
    begin(page.loop);
    await page.pass(300);
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(page.loop.snapshot().tick).toBeLessThan(30);
    expect(reloaded.loop.snapshot().tick).toBeLessThanOrEqual(page.loop.snapshot().tick);
    expect(reloaded.lost).toEqual([]);
  });

  it.each([
    { name: "of the same project", maze: firstMaze },
    { name: "of a project that was opened", maze: { ...firstMaze, name: "another" } },
  ])("starts at the start if a run $name was just reset", async ({ maze }) => {
    const page = openPage();
    await page.restorer.resume();
    page.loop.run();
    // The reset follows a write by less than the interval of writes.
    await page.pass(1_100);
    page.workspace.setState({ maze });
    page.loop.editMaze(maze);
    page.loop.reset();
    await page.pass(8);
    page.restorer.flush();
    const reloaded = openPage(page, maze);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBe(0);
    expect(reloaded.lost).toEqual([]);
  });

  it.each([
    { name: "was hidden at the start, drove on, and ended without a notice", isHidden: true },
    { name: "was too busy to display that the robot had left its start", isHidden: false },
  ])("is restored if the page $name", async ({ isHidden }) => {
    const page = openPage();
    await page.restorer.resume();
    page.loop.run();
    await page.pass(1_000);
    page.loop.reset();
    await page.pass(300);
    if (isHidden) page.restorer.flush();
    else page.beBusy();
    page.loop.run();
    await page.pass(1_000);
    if (!isHidden) page.restorer.flush();
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBeGreaterThan(0);
  });

  it("is restored again if the page is left right after it was restored", async () => {
    const page = openPage();
    await page.restorer.resume();
    page.loop.run();
    await page.pass(1_000);
    page.restorer.flush();
    const hasty = openPage(page);
    await hasty.restorer.resume();
    hasty.restorer.flush();
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBeGreaterThan(0);
  });

  it("has the latest edits if the page had time to store them", async () => {
    const page = openPage();
    await page.restorer.resume();
    page.loop.run();
    await page.pass(1_000);
    const program = { ...firstProgram, default: "stop" as const };
    page.workspace.setState({ program });
    page.restorer.flush();
    const reloaded = openPage(page);
    reloaded.workspace.setState({ program });
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBeGreaterThan(0);
    expect(reloaded.loop.recording.run.program).toEqual(program);
  });

  it("is not restored if another maze is open now, or the robot drives already", async () => {
    const page = openPage();
    await page.restorer.resume();
    page.loop.run();
    await page.pass(1_000);
    page.restorer.flush();
    const other = openPage(page, { ...firstMaze, name: "another" });
    await other.restorer.resume();
    expect(other.loop.snapshot().tick).toBe(0);
    const eager = openPage(page);
    eager.loop.run();
    await eager.pass(100);
    await eager.restorer.resume();
    expect(eager.loop.snapshot().tick).toBeLessThan(10);
    expect([...other.lost, ...eager.lost]).toEqual([]);
  });

  it.each([
    { when: "before", runsFirst: true },
    { when: "while", runsFirst: false },
  ])("does not stop a user who pressed Run $when it is restored", async ({ runsFirst }) => {
    const page = openPage();
    page.loop.run();
    await page.pass(20_000);
    const reloaded = openPage(page);
    reloaded.beSlow();
    if (runsFirst) reloaded.loop.run();
    const resumed = reloaded.restorer.resume();
    await settle();
    if (!runsFirst) reloaded.loop.run();
    // No tick passes meanwhile.
    while (reloaded.slice()) await settle();
    await resumed;
    expect(reloaded.lost).toEqual([]);
    expect(reloaded.loop.isRunning).toBe(true);
    expect(reloaded.loop.snapshot().tick).toBe(0);
  });

  it("does not delay a user who drives while a long one is restored", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(20_000);
    const reloaded = openPage(page);
    reloaded.beSlow();
    const resumed = reloaded.restorer.resume();
    await settle();
    reloaded.slice();
    reloaded.loop.run();
    await reloaded.pass(500);
    await resumed;
    expect(reloaded.lost).toEqual([]);
    expect(reloaded.loop.snapshot().tick).toBeLessThan(40);
    expect(reloaded.loop.isRunning).toBe(true);
  });

  it("is still available to the next page if this one closes before it is restored", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(20_000);
    page.loop.pause();
    await page.pass(300);
    const hasty = openPage(page);
    hasty.beSlow();
    void hasty.restorer.resume();
    await settle();
    await hasty.pass(1_000);
    hasty.restorer.flush();
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBe(page.loop.snapshot().tick);
  });

  it("leaves nothing behind while it stands at its start", async () => {
    const page = openPage();
    await page.restorer.resume();
    await page.pass(500);
    page.restorer.flush();
    expect(page.tab.length).toBe(0);
    expect(page.store.worlds.size).toBe(0);
  });

  it.each([
    {
      name: "was written by another version",
      corrupt: (world: Record<string, unknown>) => (world["inputs"] = [{ tick: 0, do: "dance" }]),
    },
    {
      name: "ends in other bits here",
      corrupt: (world: Record<string, unknown>) => (world["digest"] = "0000000000000000"),
    },
  ])("is reported as lost if it $name", async ({ corrupt }) => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    for (const world of page.store.worlds.values()) corrupt(world as never);
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.lost).toEqual(["lost"]);
    expect(reloaded.loop.snapshot().tick).toBe(0);
  });
});

describe("a device that cannot store a run", () => {
  it("is reported once, endings wait for nothing, and a reload starts at the start", async () => {
    const page = openPage();
    page.loop.run();
    await page.pass(1_000);
    page.store.isFull = true;
    await page.pass(1_000);
    await page.worlds.save();
    expect(page.lost).toEqual(["not stored"]);
    // An older state of the world would contradict messages sent since.
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBe(0);
    page.loop.reset();
    page.loop.run();
    await page.pass(1_000);
    expect(page.lost).toEqual(["not stored"]);
  });

  it("stores the next run again once there is room", async () => {
    const page = openPage();
    page.store.isFull = true;
    page.loop.run();
    await page.pass(1_000);
    page.store.isFull = false;
    page.loop.reset();
    page.loop.run();
    await page.pass(1_000);
    const reloaded = openPage(page);
    await reloaded.restorer.resume();
    expect(reloaded.loop.snapshot().tick).toBeGreaterThan(0);
  });

  it("includes one whose tab refuses writes", async () => {
    const tab = new MemoryStorage();
    tab.setItem = () => {
      throw new DOMException("forbidden", "SecurityError");
    };
    const page = openPage({ tab, store: new MemoryWorldStore() });
    page.loop.run();
    await page.pass(1_000);
    await page.worlds.save();
    expect(page.lost).toEqual(["not stored"]);
    expect(page.store.writes).toBe(0);
  });
});
