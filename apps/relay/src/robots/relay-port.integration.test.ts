import {
  robotPortCases,
  type PortPage,
  type PortWorld,
} from "@corridor/protocol/testing/robot-port";
import { describe, expect, it, vi } from "vitest";
import { maze } from "../platform/testing/sample-documents.ts";
import { RelayPort } from "./relay-port.ts";
import { ignoringReader, page, withRobot, type Host } from "./testing/robot-at-relay.ts";

const { transport, flow } = ignoringReader;

async function world(): Promise<PortWorld> {
  const setup = await withRobot();
  const { clock, registry, registration, robot } = setup;
  const keys: string[] = [];
  return {
    page: pageOf(await page(setup)),
    open: async (kind) => {
      const { id, key } = await robot.keys.make({ kind });
      keys.push(id);
      const script = { client: "ROS", name: null };
      const grant = await registry.authorise(registration.id, key, "read", script);
      return new RelayPort(grant, { transport, flow });
    },
    takeOver: async () => pageOf(await page(setup, { fresh: true, page: "second-page" })),
    publishMaze: async (name) => {
      await robot.mazes.keep({ ...maze, name });
    },
    pause: async (isPaused) => robot.scriptAccess.pause(isPaused),
    block: async () => {
      for (const { driver, client, name } of robot.scripts) {
        await robot.scriptAccess.block({ driver, client, name });
      }
    },
    revoke: async () => {
      for (const id of keys) await robot.keys.revoke(id);
    },
    remove: async () => registry.remove(robot),
    pass: async (ms) => clock.pass(ms),
  };
}

function pageOf(host: Host): PortPage {
  let seq = 1;
  return {
    report: (change) => void host.report({ seq: (seq += 1), ...change }),
    arrived: () => [...host.seqs("command"), ...host.seqs("stop")],
    cancelled: () => host.sent.flatMap((each) => (each.type === "cancel" ? [each.seq] : [])),
    started: (number) => void host.started(number),
    ended: (number, state) => {
      const pose = { x: 150, y: 150, heading: 90 };
      void host.ended({ seq: number, state, reason: null, pose, distance: 50 });
    },
  };
}

robotPortCases("a port inside the relay", world);

describe("a port inside the relay", () => {
  async function opened() {
    const setup = await withRobot();
    const port = new RelayPort(setup, { transport, flow });
    const calls: string[] = [];
    port.subscribe({
      snapshot: ({ tick }) => void calls.push(`snapshot ${tick}`),
      state: ({ seq, state }) => void calls.push(`${seq} ${state}`),
      gap: (open) =>
        void calls.push(`gap ${open.map(({ seq, state }) => `${seq} ${state}`).join(", ")}`),
      maze: () => void calls.push("maze"),
      end: ({ problem, retryAfter }) => void calls.push(`${problem.type} ${retryAfter}`),
    });
    return { setup, port, calls };
  }

  it("receives the open commands after missed states", async () => {
    const { setup, port, calls } = await opened();
    await port.send({ action: "left 90" });
    setup.robot.missedMessages();
    await vi.waitFor(() => expect(calls).toContain("gap 1 accepted"));
  });

  it("ends when the relay stops, and says when to try again", async () => {
    const { setup, port, calls } = await opened();
    await setup.registry.close();
    expect(calls).toEqual(["/problems/restarting 2"]);
    await expect(port.send({ action: "left 90" })).rejects.toMatchObject({
      problem: { type: "/problems/restarting" },
      retryAfter: 2,
    });
  });

  it("counts as a connection of its key only while it is subscribed", async () => {
    const { setup, port } = await opened();
    expect(setup.robot.readers.count.websocket).toBe(1);
    expect(setup.robot.scripts).toMatchObject([{ client: "Python", connections: 1 }]);
    port.close();
    expect(setup.robot.readers.count.websocket).toBe(0);
  });
});
