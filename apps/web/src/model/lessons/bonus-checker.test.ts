import { lessonOf } from "@corridor/challenge";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { createChallengeStore, noChallenge } from "../challenge/challenge-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../workspace/workspace-store.ts";
import type { BonusAnswer, BonusQuestion } from "../../simulator/protocol/bonus-request.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { LessonsProgress } from "./lessons-progress.ts";
import { LessonsStorage } from "./lessons-storage.ts";
import { challengeOf } from "./missions/mission.ts";
import { bonusMissions, type BonusMissionId } from "./missions/bonus-missions.ts";
import { BonusChecker } from "./bonus-checker.ts";

function openPage(answer: (question: BonusQuestion) => BonusAnswer) {
  vi.useFakeTimers();
  onTestFinished(() => void vi.useRealTimers());
  const challenge = createChallengeStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const storage = new LessonsStorage(new MemoryStorage());
  const asked: BonusQuestion[] = [];
  let emit: (message: FromWorker) => void = () => undefined;
  const simulator = {
    send: () => undefined,
    listen: (listener: (message: FromWorker) => void) => {
      emit = listener;
      return () => undefined;
    },
  };
  const ports = { challenge, workspace, storage, simulator } as unknown as LessonsPorts;
  const checker = new BonusChecker(ports, new LessonsProgress(ports), (question) => {
    asked.push(question);
    return Promise.resolve(answer(question));
  });
  const open = async (id: BonusMissionId) => {
    const mission = bonusMissions.find((each) => each.id === id);
    if (mission === undefined) throw new Error("no bonus mission");
    const document = challengeOf(mission, "Bonus", { task: "Task", short: "Task", hints: [] });
    challenge.setState({ ...noChallenge, lesson: lessonOf(document), mission: id });
    await vi.runAllTimersAsync();
  };
  return {
    challenge,
    workspace,
    asked,
    open,
    emit: (message: FromWorker) => emit(message),
    best: () => storage.record.best,
    status: () => checker.status.getState().status,
  };
}

const solves = (solved: number, ticks: number): BonusAnswer => ({
  kind: "mazes",
  value: { solved, all: 7, ticks, failed: [] },
});

describe("a bonus mission", () => {
  it("is checked when it opens and once after several edits, and stores the best result", async () => {
    let now = solves(3, 900);
    const page = openPage(() => now);
    await page.open("all-mazes");
    expect(page.status()).toMatchObject({ kind: "mazes", result: { solved: 3 } });
    expect(page.best()).toEqual({ "all-mazes": [4, 900] });
    now = solves(2, 10);
    setProgram(page.workspace, { ...firstProgram, rules: [] });
    setProgram(page.workspace, { ...firstProgram, default: "reverse" });
    await vi.runAllTimersAsync();
    expect(page.asked).toHaveLength(2);
    expect(page.status()).toMatchObject({ result: { solved: 2 } });
    expect(page.best()).toEqual({ "all-mazes": [4, 900] });
  });

  it("drops an answer to a program that is no longer there", async () => {
    const page = openPage(() => {
      if (page.asked.length === 1) setProgram(page.workspace, { ...firstProgram, rules: [] });
      return solves(page.asked.length === 1 ? 7 : 1, 100);
    });
    await page.open("all-mazes");
    expect(page.status()).toMatchObject({ result: { solved: 1 } });
    expect(page.best()).toEqual({ "all-mazes": [6, 100] });
  });

  it("runs its own program in the maze that the student draws", async () => {
    const page = openPage(() => ({
      kind: "defeat",
      value: { state: "defeated", seconds: 300, squares: 9 },
    }));
    await page.open("beat-right-wall");
    setMaze(page.workspace, { ...firstMaze, name: "Mine" });
    await vi.runAllTimersAsync();
    expect(page.asked.at(-1)).toMatchObject({
      kind: "defeat",
      maze: { name: "Mine" },
      program: { name: "Bonus" },
    });
    expect(page.best()).toEqual({ "beat-right-wall": [9] });
  });

  it("counts a drive by hand by its bumps, then by its time", async () => {
    const page = openPage(() => solves(0, 0));
    await page.open("fewest-bumps");
    const met = (bumps: number, ticks: number) =>
      page.challenge.setState({ result: { state: "met", driver: "me", ticks, bumps, lines: 0 } });
    met(2, 900);
    expect(page.status()).toEqual({ kind: "hand", bumps: 2, ticks: 900 });
    met(1, 2000);
    met(1, 2500);
    expect(page.best()).toEqual({ "fewest-bumps": [1, 2000] });
    expect(page.asked).toEqual([]);
  });

  it("checks nothing for a mission", async () => {
    const page = openPage(() => solves(1, 1));
    page.challenge.setState({ mission: "one-line" });
    await vi.runAllTimersAsync();
    expect(page.asked).toEqual([]);
  });
});
