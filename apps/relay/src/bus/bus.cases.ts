/** Test cases for every implementation of the message bus. */
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it, vi } from "vitest";
import { acquireStep } from "../commands/page-transitions.ts";
import { addStep, deliverStep } from "../commands/state-machine.ts";
import { CarriedSnapshot } from "./carried-snapshot.ts";
import { pageState } from "../store/cases/robot-in-store.ts";
import { sentCommand } from "../store/cases/sent-command.ts";
import type { RobotStore } from "../store/robot-store.ts";
import type { Channel, BusMessage, Bus } from "./bus.ts";

const ID = "AAAAAAAAAAAAAAAAAAAAAA";
const OTHER = "BBBBBBBBBBBBBBBBBBBBBB";
const nothingDone = pageState({ knownEpoch: null });
const scripts = { connected: 1, client: "Python", silentMs: 5, alive: [], scripts: [] };

export interface TestRelay {
  store: RobotStore;
  bus: Bus;
}

/** Subscribes one relay and records all that it receives. */
export async function subscribe({ store, bus }: TestRelay, robot = ID) {
  const steps: string[] = [];
  const received: BusMessage[] = [];
  const missed = vi.fn<() => void>();
  const channel: Channel = await bus.join(robot, {
    commandsChanged: ({ added, changed }, isOwn) => {
      const changes = changed.map(({ seq, state }) => `${seq} ${state}`);
      if (added !== null) changes.unshift(`+${added.record.seq}`);
      steps.push(`${changes.join(", ")}${isOwn ? " (own)" : ""}`);
    },
    missed,
    received: (message) => received.push(message),
  });
  return {
    channel,
    steps,
    received,
    missed,
    add: async () => {
      const result = await store.commit(robot, addStep(sentCommand()));
      if (result.outcome !== "stored") throw new Error(result.outcome);
      const { record, ended } = result;
      const added = { ...sentCommand(), record };
      channel.commandsChanged({ added, ended, changed: ended.map((each) => each.record) });
      return record.seq;
    },
    take: async () => {
      const taken = await store.commit(robot, acquireStep(nothingDone));
      if (taken === null) throw new Error("there is no such robot");
      channel.commandsChanged({ added: null, ended: [], changed: taken.changed });
      channel.notify({ kind: "page", epoch: taken.epoch, name: "page-of-test" });
      return taken.epoch;
    },
    deliver: async (epoch: number) => {
      const due = await store.commit(robot, deliverStep(epoch, 8, sentCommand().acceptedAt));
      const changed = due.map(({ record }) => record);
      channel.commandsChanged({ added: null, ended: [], changed });
    },
  };
}

/** @param open opens two relays with a shared store, which the test closes */
export function busCases(name: string, open: () => Promise<[TestRelay, TestRelay]>): void {
  async function withChannel() {
    const relays = await open();
    for (const id of [ID, OTHER]) {
      await relays[0].store.create({ id, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    }
    const [a, b] = [await subscribe(relays[0]), await subscribe(relays[1])];
    return { relays, a, b };
  }

  describe(`${name}: channels between relays`, () => {
    it("delivers steps to all in the same order, with their origin", async () => {
      const { a, b } = await withChannel();
      const { returnsOwnChanges } = a.channel;
      const received = (steps: string[]): string[] =>
        steps.filter((step) => returnsOwnChanges || !step.endsWith("(own)"));
      await a.add();
      const epoch = await b.take();
      await b.deliver(epoch);
      await a.add();
      await vi.waitFor(() => {
        expect(a.steps).toEqual(received(["+1 (own)", "1 delivered", "+2 (own)"]));
        expect(b.steps).toEqual(received(["+1", "1 delivered (own)", "+2"]));
      });
      expect(a.missed).not.toHaveBeenCalled();
    });

    it("delivers messages to the others, for this robot only", async () => {
      const { relays, a, b } = await withChannel();
      const elsewhere = await subscribe(relays[1], OTHER);
      b.channel.notify({ kind: "here", from: "b", scripts, asks: true });
      await vi.waitFor(() =>
        expect(a.received).toMatchObject([{ kind: "here", scripts, asks: true }]),
      );
      const [announced] = a.received;
      const name = announced?.kind === "here" ? announced.from : "";
      const snapshot = CarriedSnapshot.of(snapshotOf({ seq: 7 }));
      a.channel.sendSnapshot(snapshot, [name]);
      await vi.waitFor(() =>
        expect(b.received).toMatchObject([
          { kind: "snapshot", snapshot: { message: snapshot.message } },
        ]),
      );
      const cancel = { kind: "cancel", seq: 3, cause: "revoked" } as const;
      a.channel.notify(cancel);
      await vi.waitFor(() => expect(b.received.at(-1)).toMatchObject(cancel));
      const maze = { kind: "maze", version: "k3J9x2aBk3J9x2aBk3J9x2" } as const;
      a.channel.notify(maze);
      await vi.waitFor(() => expect(b.received.at(-1)).toMatchObject(maze));
      const cell = { column: 1, row: 3, text: "7", color: "green", walls: "ns" } as const;
      const marks = { fresh: true, pitch: 2, cells: [cell] } as const;
      a.channel.notify({ kind: "marks", marks: { ...marks, cells: [cell] } });
      await vi.waitFor(() => expect(b.received.at(-1)).toMatchObject({ kind: "marks", marks }));
      expect([a.received.length, elsewhere.received]).toEqual([1, []]);
    });

    it("reports which relay owns the page, also to later subscribers, and when it left", async () => {
      const { relays, a, b } = await withChannel();
      const epoch = await a.take();
      await vi.waitFor(() => expect(b.received).toMatchObject([{ kind: "page", epoch }]));
      b.channel.leave();
      const later = await subscribe(relays[1]);
      expect(later.received).toMatchObject([{ kind: "page", epoch }]);
      a.channel.notify({ kind: "page-left", epoch, closedByPage: true });
      await vi.waitFor(() =>
        expect(later.received.at(-1)).toMatchObject({ kind: "page-left", epoch }),
      );
    });

    it("delivers nothing after leaving", async () => {
      const { a, b } = await withChannel();
      b.channel.leave();
      a.channel.notify({ kind: "cancel", seq: 3, cause: "sender" });
      await a.add();
      await a.deliver(await a.take());
      const last = a.channel.returnsOwnChanges ? "1 delivered (own)" : undefined;
      await vi.waitFor(() => expect(a.steps.at(-1)).toBe(last));
      expect([b.received, b.steps]).toEqual([[], []]);
    });
  });
}
