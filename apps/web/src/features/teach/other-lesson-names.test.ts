import { lessonMark } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import i18next from "i18next";
import { expect, it, vi } from "vitest";
import type { SavedLesson } from "../../model/teaching/saved-lessons.ts";
import teach from "../../text/en/teach.json" with { type: "json" };
import type { HandInRow } from "./check-hand-ins.ts";
import { entriesOf } from "./hand-in-entries.ts";
import { hasOtherLesson, otherLessonNames } from "./other-lesson-names.ts";
import { problemSentence } from "./problem-sentence.ts";
import { programOf, sampleLesson } from "./testing/sample-lesson.ts";

/** The row of a code. @param mark of its lesson */
function rowOf(mark: string): HandInRow {
  const attempt = programOf("right-wall", "Juniper");
  const code = encodeLink({ completion: { lesson: mark, task: 0, attempt } });
  const [entry] = entriesOf([], code.ok ? code.text : "", sampleLesson);
  if (entry?.read.ok !== false) throw new Error("the code belongs to the lesson");
  return { number: 1, source: entry.source, title: "", sameAs: null, checked: entry.read };
}

it("a code of another lesson of this device names that lesson, any other does not", async () => {
  const other = { ...sampleLesson, name: "Every maze" };
  const lessons = { list: () => [{ lesson: other } as SavedLesson] };
  await i18next.init({ lng: "en", resources: { en: { teach } } });
  const sentences = [lessonMark(other), "000000000"].map((mark) => {
    const row = rowOf(mark);
    const names = otherLessonNames(hasOtherLesson([row]), lessons);
    return row.checked.ok
      ? ""
      : problemSentence(i18next.getFixedT("en", "teach"), row.checked, names);
  });
  expect(sentences).toEqual([
    "Not checked: this code is from the lesson “Every maze”.",
    "Not checked: this code is not from this lesson.",
  ]);
});

it("no lesson is read while every code belongs to the open lesson", () => {
  const list = vi.fn<() => SavedLesson[]>(() => []);
  otherLessonNames(hasOtherLesson([]), { list });
  expect(list).not.toHaveBeenCalled();
});
