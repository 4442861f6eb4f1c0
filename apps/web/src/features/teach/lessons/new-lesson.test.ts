import { parseLesson } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { programOf } from "../testing/sample-lesson.ts";
import { corridor } from "../testing/teacher-task.ts";
import { emptyTaskMaze, lessonOfMaze, newTask } from "./new-lesson.ts";

describe("a new task", () => {
  it("asks for a program, because a drive by hand passes without a line", () => {
    expect(newTask(emptyTaskMaze("Empty"), "Task 1").allowed.drivers).toEqual(["program"]);
  });

  it("hides no tool and no help", () => {
    expect(newTask(emptyTaskMaze("Empty"), "Task 1").allowed).toMatchObject({
      tools: null,
      help: null,
    });
  });
});

describe("a lesson that begins with a shared maze", () => {
  it("has the maze, and the program that is shared with it", () => {
    const program = programOf("right-wall", "Mine");
    expect(lessonOfMaze({ maze: corridor }, "Task 1")).toMatchObject({
      name: "Corridor",
      tasks: [{ name: "Task 1", mazes: [corridor], program: null }],
    });
    const lesson = lessonOfMaze({ maze: corridor, program }, "Task 1");
    expect(lesson?.tasks[0]?.program).toEqual(program);
    expect(parseLesson(lesson).ok).toBe(true);
  });

  it("allows the lines of a long program", () => {
    const { rules, ...program } = programOf("right-wall", "Mine");
    const long = { ...program, rules: Array.from({ length: 12 }, () => rules.slice(0, 1)).flat() };
    const lesson = lessonOfMaze({ maze: corridor, program: long }, "Task 1");
    expect(lesson?.tasks[0]?.allowed.lines).toBe(12);
    expect(parseLesson(lesson).ok).toBe(true);
  });

  it("does not begin with a program alone", () => {
    expect(lessonOfMaze({ program: programOf("right-wall", "Mine") }, "Task 1")).toBe(null);
  });
});
