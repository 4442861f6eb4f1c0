import { describe, expect, it } from "vitest";
import type { BonusQuestion, SolvedTrail } from "../../simulator/protocol/bonus-request.ts";
import { firstMaze } from "../../simulator/protocol/first-project.ts";
import { SolvedTrails } from "./solved-trails.ts";
import { lines } from "./missions/mission.ts";
import { lessonsPage } from "./testing/lessons-page.ts";

/** A page with stored programs of two missions, and a worker with this answer. */
function solvedPage(value: SolvedTrail | null) {
  const { ports, storage } = lessonsPage();
  const add = (mission: string, start: Parameters<typeof lines>[0]): void => {
    ports.projects.beginNew(firstMaze, lines(start));
    storage.add({ works: { [mission]: ports.projects.currentId() } });
  };
  add("one-line", "forward");
  add("right-wall", "reverse");
  const asked: BonusQuestion[] = [];
  const trails = new SolvedTrails(ports, async (question) => {
    asked.push(question);
    return { kind: "trail", value };
  });
  return { trails, asked };
}

describe("the trail for the picture at the end", () => {
  it("is searched from the last mission to the first, in the programs on the device", async () => {
    const trail = { maze: firstMaze, pose: { x: 1, y: 2, heading: 3 }, points: [1, 2] };
    const { trails, asked } = solvedPage(trail);
    expect(await trails.last()).toBe(trail);
    const attempts = asked.flatMap((question) =>
      question.kind === "trail" ? question.attempts : [],
    );
    expect(attempts.map(({ program }) => program.default)).toEqual(["reverse", "forward"]);
  });

  it("is empty, at the start of the last mission, if no program reaches its goal", async () => {
    const { trails } = solvedPage(null);
    const { maze, pose, points } = await trails.last();
    expect(points).toEqual([]);
    expect([pose.x, pose.y]).toEqual([100 * maze.start.column + 50, 100 * maze.start.row + 50]);
  });
});
