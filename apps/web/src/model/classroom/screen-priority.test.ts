import { expect, it } from "vitest";
import { ScreenPriority, type ScreenChoices } from "./screen-priority.ts";

const nothing: ScreenChoices = { student: null, race: null, task: null };

it.each([
  ["a task", { task: 2 }],
  ["the run of a student", { student: 7 }],
  ["the maze of a race", { race: { task: 1, maze: "g2" } }],
])("a device on which nothing is chosen does not replace %s", (_name, choice) => {
  const laptop = new ScreenPriority();
  const phone = new ScreenPriority();
  laptop.of(nothing, 100);
  const chosen = { ...nothing, ...choice };
  const shown = laptop.of(chosen, 200);
  expect(phone.of(nothing, 300)).toBeLessThan(shown);
  expect(phone.of(nothing, 400)).toBeLessThan(laptop.of(chosen, 500));
});

it("the device on which the teacher chose last controls the screens", () => {
  const laptop = new ScreenPriority();
  const phone = new ScreenPriority();
  const onLaptop = { ...nothing, student: 7 };
  expect(phone.of({ ...nothing, task: 2 }, 300)).toBeGreaterThan(laptop.of(onLaptop, 200));
  // The end of a choice is one, too.
  expect(laptop.of(nothing, 400)).toBeGreaterThan(300);
});

it("the device that opened first controls the screens until the teacher chooses", () => {
  const laptop = new ScreenPriority();
  const phone = new ScreenPriority();
  expect(laptop.of(nothing, 100)).toBeGreaterThan(phone.of(nothing, 200));
  expect(laptop.of(nothing, 300)).toBeGreaterThan(phone.of(nothing, 300));
});
