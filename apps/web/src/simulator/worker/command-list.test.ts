import { describe, expect, it } from "vitest";
import { CommandList } from "./command-list.ts";
import { deliveryOf } from "./testing/bench.ts";

function listOf(...seqs: number[]): CommandList {
  const list = new CommandList();
  for (const seq of seqs) list.deliver(deliveryOf(seq, { action: "stop" }));
  return list;
}

const states = (list: CommandList) => list.toArray().map(({ seq, state }) => [seq, state]);

describe("the list of commands", () => {
  it("shows the newest first, whatever their order of arrival", () => {
    expect(states(listOf(2, 3, 1))).toEqual([
      [3, "delivered"],
      [2, "delivered"],
      [1, "delivered"],
    ]);
  });

  it("keeps the newest 100", () => {
    const list = listOf(...Array.from({ length: 101 }, (_, at) => at + 1));
    expect(list.toArray()).toHaveLength(100);
    expect(list.get(1)).toBeUndefined();
    expect(list.newestSeq).toBe(101);
  });

  it("retains commands that have not ended when the user clears it", () => {
    const list = listOf(1, 2, 3, 4);
    list.change(1, { state: "completed" });
    list.change(2, { state: "cancelled" });
    list.change(3, { state: "started" });
    list.removeEnded();
    expect(states(list)).toEqual([
      [4, "delivered"],
      [3, "started"],
    ]);
  });

  it("shows commands that the robot has not started as queued after a reconnect", () => {
    const list = listOf(1, 2);
    list.change(1, { state: "started" });
    list.returnDelivered();
    expect(states(list)).toEqual([
      [2, "accepted"],
      [1, "started"],
    ]);
  });

  it("ignores a change of a command that it does not list", () => {
    const list = listOf(1);
    list.change(2, { state: "completed" });
    expect(states(list)).toEqual([[1, "delivered"]]);
    expect(list.newestSeq).toBe(1);
    list.clear();
    expect(list.newestSeq).toBe(0);
  });
});
