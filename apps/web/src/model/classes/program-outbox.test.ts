import { describe, expect, it } from "vitest";
import type { ClassReport, ClassStudent } from "../../simulator/protocol/class-messages.ts";
import { ProgramOutbox } from "./program-outbox.ts";

/** A page's outbox, and a relay that the test controls. */
function newOutbox() {
  let time = 0;
  const timers = new Set<{ at: number; call: () => void }>();
  const sent: ClassReport[] = [];
  const outbox = new ProgramOutbox({
    send: (report) => sent.push(report),
    now: () => time,
    later: (call, ms) => {
      const timer = { at: time + ms, call };
      timers.add(timer);
      return () => void timers.delete(timer);
    },
  });
  const follow = (kind: "connected" | "lost", program: number): void => {
    const student = { stored: { progress: 0, program } } as ClassStudent;
    outbox.follow({ status: { kind }, student });
  };
  return {
    outbox,
    links: () => sent.map((report) => (report.type === "program" ? report.link : "")),
    connect: () => follow("connected", 0),
    stored: (seq: number) => follow("connected", seq),
    lose: () => follow("lost", 0),
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

describe("the newest program of a student", () => {
  it("is sent until the relay has stored it", () => {
    const { outbox, links, connect, stored, wait } = newOutbox();
    outbox.set(1, "a");
    expect(links()).toEqual([]);
    connect();
    wait(7_000);
    expect(links()).toEqual(["a", "a"]);
    stored(1);
    wait(20_000);
    expect(links()).toEqual(["a", "a"]);
  });

  it("replaces an older one, and is not sent twice if nothing has changed", () => {
    const { outbox, links, connect, stored, wait } = newOutbox();
    connect();
    outbox.set(1, "a");
    outbox.set(1, "b");
    stored(2);
    outbox.set(1, "b");
    wait(20_000);
    expect(links()).toEqual(["a", "b"]);
  });

  it("is sent again after a lost connection if the relay did not confirm it", () => {
    const { outbox, links, connect, lose } = newOutbox();
    connect();
    outbox.set(1, "a");
    lose();
    connect();
    expect(links()).toEqual(["a", "a"]);
  });
});
