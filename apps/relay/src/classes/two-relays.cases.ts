/** Test cases for a class at two relays that share a store and a message bus, of any kind. */
import type { RelayToScreen, RelayToStudent, RelayToTeacher } from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import type { ClassBus } from "../bus/class-bus.ts";
import { limits } from "../platform/limits/limits.ts";
import { systemClock } from "../platform/time/clock.ts";
import type { ClassStore } from "../store/class-store.ts";
import { tile } from "../testing/class-at-relay.ts";
import { silentLog } from "../testing/test-relay.ts";
import type { ClassVerb } from "./access.ts";
import type { LeaveReason } from "./member-connection.ts";
import { ClassRegistry } from "./registry.ts";
import { lockStep, pauseStep, removeStep } from "./teacher-steps.ts";

/** What a relay uses. */
export interface RelayBackend {
  store: ClassStore;
  bus: ClassBus;
}

/** A class at two relays, whose members connect to either of them. */
export async function classAtTwoRelays(backends: [RelayBackend, RelayBackend]) {
  const [a, b] = backends.map(
    (backend) => new ClassRegistry({ ...backend, clock: systemClock, log: silentLog }),
  );
  if (a === undefined || b === undefined) throw new Error("there are two relays");
  onTestFinished(async () => {
    await a.close();
    await b.close();
  });
  const request = { names: null, expected: null, lesson: "{}" };
  const created = await a.create(request, "1", "http://localhost");
  const grant = async (relay: ClassRegistry, key: string, verb: ClassVerb) =>
    relay.authorise(created.id, key, verb);
  const at = async (relay: ClassRegistry) =>
    (await grant(relay, created.teacherKey, "inspect")).found;
  return {
    a,
    b,
    created,
    at,
    join: async (relay: ClassRegistry) => relay.join(created.code, "1"),
    student: async (relay: ClassRegistry, { key }: { key: string }) => {
      const { found, member } = await grant(relay, key, "learn");
      if (member.kind !== "learn") throw new Error("this is not the key of a student");
      const { link, ...received } = recordingLink<RelayToStudent>();
      return { ...received, ...found.connections.joinStudent(member, link) };
    },
    teacher: async (relay: ClassRegistry) => {
      const { connections } = await at(relay);
      const { link, ...received } = recordingLink<RelayToTeacher>();
      const member = connections.joinTeacher(link, null);
      /** the newest tile and connection of a student */
      const shown = (student: number) =>
        received.sent
          .flatMap((message) => (message.type === "tiles" ? message.tiles : []))
          .findLast((each) => each.student === student);
      const acknowledging = setInterval(() => member.seen(Number.MAX_SAFE_INTEGER), 10);
      onTestFinished(() => clearInterval(acknowledging));
      return { ...received, ...member, connections, shown };
    },
    screen: async (relay: ClassRegistry) => {
      const { connections } = (await grant(relay, created.screenKey, "show")).found;
      const { link, ...received } = recordingLink<RelayToScreen>();
      return { ...received, ...connections.joinScreen(link) };
    },
  };
}

/** Messages between relays, and those to dashboards, wait for an interval each. */
async function eventually(check: () => void | Promise<void>): Promise<void> {
  await vi.waitFor(check, { timeout: 10_000 });
}

function recordingLink<M>() {
  const sent: M[] = [];
  const closed: LeaveReason[] = [];
  const link = {
    send: (message: M) => void sent.push(message),
    close: (reason: LeaveReason) => void closed.push(reason),
  };
  return { link, sent, closed };
}

