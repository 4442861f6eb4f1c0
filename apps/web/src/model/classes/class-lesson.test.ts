import { lessonMark, type LessonDocument } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import type { ClassStudent } from "../../simulator/protocol/class-messages.ts";
import { en } from "../../text/en/index.ts";
import join from "../../text/en/join.json";
import { createI18n } from "../../text/i18n.ts";
import { createChallengeStore } from "../challenge/challenge-store.ts";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { ClassLesson, storedLesson } from "./class-lesson.ts";
import { ClassLessonMark } from "./class-lesson-mark.ts";
import type { ClassLessonResult } from "./read-class-lesson.ts";

const other: LessonDocument = { ...sampleLesson, name: "Long way round" };

/** A student's page in a class. Its lessons open at once. */
function newPage(tab = new VolatileStorage()) {
  const challenge = createChallengeStore();
  const screen = createScreenStore();
  const words = createI18n(en);
  words.addResourceBundle("en", "join", join);
  const timers = new Map<() => void, number>();
  const hints: number[] = [];
  const opened: string[] = [];
  let result: ClassLessonResult = { ok: true, lesson: sampleLesson };
  let isPaused = false;
  let isDriving = false;
  let changes = 0;
  const resume = (document: LessonDocument): void => {
    opened.push(document.name);
    const lessonId = lessonMark(document);
    challenge.setState({ lesson: document, index: 0, mission: null, lessonId });
  };
  const openTask = (index: number): void => challenge.setState({ index });
  const lesson = new ClassLesson({
    read: async () => result,
    challenge,
    lessons: { load: async () => ({ navigation: { resume, openTask } }) as never },
    screen,
    tab,
    words,
    lesson: new ClassLessonMark(storedLesson(tab)?.mark ?? null),
    isPaused: () => isPaused,
    isDriving: () => isDriving,
    onLesson: () => (changes += 1),
    onNext: () => undefined,
    onHint: (hint) => hints.push(hint),
    later: (call, ms) => {
      timers.set(call, ms);
      return () => void timers.delete(call);
    },
  });
  const settle = async () => new Promise((resolve) => setTimeout(resolve));
  return {
    tab,
    lesson,
    challenge,
    hints,
    opened,
    setPaused: (paused: boolean) => (isPaused = paused),
    setDriving: (driving: boolean) => (isDriving = driving),
    changes: () => changes,
    texts: () => screen.getState().messages.map(({ text }) => text),
    press: async (label: string) => {
      const { messages } = screen.getState();
      messages.find(({ action }) => action?.label === label)?.action?.run();
      await settle();
    },
    answer: (document: LessonDocument) => (result = { ok: true, lesson: document }),
    receive: async (answer: ClassLessonResult | LessonDocument, version: string) => {
      result = "ok" in answer ? answer : { ok: true, lesson: answer };
      const student = { lesson: version, paceTo: null } as ClassStudent;
      lesson.follow({ status: { kind: "connected" }, student });
      await settle();
    },
    pace: (paceTo: number | null, version: string) => {
      const student = { lesson: version, paceTo } as ClassStudent;
      lesson.follow({ status: { kind: "connected" }, student });
    },
    /** Calls all timers of at most this time. */
    wait: async (ms: number) => {
      const due = [...timers].filter(([, after]) => after <= ms);
      for (const [call] of due) if (timers.delete(call)) call();
      await settle();
    },
  };
}

/** A page that has joined. */
async function joinedPage() {
  const page = newPage();
  await page.receive(sampleLesson, "first");
  await page.wait(0);
  return page;
}

