import { describe, expect, it } from "vitest";
import { createWorkspaceStore } from "../stores/workspace-store.ts";
import { RunLoader } from "../worker/run-loader.ts";
import { RunLoop } from "../worker/run-loop.ts";
import type { FromWorker, ToWorker } from "../worker/worker-messages.ts";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { readKeptRun } from "./read-kept-run.ts";
import { RunKeeper } from "./run-keeper.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";

/** A page with the real run behind it, in a tab whose storage may be that of a page before it. */
function openPage(
  tab = new MemoryStorage(),
  maze = firstMaze,
  loadReader = () => Promise.resolve(readKeptRun),
) {
  let time = 0;
  const listeners = new Set<(message: FromWorker) => void>();
  const timers: (() => void)[] = [];
  const lost: string[] = [];
  const loop = new RunLoop(maze, firstProgram, () => time);
  const post = (message: FromWorker) => {
    for (const listener of listeners) listener(message);
  };
  const tellNews = () => {
    const news = loop.takeNews();
    if (news === null) return;
    const after = news.forgottenAfter;
    if (after !== null) post({ type: "forgotten", after });
    post({ type: "frame", frame: news.frame, timeline: null });
  };
  /** a slice of a long run takes all its time */
  let isSlow = false;
  let slowTime = 0;
  const slices: (() => void)[] = [];
  const loader = new RunLoader({
    now: () => (isSlow ? (slowTime += 10) : time),
    later: () => void slices.push(() => loader.goOn()),
    post,
    open: (recording) => loop.open(recording),
  });
  const send = (message: ToWorker) => {
    if (message.type === "save-run") {
      const written = loop.saveRun();
      const saved = written.ok
        ? { ok: true as const, text: written.text, ticks: written.run.ticks }
        : written;
      post({ type: "run-saved", id: message.id, saved });
    }
    if (message.type === "edit-program") loop.editProgram(message.program);
    if (message.type === "cancel-load") loader.cancel(message.id);
    if (message.type === "load-run") loader.load(message);
    tellNews();
  };
  const workspace = createWorkspaceStore(maze, firstProgram);
  const keeper = new RunKeeper({
    simulator: {
      send,
      isGone: false,
      listen: (listener) => {
        listeners.add(listener);
        return () => listeners.delete(listener);
      },
    },
    workspace,
    tab,
    later: (run) => void timers.push(run),
    loadReader,
    onLost: () => void lost.push("lost"),
  });
  const pass = (milliseconds: number) => {
    for (const end = time + milliseconds; time < end;) {
      time += 8;
      loop.advance();
      tellNews();
    }
  };
  const ring = () => {
    for (const timer of timers.splice(0)) timer();
  };
  const beSlow = () => void (isSlow = true);
  const slice = () => slices.shift()?.();
  tellNews();
  return { loop, keeper, tab, workspace, pass, ring, lost, tellNews, beSlow, slice };
}

