import { closeReasons, type CloseReason, type RelayToPage, type Resume } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { LiveView } from "./live-view.ts";
import { PageHandover } from "./page/page-handover.ts";
import { PageOwnership, type PageConnection } from "./page/page-ownership.ts";
import { RobotPage } from "./robot-page.ts";

const resume: Resume = { type: "resume", lastApplied: 0, fresh: true, endings: [] };

/** The page side of a robot without a store, and what happens to it in order. */
function withPageSide() {
  const clock = new FakeClock();
  const ownership = new PageOwnership(clock.now(), { epoch: 0, page: "" });
  const seen: string[] = [];
  const channel = {
    pageLeft: (epoch: number, closedByPage: boolean) =>
      void seen.push(`page ${epoch} left${closedByPage ? "" : ", connection lost"}`),
    flush: () => void seen.push("other relays have the newest snapshot"),
    snapshot: () => undefined,
    yield: () => undefined,
    yielded: () => undefined,
  };
  const handover = new PageHandover({ clock, ownership, channel });
  const subscribers = {
    publishSnapshot: ({ seq, state }: CarriedSnapshot) => void seen.push(`${seq} ${state}`),
  };
  const view = new LiveView({ clock, subscribers, channel });
  const life = {
    handover,
    acquirePage: async (connection: PageConnection, _resume: Resume, acquired: () => void) => {
      ownership.take({ connection, epoch: ownership.epoch + 1, name: "" });
      acquired();
    },
    receiveFromPage: async ({ isOpen }: PageConnection, { type }: { type: string }) =>
      void seen.push(`${type}${isOpen ? "" : " of a closed page"}`),
  };
  const page = new RobotPage({
    createdAt: clock.now(),
    clock,
    ownership,
    life,
    view,
    channel,
    use: { used: () => undefined },
    report: { send: () => void seen.push("scripts") },
  });
  const connection = () => {
    const sent: RelayToPage[] = [];
    const closed: CloseReason[] = [];
    const made: PageConnection & { isOpen: boolean } = {
      isOpen: true,
      send: (...messages) => void sent.push(...messages),
      close: (reason) => {
        made.isOpen = false;
        closed.push(reason);
      },
    };
    return { connection: made, sent, closed };
  };
  return { clock, ownership, page, connection, seen };
}

const snapshot = (seq: number) => snapshotOf({ seq, tick: seq });

it("shows readers the snapshot of a page before anything else of it, and the page the scripts", async () => {
  const { page, connection, seen } = withPageSide();
  await page.acquire(connection().connection, { ...resume, snapshot: snapshot(3) });
  expect(seen).toEqual(["3 running", "scripts"]);
});

it("leaves no robot with a page that disconnected while it acquired the robot", async () => {
  const { ownership, page, connection, seen } = withPageSide();
  const { connection: gone } = connection();
  gone.isOpen = false;
  await page.acquire(gone, resume);
  expect(ownership.page).toBeNull();
  expect(seen).toEqual(["scripts", "page 1 left, connection lost"]);
});

it("ignores the messages and the end of a page that another one has replaced", async () => {
  const { page, connection, seen } = withPageSide();
  const [first, second] = [connection(), connection()];
  await page.acquire(first.connection, resume);
  await page.acquire(second.connection, resume);
  seen.length = 0;
  page.receiveSnapshot(first.connection, 1, CarriedSnapshot.of(snapshot(1)));
  await page.receive(first.connection, { type: "started", epoch: 1, seq: 1 });
  page.leave(first.connection, true);
  expect(seen).toEqual([]);
});

it("disconnects a page that sends the epoch of another connection", async () => {
  const { page, connection, seen } = withPageSide();
  const { connection: owner, closed } = connection();
  await page.acquire(owner, resume);
  seen.length = 0;
  await page.receive(owner, { type: "started", epoch: 7, seq: 1 });
  expect(closed).toEqual([closeReasons.replaced]);
  expect(seen).toEqual([]);
});

it("sends a page the time of the relay", async () => {
  const { clock, page, connection } = withPageSide();
  const { connection: owner, sent } = connection();
  await page.acquire(owner, resume);
  await page.receive(owner, { type: "time", epoch: 1 });
  expect(sent).toEqual([{ type: "time", at: clock.now() }]);
});

it("sends other relays the newest snapshot before an ending", async () => {
  const { page, connection, seen } = withPageSide();
  const { connection: owner } = connection();
  await page.acquire(owner, resume);
  seen.length = 0;
  await page.receive(owner, { type: "snapshot", epoch: 1, snapshot: snapshot(9) });
  const ending = { seq: 1, state: "completed", reason: null, pose: null, distance: null } as const;
  await page.receive(owner, { type: "ended", epoch: 1, ...ending });
  expect(seen).toEqual(["9 running", "other relays have the newest snapshot", "ended"]);
});

it("lets its page reconnect if other relays consider it disconnected", async () => {
  const { ownership, page, connection, seen } = withPageSide();
  page.lapsed();
  const { connection: owner, closed } = connection();
  await page.acquire(owner, resume);
  page.lapsed();
  expect(closed).toEqual([closeReasons.restart]);
  expect(ownership.page).toBeNull();
  expect(seen).toEqual(["scripts", "page 1 left, connection lost"]);
});
