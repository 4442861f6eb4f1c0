import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ClassSession, ClassStudent } from "../../simulator/protocol/class-messages.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { en } from "../../text/en/index.ts";
import join from "../../text/en/join.json";
import { createI18n } from "../../text/i18n.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { storedMembership, storeMembership } from "./membership.ts";
import { StudentClass } from "./student-class.ts";

const NOW = Date.UTC(2026, 0, 1);
const joined: JoinedClass = {
  class: "A".repeat(22),
  student: 1,
  name: { word: 7, text: null },
  key: `stu_${"B".repeat(22)}`,
};
const open = { type: "class", request: { kind: "open", id: joined.class, key: joined.key } };
const student: ClassStudent = {
  name: joined.name,
  renamesLeft: 2,
  rename: "possible",
  helpWanted: false,
  watched: false,
  pauseEndsAt: null,
  lesson: "k3J9x2aBk3J9x2aBk3J9x2",
  paceTo: null,
  stored: { progress: 0, program: 0 },
};

/** The page of a student, and the worker's end of it. */
function openPage(tab = new VolatileStorage()) {
  const sent: ToWorker[] = [];
  const listeners = new Set<(message: FromWorker) => void>();
  const timers = new Set<() => void>();
  let isInClass = true;
  const onEnd = () => (isInClass = false);
  const pauses: (number | null)[] = [];
  const onPause = (endsAt: number | null) => void pauses.push(endsAt);
  const now = () => NOW;
  const screen = createScreenStore();
  storeMembership(tab, joined);
  const words = createI18n(en);
  words.addResourceBundle("en", "join", join);
  const simulator = {
    send: (message: ToWorker) => void sent.push(message),
    listen: (listener: (message: FromWorker) => void) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
  const later = (call: () => void) => {
    timers.add(call);
    return () => void timers.delete(call);
  };
  const page = new StudentClass(
    { simulator, screen, tab, words, now, onPause, onEnd, later },
    joined,
  );
  return {
    page,
    sent,
    isInClass: () => isInClass,
    pauses,
    tab,
    screen,
    texts: () => screen.getState().messages.map(({ text }) => text),
    /** reports a page that connects, of which the class has not answered yet */
    reconnect: (): void => {
      const session: ClassSession = { status: { kind: "connecting" }, student: null };
      for (const listener of listeners) listener({ type: "class", session });
    },
    receive: (status: ClassSession["status"], change: Partial<ClassStudent> = {}): void => {
      const session = { status, student: { ...student, ...change } };
      for (const listener of listeners) listener({ type: "class", session });
    },
    wait: (): void => {
      for (const call of timers) call();
      timers.clear();
    },
  };
}

describe("the class of a student", () => {
  it("connects at once", () => {
    const { page, sent } = openPage();
    expect(sent).toEqual([open]);
    expect(page.session.getState().status).toEqual({ kind: "connecting" });
  });

  it("shows a new name, also after a reload", () => {
    const { page, tab, receive } = openPage();
    const name = { word: 8, text: null };
    receive({ kind: "connected" }, { name });
    expect(page.name).toEqual(name);
    expect(storedMembership(tab)).toEqual({ ...joined, name });
  });

  it("sends requests for help and for another name", () => {
    const { page, sent } = openPage();
    page.askForHelp(true);
    page.requestName();
    expect(sent.slice(1)).toEqual([
      { type: "class", request: { kind: "help", wanted: true } },
      { type: "class", request: { kind: "name" } },
    ]);
  });
});

describe("a connection that is lost", () => {
  it("is reported after some seconds, until it is back", () => {
    const { texts, receive, wait } = openPage();
    receive({ kind: "connected" });
    receive({ kind: "lost" });
    receive({ kind: "connecting" });
    receive({ kind: "lost" });
    expect(texts()).toEqual([]);
    wait();
    expect(texts()).toEqual([join.inClass.lost]);
    receive({ kind: "connecting" });
    expect(texts()).toEqual([join.inClass.lost]);
    receive({ kind: "connected" });
    expect(texts()).toEqual([]);
  });

  it("is not reported if it comes back soon", () => {
    const { texts, receive, wait } = openPage();
    receive({ kind: "lost" });
    receive({ kind: "connected" });
    wait();
    expect(texts()).toEqual([]);
  });

  it("reconnects when the device is online again, and does not disturb another tab", () => {
    const { page, sent, receive } = openPage();
    receive({ kind: "lost" });
    page.reconnect();
    expect(sent).toEqual([open, open]);
    receive({ kind: "over", reason: "replaced" });
    page.reconnect();
    expect(sent).toHaveLength(2);
  });
});

describe("a pause of the class", () => {
  const pauseEndsAt = NOW + 60_000;

  it("stops the robot once, until the clock ends it", () => {
    const { pauses, sent, texts, receive, wait } = openPage();
    receive({ kind: "connected" }, { pauseEndsAt });
    receive({ kind: "connected" }, { pauseEndsAt, helpWanted: true });
    expect(pauses).toEqual([pauseEndsAt]);
    expect(sent.slice(1)).toEqual([{ type: "class-pause", isPaused: true }]);
    receive({ kind: "lost" }, { pauseEndsAt });
    wait();
    expect(pauses).toEqual([pauseEndsAt, null]);
    expect(sent.at(-1)).toEqual({ type: "class-pause", isPaused: false });
    expect(texts()).toContain(join.inClass.pauseOver);
  });

  it("ends when the teacher ends it", () => {
    const { pauses, texts, receive } = openPage();
    receive({ kind: "connected" }, { pauseEndsAt });
    receive({ kind: "connected" });
    expect(pauses).toEqual([pauseEndsAt, null]);
    expect(texts()).toEqual([join.inClass.pauseOver]);
  });

  it("continues at once after a reload, before the class answers", () => {
    const { tab, receive } = openPage();
    receive({ kind: "connected" }, { pauseEndsAt });
    const { pauses, sent, reconnect, texts } = openPage(tab);
    expect(pauses).toEqual([pauseEndsAt]);
    expect(sent).toEqual([{ type: "class-pause", isPaused: true }, open]);
    reconnect();
    expect(pauses).toEqual([pauseEndsAt]);
    expect(texts()).toEqual([]);
  });

  it("is ignored if it has ended already", () => {
    const { pauses, texts, receive } = openPage();
    receive({ kind: "connected" }, { pauseEndsAt: NOW });
    expect(pauses).toEqual([]);
    expect(texts()).toEqual([]);
  });

  it("ends with the class, and when the student leaves", () => {
    const { pauses, texts, receive } = openPage();
    receive({ kind: "connected" }, { pauseEndsAt });
    receive({ kind: "over", reason: "over" }, { pauseEndsAt });
    expect(pauses.at(-1)).toBeNull();
    expect(texts()).toEqual([join.inClass.over]);
    const left = openPage();
    left.receive({ kind: "connected" }, { pauseEndsAt });
    left.page.leave();
    expect(left.pauses.at(-1)).toBeNull();
    expect(left.texts()).toEqual([]);
  });
});

describe("the end of a class", () => {
  it.each(["removed", "over"] as const)(
    "after %s stays on the screen, without the menu",
    (reason) => {
      const { isInClass, tab, texts, receive, wait } = openPage();
      receive({ kind: "connected" });
      receive({ kind: "lost" });
      receive({ kind: "over", reason });
      wait();
      expect(texts()).toEqual([join.inClass[reason]]);
      expect(isInClass()).toBe(false);
      expect(storedMembership(tab)).toBeNull();
    },
  );

  it("in another tab can be taken back", () => {
    const { isInClass, tab, screen, sent, texts, receive } = openPage();
    receive({ kind: "connected" });
    receive({ kind: "over", reason: "replaced" });
    expect(texts()).toEqual([join.inClass.replaced]);
    expect(isInClass()).toBe(true);
    expect(storedMembership(tab)).toEqual(joined);
    screen.getState().messages[0]?.action?.run();
    expect(sent).toEqual([open, open]);
    expect(texts()).toEqual([]);
  });

  it("by leaving discards the key, and ignores what arrives later", () => {
    const { page, isInClass, tab, sent, texts, receive } = openPage();
    receive({ kind: "connected" });
    page.leave();
    receive({ kind: "over", reason: "over" });
    expect(sent.at(-1)).toEqual({ type: "class", request: { kind: "close" } });
    expect(isInClass()).toBe(false);
    expect(storedMembership(tab)).toBeNull();
    expect(texts()).toEqual([]);
  });
});
