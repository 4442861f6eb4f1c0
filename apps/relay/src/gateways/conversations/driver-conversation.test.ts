/** A script whose commands wait for a slow store. */
import { decodeFrame, relayToDriverSchema, type RelayToDriver } from "@corridor/protocol";
import { expect, it } from "vitest";
import {
  RightsVersion,
  callerOf,
  unknownScript,
  type Caller,
} from "../../robots/access/callers.ts";
import type { Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import type { Robot } from "../../robots/robot.ts";
import { DriverConversation } from "./driver-conversation.ts";

function withSlowStore() {
  const waiting: (() => void)[] = [];
  const sent: RelayToDriver[] = [];
  const closed: number[] = [];
  const refused: string[] = [];
  const caller = callerOf({ kind: "drive", hash: "d" }, unknownScript);
  const robot = {
    check: () => undefined,
    spoke: () => undefined,
    rights: new RightsVersion(),
    readers: { join: () => ({ seen: () => undefined, leave: () => undefined }) },
    refused: (_caller: Caller, error: Refusal) => void refused.push(error.problem.detail),
    submit: async () => new Promise<void>((resolve) => void waiting.push(resolve)),
  };
  const conversation = new DriverConversation({
    // oxlint-disable-next-line typescript/consistent-type-assertions -- the part of a robot that a conversation uses
    grant: { robot: robot as unknown as Robot, caller },
    connection: {
      transport: "websocket",
      flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
      send: (...texts) => {
        for (const text of texts) {
          const message = decodeFrame(relayToDriverSchema, text);
          if (message.ok) sent.push(message.value);
        }
      },
      sendSnapshot: () => undefined,
      close: (code) => void closed.push(code),
      isOpen: true,
      waitingBytes: 0,
    },
    since: null,
    sentAt: undefined,
    clock: new FakeClock(),
    onRefusal: () => undefined,
  });
  const send = (count: number, action = "left 90"): void => {
    const message = Buffer.from(JSON.stringify({ type: "command", command: { action } }));
    for (let n = 0; n < count; n++) void conversation.received(message);
  };
  const turn = (): Promise<void> => new Promise((resolve) => void setImmediate(resolve));
  const problems = (): string[] =>
    sent.flatMap((message) => (message.type === "problem" ? [message.problem.type] : []));
  const say = (text: string): void => void conversation.received(Buffer.from(text));
  return { say, send, sent, waiting, problems, refused, closed, turn };
}

it("accepts 64 commands ahead, repeatedly", async () => {
  const { send, problems, turn, waiting } = withSlowStore();
  send(128);
  await turn();
  expect([problems(), waiting.length]).toEqual([[], 128]);
});

it("rejects further commands, but not a stop, until the first are answered", async () => {
  const { send, problems, refused, turn, waiting, closed } = withSlowStore();
  send(limits.unfinishedCommands + 3);
  send(1, "stop");
  await turn();
  expect(problems()).toEqual(Array(3).fill("/problems/too-fast"));
  expect(refused).toEqual(Array(3).fill(expect.stringMatching(/^Too many unanswered commands\./)));
  expect(waiting).toHaveLength(limits.unfinishedCommands + 1);
  for (const answer of waiting.splice(0)) answer();
  await turn();
  send(64);
  await turn();
  expect([problems().length, waiting.length, closed]).toEqual([3, 64, []]);
});

it("closes a script that keeps sending without waiting", async () => {
  const { send, turn, waiting, closed } = withSlowStore();
  send(5_000, "stop");
  await turn();
  expect(waiting).toHaveLength(limits.unfinishedCommands + limits.unfinishedStops);
  expect(closed).toEqual([]);
  send(5_000);
  await turn();
  expect(waiting).toHaveLength(limits.unfinishedCommands + limits.unfinishedStops);
  expect(closed[0]).toBe(4400);
});

it("includes the idempotency key of an invalid command, if it is readable", () => {
  const { say, sent } = withSlowStore();
  const wrong = (key: unknown) =>
    JSON.stringify({ type: "command", key, command: { action: "move", dist: 5 } });
  for (const text of [wrong("wrong-field-1"), wrong("short"), wrong(7), "{", "null"]) say(text);
  const keys = sent.flatMap((message) => (message.type === "problem" ? [message.key] : []));
  expect(keys).toEqual(["wrong-field-1", null, null, null, null]);
});
