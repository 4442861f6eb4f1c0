import { EVENT_RETENTION_MS, MAX_STORED_EVENTS, type CommandRecord } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { CoalescedTimers } from "../../platform/time/coalesced-timers.ts";
import { FakeClock, settled } from "../../platform/testing/fake-clock.ts";
import { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import { EventLog } from "../../platform/events/event-log.ts";
import { limits } from "../../platform/limits/limits.ts";
import { ReaderFeed } from "./feed.ts";
import { recordPacking } from "./packed-record.ts";

function recordOf(seq: number): CommandRecord {
  return {
    seq,
    key: null,
    action: "left 90",
    command: { action: "left 90" },
    state: "started",
    reason: null,
    acceptedAt: "2026-01-01T00:00:00.000Z",
    pose: null,
    distance: null,
    duplicate: false,
  };
}

const STATE_BYTES = 300;

/** A robot with an event log, and readers whose progress the test controls. */
function robotWithReaders() {
  const clock = new FakeClock();
  const timers = new CoalescedTimers(clock);
  const events = new EventLog(clock, recordPacking);
  let newest: CarriedSnapshot | null = null;
  const feeds: ReaderFeed[] = [];
  /** @param received called after each state, as a connection may break during a write */
  const join = (since: string | null = null, received?: (feed: ReaderFeed) => void) => {
    const said: string[] = [];
    const flow = { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined };
    const say = (text: string, bytes: number): void => {
      said.push(text);
      flow.sentBytes += bytes;
    };
    const feed = new ReaderFeed(
      {
        transport: "websocket",
        flow,
        began: ({ n }) => say(`welcome ${n}`, 100),
        snapshot: ({ seq }) => say(`snapshot ${seq}`, 400),
        state: ({ n }) => {
          say(`state ${n}`, STATE_BYTES);
          received?.(feed);
        },
        gap: ({ n, open }) => say(`gap ${n} ${open.map(({ seq }) => seq).join()}`, 200),
        maze: (version) => say(`maze ${version}`, 50),
        over: (reason) => say(reason, 0),
      },
      {
        events,
        newest: () => newest,
        readOpen: async (notify) => notify([{ seq: 5, state: "started" }]),
      },
      { clock, timers },
    );
    feeds.push(feed);
    feed.begin(since);
    const takeAll = (): void => void (flow.takenBytes = flow.sentBytes);
    return { feed, said, flow, takeAll };
  };
  const happen = (count = 1): void => {
    for (let n = 0; n < count; n++) {
      const event = events.add(recordOf(events.n + 1));
      for (const feed of feeds) feed.state(event);
    }
  };
  const report = (seq: number): void => {
    newest = CarriedSnapshot.of(snapshotOf({ seq }));
    for (const feed of feeds) feed.snapshot(newest);
  };
  return { clock, events, join, happen, report };
}

describe("a reader that reconnects", () => {
  it("receives missed events once and in order, and then new ones", () => {
    const { events, join, happen } = robotWithReaders();
    happen(2);
    const since = events.since;
    happen(3);
    const { said } = join(since);
    happen();
    expect(said).toEqual(["welcome 2", "state 3", "state 4", "state 5", "state 6"]);
  });

  it("receives nothing more after its connection broke while it received missed events", () => {
    const { events, join, happen } = robotWithReaders();
    happen(2);
    const since = events.since;
    happen(3);
    const { said } = join(since, (feed) => feed.close());
    expect(said).toEqual(["welcome 2", "state 3"]);
  });

  it("receives no earlier events if it is new", () => {
    const { join, happen } = robotWithReaders();
    happen(2);
    const { said } = join();
    happen();
    expect(said).toEqual(["welcome 2", "state 3"]);
  });

  it.each([
    { name: "of more states than are stored", after: MAX_STORED_EVENTS + 1, ms: 0 },
    { name: "of states that are too old", after: 1, ms: EVENT_RETENTION_MS + 1 },
  ])("receives one gap in place $name", async ({ after, ms }) => {
    const { clock, events, join, happen, report } = robotWithReaders();
    happen(3);
    report(7);
    const since = events.since;
    happen(after);
    await clock.pass(ms);
    events.deleteOld();
    const { said } = join(since);
    happen();
    await clock.pass(1_000);
    happen();
    const n = 3 + after;
    const states = [`state ${n + 1}`, `state ${n + 2}`];
    expect(said).toEqual(["welcome null", `gap ${n} 5`, "snapshot 7", ...states]);
  });

  it.each(["00000000-1", "00000000-0", "zzzzzzzz-99999"])(
    "gets a gap when it comes with the numbers of another relay: %s",
    async (since) => {
      const { join, happen } = robotWithReaders();
      happen(2);
      const { said } = join(since);
      await settled();
      expect(said).toEqual(["welcome null", "gap 2 5"]);
    },
  );

  it("receives a gap if its position is in the future", async () => {
    const { events, join, happen } = robotWithReaders();
    happen(2);
    const { said } = join(`${events.stream}-3`);
    await settled();
    expect(said).toEqual(["welcome null", "gap 2 5"]);
  });
});

describe("a fast reader", () => {
  it("receives the newest snapshot 20 times a second from a robot that reports more often", async () => {
    const { clock, join, report } = robotWithReaders();
    const { feed, said } = join();
    for (let seq = 1; seq <= 300; seq++) {
      report(seq);
      feed.seen(seq);
      await clock.pass(33);
    }
    const seconds = (300 * 33) / 1_000;
    const snapshots = said.filter((text) => text.startsWith("snapshot"));
    expect(Math.abs(snapshots.length - 20 * seconds)).toBeLessThanOrEqual(2);
    expect(snapshots.at(-1)).toMatch(/ (299|300)$/);
  });

  it("receives 20 snapshots a second again right after endings have added more", async () => {
    const { clock, join, report, happen } = robotWithReaders();
    const { feed, said } = join();
    let seq = 0;
    const drive = async (ms: number, isBusy: boolean): Promise<number> => {
      const before = said.length;
      for (let passed = 0; passed < ms; passed += 25) {
        report(++seq);
        if (isBusy) happen();
        feed.seen(seq);
        await clock.pass(25);
      }
      return said.slice(before).filter((text) => text.startsWith("snapshot")).length;
    };
    expect(await drive(10_000, true)).toBeGreaterThan(300);
    expect(await drive(1_000, false)).toBeGreaterThanOrEqual(19);
  });

  it("continues when the numbers of its robot's snapshots decrease", async () => {
    const { clock, join, report } = robotWithReaders();
    const { feed, said } = join();
    for (const seq of [1_000, 5, 6, 7, 8]) {
      report(seq);
      if (seq !== 1_000) feed.seen(seq);
      await clock.pass(limits.snapshotIntervalMs);
    }
    expect(said.slice(1)).toEqual([1_000, 5, 6, 7, 8].map((seq) => `snapshot ${seq}`));
  });

  it("receives the newest snapshot as soon as it confirms the previous one, at any latency", async () => {
    const { clock, join, report } = robotWithReaders();
    const { feed, said } = join();
    for (const seq of [1, 2, 3]) {
      report(seq);
      await clock.pass(limits.snapshotIntervalMs);
    }
    expect(said.slice(1)).toEqual(["snapshot 1", "snapshot 2"]);
    await clock.pass(12);
    feed.seen(1);
    expect(said.slice(1)).toEqual(["snapshot 1", "snapshot 2", "snapshot 3"]);
  });
});

describe("a reader that stops reading", () => {
  it("has at most two unconfirmed snapshots, and then receives the newest", async () => {
    const { clock, join, report } = robotWithReaders();
    const { said, takeAll } = join();
    for (let seq = 1; seq <= 100; seq++) {
      report(seq);
      await clock.pass(limits.snapshotIntervalMs);
    }
    expect(said).toEqual(["welcome 0", "snapshot 1", "snapshot 2"]);
    takeAll();
    await clock.pass(limits.snapshotIntervalMs);
    expect(said.slice(3)).toEqual(["snapshot 100"]);
  });

  it("is measured by its own confirmations from the first one on, not by its connection", async () => {
    const { clock, join, report } = robotWithReaders();
    const { feed, said, takeAll } = join();
    report(1);
    feed.seen(1);
    for (let seq = 2; seq <= 9; seq++) {
      report(seq);
      takeAll();
      await clock.pass(limits.snapshotIntervalMs);
    }
    expect(said.slice(1)).toEqual(["snapshot 1", "snapshot 2", "snapshot 3"]);
    feed.seen(2);
    await clock.pass(limits.snapshotIntervalMs);
    expect(said.slice(4)).toEqual(["snapshot 9"]);
  });

  it("receives missed states in order, while few of them are buffered on its connection", async () => {
    const { clock, join, happen } = robotWithReaders();
    const { said, flow, takeAll } = join();
    happen(900);
    await clock.pass(60_000);
    expect(flow.sentBytes).toBeLessThan(64 * 1024);
    for (let tries = 0; tries < 20; tries++) {
      takeAll();
      await clock.pass(limits.snapshotIntervalMs);
    }
    expect(said.slice(1)).toEqual(
      Array.from({ length: 900 }, (_none, index) => `state ${index + 1}`),
    );
  });

  it("receives a gap if it missed more events than are stored", async () => {
    const { clock, join, happen } = robotWithReaders();
    const { said, takeAll } = join();
    happen(5_000);
    takeAll();
    await clock.pass(limits.snapshotIntervalMs);
    happen();
    expect(said.slice(-2)).toEqual(["gap 5000 5", "state 5001"]);
    expect(said.filter((text) => text.startsWith("gap"))).toHaveLength(1);
  });
});