/** @param open opens the backends of two relays, which the test closes */
export function twoRelaysCases(
  name: string,
  open: () => Promise<[RelayBackend, RelayBackend]>,
): void {
  describe(`${name}: a class at two relays`, () => {
    it("admits every student once, whichever relay the student uses", async () => {
      const { a, b, at, join } = await classAtTwoRelays(await open());
      const joins = Array.from({ length: 40 }, async (_, n) => join(n % 2 === 0 ? a : b));
      const joined = await Promise.all(joins);
      expect(new Set(joined.map(({ student }) => student)).size).toBe(40);
      expect(new Set(joined.map(({ name: { word } }) => word)).size).toBe(40);
      await eventually(async () => {
        for (const relay of [a, b])
          expect((await (await at(relay)).view()).students).toHaveLength(40);
      });
    });

    it("accepts the key of a student who has joined at the other relay", async () => {
      const { a, b, at, join, student } = await classAtTwoRelays(await open());
      await at(b);
      const { sent } = await student(b, await join(a));
      expect(sent).toMatchObject([{ type: "welcome", student: 1 }]);
    });

    it("applies what the teacher sets to students of the other relay", async () => {
      const { a, b, at, join, student } = await classAtTwoRelays(await open());
      const { sent } = await student(b, await join(b));
      await (await at(a)).run(lockStep(true));
      await (await at(a)).run(pauseStep(60));
      await eventually(() => expect(sent.at(-1)).toMatchObject({ type: "pause" }));
      await expect(join(b)).rejects.toMatchObject({ kind: "class-locked" });
    });

    it("shows students of the other relay on a dashboard", async () => {
      const { a, b, join, student, teacher } = await classAtTwoRelays(await open());
      const ada = await student(b, await join(b));
      ada.tile(tile);
      const { shown } = await teacher(a);
      await eventually(() => expect(shown(1)).toMatchObject({ connected: true, tile }));
      ada.tile({ ...tile, seq: 2 });
      await eventually(() => expect(shown(1)).toMatchObject({ tile: { seq: 2 } }));
      ada.leave();
      await eventually(() =>
        expect(shown(1)).toMatchObject({ connected: false, tile: { seq: 2 } }),
      );
    });

    it("notifies a student whom a dashboard at the other relay watches", async () => {
      const { a, b, join, student, teacher } = await classAtTwoRelays(await open());
      const { sent } = await student(b, await join(b));
      const dashboard = await teacher(a);
      dashboard.watch(1);
      await eventually(() => expect(sent.at(-1)).toEqual({ type: "watched", watched: true }));
      dashboard.leave();
      await eventually(() => expect(sent.at(-1)).toEqual({ type: "watched", watched: false }));
    });

    it("shows a hint to a student of the other relay", async () => {
      const { a, b, join, student, teacher } = await classAtTwoRelays(await open());
      const { sent } = await student(b, await join(b));
      const { connections } = await teacher(a);
      connections.hint(1, 2, 3);
      await eventually(() => expect(sent.at(-1)).toEqual({ type: "hint", task: 2, hint: 3 }));
    });

    it("shows the newest content on all big screens, also on later ones", async () => {
      const { a, b, teacher, screen } = await classAtTwoRelays(await open());
      const dashboard = await teacher(a);
      dashboard.display({ solved: 1 }, null);
      const display = await screen(b);
      const { sent } = display;
      await eventually(() => expect(sent.at(-1)).toMatchObject({ content: { solved: 1 } }));
      dashboard.display({ solved: 2 }, null);
      await eventually(() => expect(sent.at(-1)).toMatchObject({ content: { solved: 2 } }));
      display.seen(2);
      (await teacher(b)).display({ solved: 3 }, null);
      await eventually(() => expect(sent.at(-1)).toMatchObject({ content: { solved: 3 } }));
    });

    it("shows the content of the dashboard with the highest priority, until it closes", async () => {
      const { a, b, teacher, screen } = await classAtTwoRelays(await open());
      const shownAt = async (relay: ClassRegistry) => {
        const display = await screen(relay);
        display.leave();
        return display.sent.flatMap((message) =>
          message.type === "display" ? [message.content] : [],
        );
      };
      const laptop = await teacher(a);
      const phone = await teacher(b);
      laptop.display({ solved: 1 }, 5);
      await eventually(async () => expect(await shownAt(b)).toEqual([{ solved: 1 }]));
      phone.display({ solved: 2 }, -9);
      expect(await shownAt(b)).toEqual([{ solved: 1 }]);
      laptop.display({ solved: 3 }, 5);
      await eventually(async () => expect(await shownAt(b)).toEqual([{ solved: 3 }]));
      phone.display({ solved: 4 }, 6);
      await eventually(async () => expect(await shownAt(a)).toEqual([{ solved: 4 }]));
      laptop.display({ solved: 5 }, 5);
      expect(await shownAt(a)).toEqual([{ solved: 4 }]);
      phone.leave();
      await eventually(async () => {
        laptop.display({ solved: 6 }, 5);
        for (const relay of [a, b]) expect(await shownAt(relay)).toEqual([{ solved: 6 }]);
      });
    });

    it("notifies a dashboard that the screens show content of one at the other relay, until it closes", async () => {
      const { a, b, teacher } = await classAtTwoRelays(await open());
      const laptop = await teacher(a);
      const phone = await teacher(b);
      const displayed = () =>
        laptop.sent.flatMap((message) => (message.type === "displayed" ? [message.priority] : []));
      laptop.display({ solved: 1 }, 5);
      await eventually(() => expect(displayed()).toEqual([5]));
      await eventually(() => {
        phone.display({ solved: 2 }, 6);
        expect(displayed()).toEqual([5, 6]);
      });
      expect((await teacher(a)).sent).toContainEqual({ type: "displayed", priority: 6 });
      phone.leave();
      await eventually(() => expect(displayed()).toEqual([5, 6, null]));
    });

    it("closes the first tab of a student when a second one connects to the other relay", async () => {
      const { a, b, join, student, teacher } = await classAtTwoRelays(await open());
      const ada = await join(a);
      const first = await student(a, ada);
      const { shown } = await teacher(a);
      // Connections have the time of the clock in ms.
      await new Promise((resolve) => setTimeout(resolve, 10));
      const second = await student(b, ada);
      await eventually(() => expect(first.closed).toContain("replaced"));
      first.leave();
      second.tile(tile);
      await eventually(() => expect(shown(1)).toMatchObject({ connected: true, tile }));
      expect(second.closed).toEqual([]);
    });

    it("closes the connection of a removed student at the other relay", async () => {
      const { a, b, at, join, student } = await classAtTwoRelays(await open());
      const { closed } = await student(b, await join(b));
      await (await at(a)).run(removeStep(1));
      await eventually(() => expect(closed).toEqual(["removed"]));
    });

    it("limits the dashboards and big screens of both relays together", async () => {
      const { a, b, teacher, screen } = await classAtTwoRelays(await open());
      for (let n = 1; n < limits.teacherConnections; n++) await teacher(a);
      await screen(b);
      await eventually(async () => {
        // One that is admitted leaves again, because it would count itself.
        const admitted = teacher(a).then((dashboard) => dashboard.leave());
        await expect(admitted).rejects.toMatchObject({ kind: "too-many-readers" });
      });
    });

    it("ends at both relays", async () => {
      const { a, b, at, join, student } = await classAtTwoRelays(await open());
      const { closed } = await student(b, await join(b));
      await a.remove(await at(a));
      await eventually(() => expect(closed).toEqual(["over"]));
      await expect(at(b)).rejects.toMatchObject({ kind: "no-class" });
    });
  });
}