describe("a run over a reload", () => {
  it("comes back paused at the same tick and goes on as it would have", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(4000);
    page.keeper.flush();
    const before = page.loop.snapshot();
    const reloaded = openPage(page.tab);
    await reloaded.keeper.resume();
    expect(reloaded.loop.snapshot()).toMatchObject({
      tick: before.tick,
      pose: before.pose,
      state: "paused",
    });
    for (const each of [page, reloaded]) {
      each.loop.pause();
      each.loop.run();
      each.pass(3000);
    }
    expect(reloaded.loop.snapshot().pose).toEqual(page.loop.snapshot().pose);
  });

  it("has the edits and the hand's driving of before", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(500);
    page.loop.hold("left");
    page.pass(300);
    page.loop.hold("stop");
    page.tellNews();
    page.ring();
    page.keeper.flush();
    const reloaded = openPage(page.tab);
    await reloaded.keeper.resume();
    const { tick, pose, driver } = page.loop.snapshot();
    expect(reloaded.loop.snapshot()).toMatchObject({ tick, pose, driver });
  });

  it("loses at most what came after the inputs that the page knew of", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(1000);
    page.loop.hold("left");
    page.pass(100);
    // The page was not told the hand's input yet: no timer has rung.
    page.keeper.flush();
    const reloaded = openPage(page.tab);
    await reloaded.keeper.resume();
    expect(reloaded.lost).toEqual([]);
    expect(reloaded.loop.snapshot().tick).toBeLessThanOrEqual(60);
  });

  it.each([
    { name: "Reset and Run", begin: (loop: RunLoop) => loop.reset() },
    { name: "Run from an earlier moment", begin: (loop: RunLoop) => loop.seek(6) },
  ])("is the new one right after $name, never the one before", async ({ begin }) => {
    const page = openPage();
    page.loop.run();
    page.pass(1000);
    page.loop.hold("left");
    page.pass(1000);
    page.ring();
    // No timer rings from here on: all of it comes sooner.
    begin(page.loop);
    page.tellNews();
    page.loop.run();
    page.pass(80);
    page.keeper.flush();
    const reloaded = openPage(page.tab);
    await reloaded.keeper.resume();
    expect(page.loop.snapshot().tick).toBeLessThan(15);
    expect(reloaded.loop.snapshot().tick).toBeLessThanOrEqual(page.loop.snapshot().tick);
    expect(reloaded.lost).toEqual([]);
  });

  it("is forgotten where another maze is open now, or the robot drives already", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(1000);
    page.keeper.flush();
    const kept = page.tab.getItem("corridor.run") ?? "";
    const other = openPage(page.tab, { ...firstMaze, name: "another" });
    await other.keeper.resume();
    expect(other.loop.snapshot().tick).toBe(0);
    page.tab.setItem("corridor.run", kept);
    const eager = openPage(page.tab);
    eager.loop.run();
    eager.pass(100);
    await eager.keeper.resume();
    expect(eager.loop.snapshot().tick).toBeLessThan(10);
    expect([...other.lost, ...eager.lost]).toEqual([]);
  });

  it("is not waited for by who drives already while a long one is brought back", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(20_000);
    page.keeper.flush();
    const reloaded = openPage(page.tab);
    reloaded.beSlow();
    const resumed = reloaded.keeper.resume();
    await Promise.resolve();
    await Promise.resolve();
    reloaded.slice();
    reloaded.loop.run();
    reloaded.pass(500);
    await resumed;
    expect(reloaded.lost).toEqual([]);
    expect(reloaded.loop.snapshot().tick).toBeLessThan(40);
    expect(reloaded.loop.isRunning).toBe(true);
  });

  it("is still there for the next page when this one goes before it was brought back", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(2000);
    page.keeper.flush();
    const hasty = openPage(page.tab);
    hasty.keeper.flush();
    const reloaded = openPage(page.tab);
    await reloaded.keeper.resume();
    expect(reloaded.loop.snapshot().tick).toBe(page.loop.snapshot().tick);
  });

  it("is told to be lost when the file that reads it does not come", async () => {
    const page = openPage();
    page.loop.run();
    page.pass(1000);
    page.keeper.flush();
    const offline = openPage(page.tab, firstMaze, () => Promise.reject(new Error("no network")));
    await offline.keeper.resume();
    expect(offline.lost).toEqual(["lost"]);
  });

  it("that stands at its start leaves nothing behind", () => {
    const page = openPage();
    page.keeper.flush();
    expect(page.tab.length).toBe(0);
  });

  it.each([
    { name: "does not fit into the tab's storage", spoil: (text: string) => text, isFull: true },
    {
      name: "was written by another version",
      spoil: (text: string) => text.replace("corridor/run", "x"),
      isFull: false,
    },
    {
      name: "ends in other bits here",
      spoil: (text: string) => text.replace(/"digest":"....../, '"digest":"000000'),
      isFull: false,
    },
  ])("is told to be lost when it $name", async ({ spoil, isFull }) => {
    const page = openPage();
    page.loop.run();
    page.pass(1000);
    const { tab } = page;
    const set = tab.setItem.bind(tab);
    if (isFull) {
      tab.setItem = (key, value) => {
        if (value.length > 100) throw new DOMException("full", "QuotaExceededError");
        set(key, value);
      };
    }
    page.keeper.flush();
    set("corridor.run", spoil(tab.getItem("corridor.run") ?? ""));
    const reloaded = openPage(tab);
    await reloaded.keeper.resume();
    expect(reloaded.lost).toEqual(["lost"]);
    expect(reloaded.loop.snapshot().tick).toBe(0);
  });
});
