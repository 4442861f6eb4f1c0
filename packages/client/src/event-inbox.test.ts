import { MAX_STORED_EVENTS } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { EventInbox, type RobotEvent } from "./event-inbox.ts";
import { record } from "./testing/messages.ts";

const snapshot = (seq: number): RobotEvent => ({ kind: "snapshot", snapshot: snapshotOf({ seq }) });
const command = (seq: number): RobotEvent => ({
  kind: "command",
  command: record(seq, `key-${seq}`, { action: "stop" }),
});

async function rest(inbox: EventInbox): Promise<RobotEvent[]> {
  inbox.close();
  const events: RobotEvent[] = [];
  for (;;) {
    const event = await inbox.next();
    if (event === null) return events;
    events.push(event);
  }
}

describe("the events of a slow reader", () => {
  it("include every command and the newest snapshot", async () => {
    const inbox = new EventInbox();
    for (const event of [snapshot(1), command(1), snapshot(2), command(2)]) inbox.put(event);
    expect(await rest(inbox)).toEqual([command(1), snapshot(2), command(2)]);
  });

  it("contain a gap if there were too many", async () => {
    const inbox = new EventInbox();
    for (let seq = 1; seq <= MAX_STORED_EVENTS + 1; seq++) inbox.put(command(seq));
    expect(await rest(inbox)).toEqual([{ kind: "gap" }, command(MAX_STORED_EVENTS + 1)]);
  });

  it("arrive immediately", async () => {
    const inbox = new EventInbox();
    const next = inbox.next();
    inbox.put(command(1));
    expect(await next).toEqual(command(1));
  });
});
