import { expect, it } from "vitest";
import { ScreenPriority, type ScreenChoices } from "./screen-priority.ts";

const nothing: ScreenChoices = { student: null, race: null, task: null };

/** A device that knows nothing of the others. */
class Device extends ScreenPriority {
  at(now: number, chosen: ScreenChoices = nothing): number {
    return this.of(chosen, now, null);
  }
}

it.each([
  ["a task", { task: 2 }],
  ["the run of a student", { student: 7 }],
  ["the maze of a race", { race: { task: 1, maze: "g2" } }],
])("a device on which nothing is chosen does not replace %s", (_name, choice) => {
  const laptop = new Device();
  const phone = new Device();
  laptop.at(100);
  const chosen = { ...nothing, ...choice };
  const shown = laptop.at(200, chosen);
  expect(phone.at(300)).toBeLessThan(shown);
  expect(phone.at(400)).toBeLessThan(laptop.at(500, chosen));
});

it("the device on which the teacher chose last controls the screens", () => {
  const laptop = new Device();
  const phone = new Device();
  const onLaptop = { ...nothing, student: 7 };
  expect(phone.at(300, { ...nothing, task: 2 })).toBeGreaterThan(laptop.at(200, onLaptop));
  // The end of a choice is one, too.
  expect(laptop.at(400)).toBeGreaterThan(300);
});

it("the device that opened first controls the screens until the teacher chooses", () => {
  const laptop = new Device();
  const phone = new Device();
  expect(laptop.at(100)).toBeGreaterThan(phone.at(200));
  expect(laptop.at(300)).toBeGreaterThan(phone.at(300));
});

it("a choice controls the screens, also if the clock of the device is behind", () => {
  const laptop = new ScreenPriority();
  laptop.of(nothing, 100, null);
  expect(laptop.of({ ...nothing, student: 7 }, 200, 250)).toBeGreaterThan(250);
});

it("a device loses the screens to a newer choice on another one, and not to its own", () => {
  const laptop = new Device();
  expect(laptop.isLost(500)).toBe(false);
  const own = laptop.at(200, { ...nothing, student: 7 });
  for (const displayed of [null, -100, own]) expect(laptop.isLost(displayed)).toBe(false);
  expect(laptop.isLost(300)).toBe(true);
});

it("a run that another device ends is no choice, but the next one is", () => {
  const laptop = new Device();
  const own = laptop.at(200, { ...nothing, student: 7 });
  laptop.endRun();
  expect(laptop.at(400)).toBe(own);
  expect(laptop.at(500, { ...nothing, student: 7 })).toBe(500);
});
