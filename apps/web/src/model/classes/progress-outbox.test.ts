import type { Progress } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ClassSession, ClassStudent } from "../../simulator/protocol/class-messages.ts";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { ProgressOutbox } from "./progress-outbox.ts";

const records: Progress[] = [1, 2, 3].map((task) => ({
  kind: "opened",
  lesson: "0a1b2c3d4",
  task,
}));

/** A page's outbox, and a relay that the test controls. */
function newOutbox(tab = new VolatileStorage()) {
  let time = 0;
  const timers = new Set<{ at: number; call: () => void }>();
  const sent: { seq: number; event: Progress }[] = [];
  const outbox = new ProgressOutbox({
    tab,
    send: (report) => {
      if (report.type === "progress") sent.push({ seq: report.seq, event: report.event });
    },
    now: () => time,
    later: (call, ms) => {
      const timer = { at: time + ms, call };
      timers.add(timer);
      return () => void timers.delete(timer);
    },
  });
  const follow = (kind: "connected" | "lost", progress = 0): void => {
    const student = { stored: { progress, program: 0 } } as ClassStudent;
    outbox.follow({ status: { kind }, student } satisfies ClassSession);
  };
  return {
    tab,
    outbox,
    sent,
    numbers: () => sent.map(({ seq }) => seq),
    connect: (progress: number) => follow("connected", progress),
    stored: (progress: number) => follow("connected", progress),
    lose: () => follow("lost"),
    wait: (ms: number): void => {
      for (const end = time + ms; time < end; time += 100) {
        for (const timer of [...timers].filter(({ at }) => at <= time)) {
          timers.delete(timer);
          timer.call();
        }
      }
    },
  };
}

describe("progress that is not stored yet", () => {
  it("is sent in order, one record after the other", () => {
    const { outbox, sent, connect, stored } = newOutbox();
    for (const record of records) outbox.add(record);
    expect(sent).toEqual([]);
    connect(0);
    stored(1);
    stored(2);
    stored(3);
    expect(sent).toEqual(records.map((event, at) => ({ seq: at + 1, event })));
  });

  it("waits for the answer, and is repeated without one", () => {
    const { outbox, numbers, connect, wait } = newOutbox();
    for (const record of records) outbox.add(record);
    connect(0);
    expect(numbers()).toEqual([1]);
    wait(7_000);
    expect(numbers()).toEqual([1, 1]);
  });

  it("is sent at most once in two seconds after a burst", () => {
    const { outbox, numbers, connect, stored, wait } = newOutbox();
    connect(0);
    for (let seq = 1; seq <= 5; seq++) {
      outbox.add({ kind: "opened", lesson: "0a1b2c3d4", task: 1 });
      stored(seq);
    }
    outbox.add({ kind: "opened", lesson: "0a1b2c3d4", task: 1 });
    expect(numbers()).toHaveLength(5);
    wait(2_300);
    expect(numbers()).toHaveLength(6);
  });

  it("survives a reload, and is not sent again if the relay has it", () => {
    const before = newOutbox();
    for (const record of records) before.outbox.add(record);
    before.connect(0);
    const { sent, connect, stored } = newOutbox(before.tab);
    // The answer did not arrive before the reload.
    connect(1);
    stored(2);
    stored(3);
    expect(sent).toEqual([
      { seq: 2, event: records[1] },
      { seq: 3, event: records[2] },
    ]);
    expect(newOutbox(before.tab).numbers()).toEqual([]);
  });

  it("survives a lost connection", () => {
    const { outbox, numbers, connect, stored, lose } = newOutbox();
    for (const record of records) outbox.add(record);
    connect(0);
    lose();
    connect(0);
    stored(1);
    expect(numbers()).toEqual([1, 1, 2]);
  });

  it("continues after what another device of the student has sent", () => {
    const { outbox, sent, connect } = newOutbox();
    outbox.add({ kind: "opened", lesson: "0a1b2c3d4", task: 1 });
    connect(12);
    expect(sent).toEqual([{ seq: 13, event: { kind: "opened", lesson: "0a1b2c3d4", task: 1 } }]);
  });

  it("does not wait for a record that the relay would reject", () => {
    const { outbox, numbers, connect } = newOutbox();
    connect(0);
    outbox.add({ kind: "hint", task: 1, hint: 99 });
    expect(numbers()).toEqual([]);
    outbox.add({ kind: "hint", task: 1, hint: 1 });
    expect(numbers()).toEqual([1]);
  });

  it("begins anew if the tab stores something unreadable", () => {
    const tab = new VolatileStorage();
    tab.setItem("corridor.class.progress", '{"first":1,"isSent":true,"records":[{"kind":"x"}]}');
    const { outbox, numbers, connect } = newOutbox(tab);
    outbox.add({ kind: "opened", lesson: "0a1b2c3d4", task: 1 });
    connect(0);
    expect(numbers()).toEqual([1]);
  });
});
