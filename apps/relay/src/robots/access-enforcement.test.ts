import { expect, it } from "vitest";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import type { StoredScript } from "../commands/robot-step.ts";
import { AccessEnforcement } from "./access-enforcement.ts";
import { callerOf } from "./access/callers.ts";
import { EventLog } from "../platform/events/event-log.ts";
import { recordPacking } from "./readers/packed-record.ts";
import { Subscribers } from "./readers/subscribers.ts";

const nobody = { snapshot: () => undefined, state: () => undefined };

/** A robot with readers of several keys, and a list of what happens to it. */
function withReaders({ hasPage = true } = {}) {
  const clock = new FakeClock();
  const subscribers = new Subscribers(clock, new EventLog(clock, recordPacking));
  const seen: string[] = [];
  const join = (label: string, kind: "own" | "drive" | "watch", hash: string, name = "a") => {
    const caller = callerOf({ kind, hash }, { client: "Python", name });
    const over = (reason: string): void => void seen.push(`${label} disconnected: ${reason}`);
    const listener = { ...nobody, maze: () => undefined, missed: () => undefined, over };
    subscribers.join(listener, caller, "websocket");
    return caller;
  };
  const connection = { isOpen: true, send: () => undefined, close: () => undefined };
  const page = hasPage ? { connection, epoch: 1, name: "", isReleasing: false } : null;
  const enforcement = new AccessEnforcement({
    subscribers,
    ownership: { page },
    recall: { askAgain: async () => void seen.push("page asked to end commands") },
    presence: {
      blockedChanged: () => void seen.push("page shows permissions"),
      keyRevoked: (hash) => void seen.push(`scripts of ${hash} deleted`),
    },
    channel: { rightsChanged: () => void seen.push("other relays read permissions") },
    clocks: { revoked: (hash) => void seen.push(`clocks of ${hash} deleted`) },
  });
  return { enforcement, join, seen };
}

it("disconnects all users of a revoked key and has their commands ended", () => {
  const { enforcement, join, seen } = withReaders();
  const anna = join("Anna", "drive", "first");
  join("Anna again", "drive", "first", "b");
  join("Ben", "drive", "second");
  enforcement.revoked(anna);
  expect(seen).toEqual([
    "clocks of first deleted",
    "Anna disconnected: revoked",
    "Anna again disconnected: revoked",
    "scripts of first deleted",
    "page asked to end commands",
  ]);
});

it("disconnects only the blocked one of two scripts with the same key", () => {
  const { enforcement, join, seen } = withReaders();
  const { script } = join("Anna", "drive", "first");
  join("Ben", "drive", "first", "b");
  enforcement.blocked(script as StoredScript);
  expect(seen).toEqual(["Anna disconnected: blocked", "page asked to end commands"]);
});

it("disconnects scripts and viewers, but not the owner, while the valid keys are unknown", () => {
  const { enforcement, join, seen } = withReaders();
  join("owner", "own", "own");
  join("script", "drive", "first");
  join("viewer", "watch", "second");
  enforcement.doubted();
  expect(seen).toEqual(["script disconnected: busy", "viewer disconnected: busy"]);
});

it("disconnects nobody when the owner pauses remote driving", () => {
  const { enforcement, join, seen } = withReaders();
  join("Anna", "drive", "first");
  enforcement.paused();
  expect(seen).toEqual(["page asked to end commands"]);
});

it("asks no page at another relay, because that relay receives the change, too", () => {
  const { enforcement, seen } = withReaders({ hasPage: false });
  enforcement.paused();
  expect(seen).toEqual([]);
});

it("notifies other relays of its own changes only", () => {
  const { enforcement, seen } = withReaders();
  enforcement.keysChanged();
  enforcement.scriptsChanged();
  enforcement.reread();
  expect(seen).toEqual([
    "other relays read permissions",
    "other relays read permissions",
    "page shows permissions",
    "page shows permissions",
  ]);
});
