import { describe, expect, it } from "vitest";
import { challengeKey } from "../projects/project-storage.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { readReference, StoredLessons, writeReference } from "./stored-lessons.ts";
import { sampleLesson } from "./testing/sample-lesson.ts";

const open = (device: MemoryStorage) => new StoredLessons(device);

describe("the lessons on the device", () => {
  it("are stored once each, with their solved tasks, and survive a reload", () => {
    const device = new MemoryStorage();
    const { id, isStored } = open(device).add(sampleLesson);
    expect(isStored).toBe(true);
    expect(open(device).addSolved({ lesson: id, index: 2 })).toBe(true);
    const reloaded = open(device);
    expect(reloaded.add(sampleLesson).id).toBe(id);
    expect(reloaded.lesson(id)).toEqual(sampleLesson);
    expect(reloaded.solved(id, sampleLesson)).toEqual([false, false, true]);
  });

  it("are others after any change of their content", () => {
    const device = new MemoryStorage();
    const { id } = open(device).add(sampleLesson);
    expect(open(device).add({ ...sampleLesson, name: "Other" }).id).not.toBe(id);
  });

  it("last until the page closes on a device without room, and say so", () => {
    const device = new MemoryStorage();
    device.setItem = () => {
      throw new Error("full");
    };
    const lessons = open(device);
    const { id, isStored } = lessons.add(sampleLesson);
    expect(isStored).toBe(false);
    expect(lessons.addSolved({ lesson: id, index: 0 })).toBe(false);
    expect(lessons.solved(id, sampleLesson)).toEqual([true, false, false]);
    expect(lessons.lesson(id)).toEqual(sampleLesson);
  });

  it("are deleted with the last project that works on them", () => {
    const device = new MemoryStorage();
    const lessons = open(device);
    const { id } = lessons.add(sampleLesson);
    const other = lessons.add({ ...sampleLesson, name: "Other" }).id;
    device.setItem(challengeKey("project"), writeReference({ lesson: id, index: 1 }));
    lessons.sweep();
    expect(lessons.lesson(id)).toEqual(sampleLesson);
    expect(lessons.lesson(other)).toBeNull();
  });

  it.each(["", "{", "[]", '{"text":1}', '{"text":"{}","solved":"x"}'])(
    "are none in damaged text %j",
    (text) => {
      const device = new MemoryStorage();
      device.setItem("corridor.lesson.a0", text);
      expect(open(device).lesson("a0")).toBeNull();
      expect(open(device).solved("a0", sampleLesson)).toEqual([false, false, false]);
    },
  );
});

it("a reference names its task, and no other text does", () => {
  const place = { lesson: "0a1b2c3d4", index: 11 };
  expect(readReference(writeReference(place))).toEqual(place);
  for (const text of ["", "task", "task xyz 1", "task 0a 123", "1AbC", '{"format":""}']) {
    expect(readReference(text)).toBeNull();
  }
});
