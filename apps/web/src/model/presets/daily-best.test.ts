import { dailyMaze, dayAfter } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { bestOf, dayOfMaze, EARLIER_DAYS, noteDaily, utcDay } from "./daily-best.ts";

const today = { year: 2026, month: 3, day: 1 };
const maze = dailyMaze(today, "Maze of 1 March 2026");

describe("the best result of the day", () => {
  it("is the shortest run, then the one with fewer bumps", () => {
    const storage = new MemoryStorage();
    expect(bestOf(storage, today)).toBeNull();
    noteDaily(storage, maze, { ticks: 600, bumps: 2 }, today);
    noteDaily(storage, maze, { ticks: 700, bumps: 0 }, today);
    expect(bestOf(storage, today)).toEqual({ ticks: 600, bumps: 2 });
    noteDaily(storage, maze, { ticks: 600, bumps: 1 }, today);
    noteDaily(storage, maze, { ticks: 500, bumps: 5 }, today);
    expect(bestOf(storage, today)).toEqual({ ticks: 500, bumps: 5 });
  });

  it("belongs to the day of the maze, under any name", () => {
    const storage = new MemoryStorage();
    const yesterday = dayAfter(today, -1);
    noteDaily(storage, dailyMaze(yesterday, "Mine"), { ticks: 60, bumps: 0 }, today);
    expect(bestOf(storage, yesterday)).toEqual({ ticks: 60, bumps: 0 });
    expect(bestOf(storage, today)).toBeNull();
  });

  it("is not noted for another maze, one with another goal, or one too old", () => {
    const storage = new MemoryStorage();
    const run = { ticks: 60, bumps: 0 };
    noteDaily(storage, { ...maze, goals: [] }, run, today);
    const old = dayAfter(today, -EARLIER_DAYS - 1);
    noteDaily(storage, dailyMaze(old, "Old"), run, today);
    expect(dayOfMaze(dailyMaze(old, "Old"), today)).toBeNull();
    expect(bestOf(storage, old)).toBeNull();
    expect(bestOf(storage, today)).toBeNull();
  });

  it("deletes days that can no longer be chosen, and ignores unreadable text", () => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.daily", "{");
    noteDaily(storage, maze, { ticks: 60, bumps: 0 }, today);
    const later = dayAfter(today, EARLIER_DAYS + 1);
    noteDaily(storage, dailyMaze(later, ""), { ticks: 50, bumps: 0 }, later);
    expect(bestOf(storage, today)).toBeNull();
    expect(bestOf(storage, later)).toEqual({ ticks: 50, bumps: 0 });
    storage.setItem("corridor.daily", `{"2026-03-01":{"ticks":"fast"},"x":null}`);
    expect(bestOf(storage, today)).toBeNull();
  });

  it("takes the date in UTC", () => {
    expect(utcDay(new Date("2026-03-01T23:59:59-05:00"))).toEqual({
      year: 2026,
      month: 3,
      day: 2,
    });
  });
});
