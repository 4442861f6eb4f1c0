import { isBlock, type MazeDocument } from "@corridor/maze";
import { renderToStaticMarkup } from "react-dom/server";
import { createElement } from "react";
import { describe, expect, it } from "vitest";
import { MissionPicture } from "./MissionPicture.tsx";
import { chapterIds, chapters } from "../../model/lessons/missions/chapters.ts";
import { ideas, type Mark, type Point } from "../../model/lessons/missions/ideas.ts";
import { missionIds } from "../../model/lessons/missions/mission.ts";
import { missions } from "../../model/lessons/missions/missions.ts";

describe("the chapters", () => {
  it("contain every mission once, in order", () => {
    expect(chapterIds.flatMap((id) => chapters[id])).toEqual(missionIds);
    expect(chapterIds.length).toBeGreaterThanOrEqual(3);
    expect(chapterIds.length).toBeLessThanOrEqual(5);
  });
});

function picture({ id, challenge }: (typeof missions)[number]): string {
  return renderToStaticMarkup(
    createElement(MissionPicture, { mazes: challenge.mazes, ideas: ideas[id] }),
  );
}

/** Points along a mark that crosses the path of the robot or of a beam. */
function pointsOf(mark: Mark): Point[] {
  const corners =
    mark.kind === "path" ? mark.points : mark.kind === "beam" ? [mark.from, mark.to] : [];
  return corners.slice(1).flatMap((to, at) => {
    const from = corners[at] ?? to;
    // Not the very end: a beam ends at a wall.
    return [0, 0.25, 0.5, 0.75, 0.99].map((part): Point => [
      from[0] + (to[0] - from[0]) * part,
      from[1] + (to[1] - from[1]) * part,
    ]);
  });
}

function isOpen(maze: MazeDocument, [x, y]: Point): boolean {
  return !isBlock(maze, Math.floor(x), Math.floor(y));
}

describe("the thumbnails", () => {
  it("are all different, also where the names of the colours are left out", () => {
    const pictures = missions.map(picture).map((text) => text.replaceAll(/ class="[^"]*"/g, ""));
    expect(new Set(pictures).size).toBe(missions.length);
  });

  it.each(missions.map((mission) => [mission.id, mission] as const))(
    "%s: robot, paths and beams are in open squares",
    (id, { challenge }) => {
      expect(ideas[id].length).toBeGreaterThan(0);
      expect(ideas[id].length).toBeLessThanOrEqual(challenge.mazes.length);
      for (const [at, { robot, marks }] of ideas[id].entries()) {
        const maze = challenge.mazes[at];
        if (maze === undefined) throw new Error("no maze");
        const points = marks.flatMap(pointsOf);
        const blocked = [...points, ...(robot === null ? [] : [robot.at])].filter(
          (point) => !isOpen(maze, point),
        );
        expect(blocked).toEqual([]);
        const slanted = marks.filter(
          (mark) =>
            mark.kind === "beam" && mark.from[0] !== mark.to[0] && mark.from[1] !== mark.to[1],
        );
        expect(slanted).toEqual([]);
      }
    },
  );
});