describe("the lesson of a class", () => {
  it("opens when the student joins, and not again after a reload", async () => {
    const { opened, tab } = await joinedPage();
    expect(opened).toEqual(["Sensors"]);
    const reloaded = newPage(tab);
    await reloaded.receive(sampleLesson, "first");
    await reloaded.wait(60_000);
    expect(reloaded.opened).toEqual([]);
    expect(reloaded.texts()).toEqual([]);
  });

  it("is offered when the teacher sends another one, and opens by itself", async () => {
    const { receive, opened, texts, wait } = await joinedPage();
    await receive(other, "second");
    expect(texts()).toEqual([
      "Your teacher sent: Long way round. It opens in 10 s. Your own work stays as it is.",
    ]);
    expect(opened).toEqual(["Sensors"]);
    await wait(10_000);
    expect(opened).toEqual(["Sensors", "Long way round"]);
    expect(texts()).toEqual([]);
  });

  it("opens at once if the student wants to, and only once", async () => {
    const { receive, press, opened, wait } = await joinedPage();
    await receive(other, "second");
    await press("Open");
    await wait(60_000);
    expect(opened).toEqual(["Sensors", "Long way round"]);
  });

  it("opens after the end of a run, or 30 s later", async () => {
    const { receive, setDriving, opened, wait } = await joinedPage();
    setDriving(true);
    await receive(other, "second");
    await wait(10_000);
    await wait(1_000);
    expect(opened).toEqual(["Sensors"]);
    setDriving(false);
    await wait(1_000);
    expect(opened).toEqual(["Sensors", "Long way round"]);
    setDriving(true);
    await receive(sampleLesson, "third");
    await wait(10_000);
    for (let second = 0; second < 30; second++) {
      expect(opened).toHaveLength(2);
      await wait(1_000);
    }
    expect(opened).toHaveLength(3);
  });

  it("is offered to a student whose robot already drives when the page joins", async () => {
    const { receive, setDriving, opened, texts, press } = newPage();
    setDriving(true);
    await receive(sampleLesson, "first");
    expect(texts()).toEqual([expect.stringContaining("Your teacher sent: Sensors.")]);
    await press("Open");
    expect(opened).toEqual(["Sensors"]);
  });

  it("leaves the pace and the hints to the one before it until it opens", async () => {
    const { receive, pace, lesson, challenge, changes, press, hints } = await joinedPage();
    pace(2, "first");
    lesson.showHint({ task: 1, hint: 2 });
    expect(changes()).toBe(1);
    await receive(other, "second");
    pace(2, "second");
    expect(challenge.getState()).toMatchObject({ openTo: 2, hints: { 0: 2 } });
    expect(lesson.state.getState().isOpen).toBe(false);
    // The page still works on the lesson before it, and reports that.
    expect(changes()).toBe(1);
    // The teacher sees the new lesson: this hint is of its task.
    lesson.showHint({ task: 1, hint: 1 });
    expect(hints).toEqual([2]);
    expect(challenge.getState().hints).toEqual({ 0: 2 });
    await press("Open");
    expect(changes()).toBe(2);
    expect(challenge.getState()).toMatchObject({ openTo: 2, hints: { 0: 1 } });
    expect(lesson.state.getState().isOpen).toBe(true);
  });

  it("is the lesson of the class at once if the student leaves the one before it", async () => {
    const { receive, challenge, lesson, changes, wait, opened } = await joinedPage();
    await receive(other, "second");
    challenge.setState({ lesson: null, lessonId: null });
    expect(changes()).toBe(2);
    expect(lesson.state.getState().document?.name).toBe("Long way round");
    await wait(10_000);
    expect(opened).toEqual(["Sensors", "Long way round"]);
  });

  it("is not offered any more after the teacher has sent the one before it again", async () => {
    const { receive, texts, lesson, opened, wait } = await joinedPage();
    await receive(other, "second");
    await receive(sampleLesson, "first");
    expect(texts()).toEqual([]);
    expect(lesson.state.getState().isOpen).toBe(true);
    await wait(60_000);
    expect(opened).toEqual(["Sensors"]);
  });

  it("does not open while the class is paused", async () => {
    const { receive, setPaused, opened, wait } = await joinedPage();
    await receive(other, "second");
    setPaused(true);
    await wait(10_000);
    expect(opened).toEqual(["Sensors"]);
    setPaused(false);
    await wait(1_000);
    expect(opened).toEqual(["Sensors", "Long way round"]);
  });

  it("asks again after the relay did not send it", async () => {
    const { receive, answer, opened, wait } = newPage();
    await receive({ ok: false, reason: "failed" }, "first");
    await wait(0);
    expect(opened).toEqual([]);
    answer(sampleLesson);
    await wait(5_000);
    await wait(0);
    expect(opened).toEqual(["Sensors"]);
  });

  it("asks for a reload if the page is too old for it", async () => {
    const { receive, texts } = newPage();
    await receive({ ok: false, reason: "old" }, "first");
    expect(texts()).toEqual([
      "This page is older than the class. Reload to join. Your work is saved.",
    ]);
  });
});

describe("the pace of the class", () => {
  it("applies to the lesson of the class, and to no other", async () => {
    const { pace, challenge, texts } = await joinedPage();
    pace(1, "first");
    expect(challenge.getState().openTo).toBe(1);
    pace(2, "first");
    expect(texts()).toEqual(["You can open task 2 now."]);
    challenge.setState({ lesson: other, lessonId: lessonMark(other) });
    expect(challenge.getState().openTo).toBeUndefined();
    challenge.setState({ lesson: sampleLesson, lessonId: lessonMark(sampleLesson) });
    expect(challenge.getState().openTo).toBe(2);
  });
});

describe("a hint of the teacher", () => {
  it("is still there after a reload, and one that the student closed stays closed", async () => {
    const { lesson, challenge, tab } = await joinedPage();
    lesson.showHint({ task: 1, hint: 2 });
    challenge.setState({ hintsRead: { 0: 1 } });
    const again = newPage(tab);
    again.challenge.setState({ ...challenge.getState(), hints: undefined });
    await again.receive(sampleLesson, "v1");
    expect(again.challenge.getState()).toMatchObject({ hints: { 0: 2 }, hintsRead: { 0: 1 } });
  });

  it("includes hints that the student opened before", async () => {
    const { lesson, challenge, tab } = await joinedPage();
    lesson.openHint(1);
    expect(challenge.getState()).toMatchObject({ hints: { 0: 1 }, hintsRead: { 0: 1 } });
    const stored = newPage(tab);
    await stored.receive(other, "v2");
    expect(stored.challenge.getState().hintsRead ?? {}).toEqual({});
  });

  it("appears in the open task", async () => {
    const { lesson, challenge, hints, texts } = await joinedPage();
    lesson.showHint({ task: 1, hint: 2 });
    expect(challenge.getState().hints).toEqual({ 0: 2 });
    expect(hints).toEqual([2]);
    expect(texts()).toEqual(["Your teacher shows you hint 2."]);
  });

  it("leads to the task that it belongs to", async () => {
    const { lesson, challenge, press, texts } = await joinedPage();
    lesson.showHint({ task: 3, hint: 1 });
    expect(texts()).toEqual(["Your teacher shows you hint 1 of task 3."]);
    await press("Open task 3");
    expect(challenge.getState().index).toBe(2);
  });
});
