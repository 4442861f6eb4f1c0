import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../../model/storage/testing/memory-storage.ts";
import { LessonDraft } from "../editor/lesson-draft.ts";
import { programOf, sampleLesson } from "../testing/sample-lesson.ts";
import { corridor, lessonWith, taskWith } from "../testing/teacher-task.ts";
import { LessonAutosave } from "../editor/lesson-autosave.ts";
import { SavedLessons, type SavedLesson } from "../../../model/teaching/saved-lessons.ts";

const lesson = lessonWith(taskWith());

function entry(id: string, change: Partial<SavedLesson> = {}): SavedLesson {
  return { id, savedAt: 1, revision: "r", lesson, solutions: new Map(), ...change };
}

describe("the lessons on the device", () => {
  it("are listed as they were saved, newest first", () => {
    const lessons = new SavedLessons(new MemoryStorage());
    const solution = { lines: 2, ticks: 300, program: programOf("right-wall", "Mine") };
    const newer = entry("b", {
      savedAt: 2,
      lesson: sampleLesson,
      solutions: new Map([["m", solution]]),
    });
    lessons.write(entry("a"));
    lessons.write(newer);
    expect(lessons.list()).toEqual([newer, entry("a")]);
    lessons.remove("b");
    expect(lessons.list()).toEqual([entry("a")]);
  });

  it("may contradict themselves while they are being written", () => {
    const lessons = new SavedLessons(new MemoryStorage());
    const unfinished = entry("a", {
      lesson: lessonWith(taskWith({ mazes: [{ ...corridor, goals: [] }] })),
    });
    lessons.write(unfinished);
    expect(lessons.read("a")).toEqual(unfinished);
  });

  it.each(["", "{", "[]", "null", '{"text":1}', '{"text":"nonsense"}'])(
    "are skipped if they are damaged: %j",
    (text) => {
      const device = new MemoryStorage();
      device.setItem("corridor.teach.made.a", text);
      expect(new SavedLessons(device).list()).toEqual([]);
    },
  );
});

/** A tab in which a saved lesson is open. */
function openTab(device: MemoryStorage, id: string) {
  const lessons = new SavedLessons(device);
  const saved = lessons.read(id);
  if (saved === null) throw new Error(`no lesson ${id}`);
  const draft = new LessonDraft(saved.lesson, saved.solutions);
  const timers: (() => void)[] = [];
  const later = (run: () => void) => void timers.push(run);
  const autosave = new LessonAutosave({ lessons, draft, now: () => 5, later }, saved);
  autosave.start();
  return {
    draft,
    autosave,
    lessons,
    state: () => autosave.store.getState(),
    wait: () => {
      for (const run of timers.splice(0)) run();
    },
  };
}

describe("the autosave", () => {
  function setUp() {
    const device = new MemoryStorage();
    new SavedLessons(device).write(entry("a"));
    return { device, tab: openTab(device, "a") };
  }

  it("saves soon after an edit, and says so", () => {
    const { tab } = setUp();
    tab.draft.edit({ name: "Sensors" });
    expect(tab.state().status).toBe("saving");
    tab.wait();
    expect(tab.state()).toEqual({ id: "a", status: "saved", isFork: false });
    expect(tab.lessons.read("a")?.lesson.name).toBe("Sensors");
  });

  it("saves at once when the editor closes", () => {
    const { tab } = setUp();
    tab.draft.edit({ name: "Sensors" });
    tab.autosave.end();
    expect(tab.lessons.read("a")?.lesson.name).toBe("Sensors");
  });

  it("reports a full device until an edit can be saved", () => {
    const { device, tab } = setUp();
    device.isFull = true;
    tab.draft.edit({ name: "Sensors" });
    tab.wait();
    expect(tab.state().status).toBe("blocked");
    tab.draft.edit({ name: "Sensors 2" });
    expect(tab.state().status).toBe("blocked");
    device.isFull = false;
    tab.wait();
    expect(tab.state().status).toBe("saved");
  });

  it("continues with a copy if another tab saved the lesson", () => {
    const { device, tab } = setUp();
    const other = openTab(device, "a");
    other.draft.edit({ name: "Theirs" });
    other.wait();
    tab.draft.edit({ name: "Mine" });
    tab.wait();
    expect(tab.state()).toMatchObject({ status: "saved", isFork: true });
    expect(tab.state().id).not.toBe("a");
    expect(
      tab.lessons
        .list()
        .map((each) => each.lesson.name)
        .toSorted(),
    ).toEqual(["Mine", "Theirs"]);
    tab.draft.edit({ name: "Mine 2" });
    tab.wait();
    expect(tab.lessons.list()).toHaveLength(2);
  });
});
