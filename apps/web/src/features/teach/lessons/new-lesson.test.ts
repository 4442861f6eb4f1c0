import { parseLesson } from "@corridor/challenge";
import { encodeLink, type LinkContent } from "@corridor/link";
import { describe, expect, it } from "vitest";
import { programOf } from "../testing/sample-lesson.ts";
import { corridor } from "../testing/teacher-task.ts";
import { lessonOfMazeLink } from "./new-lesson.ts";

function linkTo(content: LinkContent): string {
  const link = encodeLink(content);
  return link.ok ? `https://corridor.example/#${link.text}` : "";
}

describe("a lesson that begins with a shared maze", () => {
  it("has the maze, and the program that is shared with it", () => {
    const program = programOf("right-wall", "Mine");
    expect(lessonOfMazeLink(linkTo({ maze: corridor }), "Task 1")).toMatchObject({
      name: "Corridor",
      tasks: [{ name: "Task 1", mazes: [corridor], program: null }],
    });
    const lesson = lessonOfMazeLink(linkTo({ maze: corridor, program }), "Task 1");
    expect(lesson?.tasks[0]?.program).toEqual(program);
    expect(parseLesson(lesson).ok).toBe(true);
  });

  it("allows the lines of a long program", () => {
    const { rules, ...program } = programOf("right-wall", "Mine");
    const long = { ...program, rules: Array.from({ length: 12 }, () => rules.slice(0, 1)).flat() };
    const lesson = lessonOfMazeLink(linkTo({ maze: corridor, program: long }), "Task 1");
    expect(lesson?.tasks[0]?.allowed.lines).toBe(12);
    expect(parseLesson(lesson).ok).toBe(true);
  });

  it.each(["", "nonsense", linkTo({ program: programOf("right-wall", "Mine") })])(
    "does not begin with the link %j",
    (link) => {
      expect(lessonOfMazeLink(link, "Task 1")).toBe(null);
    },
  );
});
