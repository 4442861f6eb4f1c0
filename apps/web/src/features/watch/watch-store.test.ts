import { closeReasons } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import type { FromWatcher, ToWatcher } from "../../simulator/protocol/watch-messages.ts";
import { firstMaze } from "../../simulator/protocol/first-project.ts";
import { WatchClient } from "./watch-client.ts";
import { createWatchStore, drivenBy, endingOf, robotState } from "./watch-store.ts";

const robot = { id: "A".repeat(22), key: `wch_${"B".repeat(22)}` };
const lost = { kind: "lost", reason: closeReasons.restart } as const;

/** The page of a viewer, with a worker whose messages the test sends. */
function looking() {
  const store = createWatchStore({ kind: "watch", robot });
  const sent: ToWatcher[] = [];
  const port: ConstructorParameters<typeof WatchClient>[0] = {
    postMessage: (message) => sent.push(message),
    onmessage: null,
    onerror: null,
  };
  const client = new WatchClient(port, store);
  const emit = (data: FromWatcher): void => port.onmessage?.({ data } as MessageEvent<FromWatcher>);
  const state = (): string => endingOf(store.getState()) ?? robotState(store.getState());
  return { store, client, sent, emit, state, port };
}

describe("a viewer's page", () => {
  it("reports the state of the robot from the first attempt on", () => {
    const { emit, state } = looking();
    expect(state()).toBe("connecting");
    emit({ type: "watch-status", status: { kind: "connecting" } });
    expect(state()).toBe("connecting");
    emit({ type: "watch-status", status: { kind: "connected" } });
    expect(state()).toBe("waiting");
    for (const each of ["running", "paused", "gone", "running"] as const) {
      emit({ type: "watch-snapshot", snapshot: snapshotOf({ state: each }) });
      expect(state()).toBe(each);
    }
  });

  it("reports that a script drives from its first command until shortly after the last", () => {
    const { emit, store } = looking();
    const driver = (change: Parameters<typeof snapshotOf>[0]) => {
      emit({ type: "watch-snapshot", snapshot: snapshotOf(change) });
      return drivenBy(store.getState());
    };
    expect(driver({ driver: "remote", tick: 10, command: null })).toBe("waiting");
    expect(driver({ driver: "remote", tick: 20, command: 1 })).toBe("remote");
    expect(driver({ driver: "remote", tick: 1_800, command: null })).toBe("remote");
    expect(driver({ driver: "remote", tick: 1_820, command: null })).toBe("waiting");
    expect(driver({ driver: "remote", tick: 1_830, command: 2 })).toBe("remote");
    expect(driver({ driver: "me", tick: 1_840 })).toBe("me");
    expect(driver({ driver: "remote", tick: 1_850, command: null })).toBe("waiting");
  });

  it("reports that a lost connection is retried until it is established", () => {
    const { emit, state } = looking();
    emit({ type: "watch-status", status: lost });
    emit({ type: "watch-status", status: { kind: "connecting" } });
    expect(state()).toBe("lost");
    emit({ type: "watch-snapshot", snapshot: snapshotOf() });
    emit({ type: "watch-status", status: { kind: "connected" } });
    expect(state()).toBe("running");
    emit({ type: "watch-status", status: { kind: "connecting" } });
    expect(state()).toBe("lost");
  });

  it.each([
    { reason: closeReasons.notAuthorised, ending: "revoked" },
    { reason: closeReasons.forbidden, ending: "revoked" },
    { reason: closeReasons.noRobot, ending: "deleted" },
    { reason: closeReasons.over, ending: "deleted" },
  ])("reports why it is over: $reason.cause", ({ reason, ending }) => {
    const { emit, state } = looking();
    emit({ type: "watch-status", status: { kind: "over", reason } });
    expect(state()).toBe(ending);
  });

  it("reports a worker that fails to load", () => {
    const { port, state } = looking();
    port.onerror?.({} as ErrorEvent);
    expect(state()).toBe("failed");
  });

  it("has the maze, or none if it is unknown", () => {
    const { store, emit } = looking();
    expect(store.getState().maze).toBeUndefined();
    emit({ type: "watch-maze", maze: firstMaze });
    expect(store.getState().maze).toBe(firstMaze);
    emit({ type: "watch-maze", maze: null });
    expect(store.getState().maze).toBeNull();
  });

  it("asks its worker for the robot, for another try, and for the end", () => {
    const { client, sent } = looking();
    client.watch(robot);
    client.tryAgain();
    client.stop();
    expect(sent).toEqual([
      { type: "watch", robot },
      { type: "watch-again" },
      { type: "watch", robot: null },
    ]);
  });

  it("rejects script addresses and incomplete links", () => {
    expect(endingOf(createWatchStore({ kind: "script" }).getState())).toBe("script");
    expect(endingOf(createWatchStore({ kind: "broken" }).getState())).toBe("broken");
  });
});
