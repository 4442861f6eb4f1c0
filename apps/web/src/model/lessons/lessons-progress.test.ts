import { describe, expect, it } from "vitest";
import { LessonsProgress } from "./lessons-progress.ts";
import { LessonsStorage } from "./lessons-storage.ts";
import { lessonsPage } from "./testing/lessons-page.ts";

const solved = { "one-line": { lines: 1, ticks: 600 } };

describe("the progress", () => {
  it("is displayed and stored when a mission is solved, and the better result stays", () => {
    const { ports, storage } = lessonsPage();
    const progress = new LessonsProgress(ports);
    progress.add({ done: solved });
    progress.add({ done: { "one-line": { lines: 2, ticks: 10 } } });
    expect(progress.results.getState()).toEqual({ done: solved, best: {} });
    expect(storage.record.done).toEqual(solved);
  });

  it("follows another tab", () => {
    const { ports, device } = lessonsPage();
    const progress = new LessonsProgress(ports);
    new LessonsStorage(device).add({ done: solved });
    expect(progress.results.getState().done).toEqual({});
    progress.refresh();
    expect(progress.results.getState().done).toEqual(solved);
  });

  it("returns when the student undoes its deletion", () => {
    const { ports, storage, messages } = lessonsPage();
    const progress = new LessonsProgress(ports);
    progress.add({ done: solved, best: { "all-mazes": [4, 900] } });
    progress.delete();
    expect(progress.results.getState()).toEqual({ done: {}, best: {} });
    const [message] = messages();
    expect(message?.text).toBe("missions:path.resetDone");
    message?.action?.run();
    expect(messages()).toEqual([]);
    expect(progress.results.getState()).toEqual({ done: solved, best: { "all-mazes": [4, 900] } });
    expect(storage.record.done).toEqual(solved);
  });

  it("reports that the device is full, and stays on the page", () => {
    const { ports, device, messages } = lessonsPage();
    const progress = new LessonsProgress(ports);
    device.isFull = true;
    progress.add({ done: solved });
    expect(messages()).toMatchObject([{ tone: "bad", text: "missions:card.blocked" }]);
    expect(progress.results.getState().done).toEqual(solved);
  });
});
