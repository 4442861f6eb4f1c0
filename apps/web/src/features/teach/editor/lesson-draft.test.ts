import { lessonMark } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { programOf } from "../testing/sample-lesson.ts";
import { MemoryStorage } from "../../../model/storage/testing/memory-storage.ts";
import { withoutBlankTexts } from "../../../model/teaching/blank-texts.ts";
import { SharedLessons } from "../../../model/teaching/shared-lessons.ts";
import { solutionOf } from "../../../model/teaching/solution.ts";
import { corridor, lessonWith, taskWith } from "../testing/teacher-task.ts";
import { LessonDraft } from "./lesson-draft.ts";
import { addQuestion } from "./task-list-edits.ts";

function open() {
  const shared = new SharedLessons(new MemoryStorage());
  const lesson = lessonWith(taskWith({ name: "One" }), taskWith({ name: "Two" }));
  const draft = new LessonDraft(lesson, new Map(), (each) => shared.has(each));
  return {
    draft,
    shared,
    state: () => draft.store.getState(),
    names: () => draft.lesson.tasks.map(({ name }) => name),
  };
}

describe("the history of a lesson", () => {
  it("undoes and redoes edits of the lesson, its tasks and its mazes in their order", () => {
    const { draft } = open();
    const before = draft.lesson;
    draft.edit({ name: "Sensors" });
    draft.openTask(1);
    draft.editTask({ name: "Second" });
    draft.setMaze({ ...corridor, goals: [] });
    const after = draft.lesson;
    for (let step = 0; step < 3; step++) draft.undo();
    expect(draft.lesson).toEqual(before);
    for (let step = 0; step < 5; step++) draft.redo();
    expect(draft.lesson).toEqual(after);
  });

  it("has one step for what is typed into a field, until the field is left", () => {
    const { draft, state } = open();
    for (const name of ["S", "Se", "Sensors"]) draft.edit({ name }, "name");
    draft.endGroup();
    draft.edit({ name: "Sensors 2" }, "name");
    draft.edit({ intro: "Look." }, "intro");
    expect(state().past).toHaveLength(3);
    draft.undo();
    draft.undo();
    expect(draft.lesson.name).toBe("Sensors");
  });

  it("opens the task of the edit that it reverts", () => {
    const { draft, state } = open();
    draft.openTask(1);
    draft.editTask({ name: "Second" });
    draft.openTask(0);
    draft.undo();
    expect(state()).toMatchObject({ task: 1, maze: 0 });
  });

  it("ends with a new edit what could be redone", () => {
    const { draft, state } = open();
    draft.edit({ name: "A" });
    draft.undo();
    draft.edit({ name: "B" });
    expect(state().future).toEqual([]);
  });
});

describe("the tasks of a lesson", () => {
  it("are added, moved and deleted, and retain their identity", () => {
    const { draft, state, names } = open();
    const [one, two] = state().taskIds;
    draft.addTasks([taskWith({ name: "Between" })]);
    expect(names()).toEqual(["One", "Between", "Two"]);
    expect(state().task).toBe(1);
    draft.moveTask(1);
    draft.moveTask(1);
    expect(names()).toEqual(["One", "Two", "Between"]);
    draft.removeTask(0);
    expect(state()).toMatchObject({ task: 1, taskIds: [two, expect.any(Number)] });
    draft.undo();
    expect(state().taskIds.slice(0, 2)).toEqual([one, two]);
  });

  it("are at least one and at most twelve", () => {
    const { draft, names } = open();
    for (let count = 0; count < 20; count++) draft.addTasks([taskWith()]);
    expect(names()).toHaveLength(12);
    for (let count = 0; count < 20; count++) draft.removeTask(0);
    expect(names()).toHaveLength(1);
  });

  it("are added together or not at all, as one step", () => {
    const { draft, names } = open();
    const nine = Array.from({ length: 9 }, (_, at) => taskWith({ name: `New ${at}` }));
    expect(draft.addTasks(nine)).toBe(true);
    expect(names()).toHaveLength(11);
    expect(names().slice(0, 3)).toEqual(["One", "New 0", "New 1"]);
    expect(draft.addTasks(nine.slice(0, 2))).toBe(false);
    expect(names()).toHaveLength(11);
    draft.undo();
    expect(names()).toEqual(["One", "Two"]);
  });

  it("have one to ten mazes", () => {
    const { draft, state } = open();
    for (let count = 0; count < 20; count++) draft.addMaze(corridor);
    expect(draft.task.mazes).toHaveLength(10);
    expect(state().maze).toBe(9);
    for (let count = 0; count < 20; count++) draft.removeMaze();
    expect(draft.task.mazes).toHaveLength(1);
    expect(state().maze).toBe(0);
  });
});

describe("a solved task", () => {
  const program = programOf("right-wall", "Mine");

  it("gets the reference values of the solution, and stays solved", () => {
    const { draft, state } = open();
    const solved = draft.startTrial("solve");
    solved(draft.task, { lines: 3, ticks: 400, program });
    // 5.09 s, which the clock displays as 5.0.
    solved(draft.task, { lines: 2, ticks: 305, program });
    expect(draft.task.par).toEqual({ lines: 2, seconds: 5 });
    expect(solutionOf(state().solutions, draft.task)).toMatchObject({ lines: 2 });
  });

  it("gets the reference values of a program after a drive by hand, and after a trial", () => {
    const { draft, state } = open();
    const before = lessonMark(draft.lesson);
    draft.startTrial("solve")(draft.task, { lines: 0, ticks: 302, program: null });
    draft.startTrial("try")(draft.task, { lines: 5, ticks: 900, program });
    // The trial has shown a completion code of this lesson.
    expect(lessonMark(draft.lesson)).toBe(before);
    expect(solutionOf(state().solutions, draft.task)).toMatchObject({ lines: 5 });
    draft.startTrial("solve")(draft.task, { lines: 2, ticks: 305, program });
    expect(draft.task.par).toEqual({ lines: 2, seconds: 5 });
  });

  it("stays the same lesson when it is solved after students received it", () => {
    const { draft, state, shared } = open();
    // Students do not receive a blank hint.
    draft.editTask({ words: { ...draft.task.words, hints: [" "] } });
    shared.add(withoutBlankTexts(draft.lesson));
    const mark = lessonMark(draft.lesson);
    const solved = draft.startTrial("solve");
    for (const task of draft.lesson.tasks) solved(task, { lines: 2, ticks: 305, program });
    expect(lessonMark(draft.lesson)).toBe(mark);
    expect(solutionOf(state().solutions, draft.task)).not.toBeNull();
  });

  it("gets reference values again once its teacher edits the shared lesson", () => {
    const { draft, shared } = open();
    shared.add(draft.lesson);
    draft.edit({ name: "Another" });
    const solved = draft.startTrial("solve");
    for (const task of draft.lesson.tasks) solved(task, { lines: 2, ticks: 305, program });
    expect(draft.lesson.tasks.map(({ par }) => par?.lines)).toEqual([2, 2]);
  });

  it("gets new reference values after an edit", () => {
    const { draft } = open();
    draft.startTrial("solve")(draft.task, { lines: 2, ticks: 305, program });
    draft.setMaze({ ...corridor, goals: [{ column: 4, row: 1 }] });
    draft.startTrial("solve")(draft.task, { lines: 1, ticks: 245, program });
    expect(draft.task.par).toEqual({ lines: 1, seconds: 4 });
  });

  it("is not solved after an edit of its maze, until undo", () => {
    const { draft, state } = open();
    draft.startTrial("solve")(draft.task, { lines: 0, ticks: 302, program: null });
    expect(draft.task.par).toBeNull();
    draft.setMaze({ ...corridor, goals: [{ column: 4, row: 1 }] });
    expect(solutionOf(state().solutions, draft.task)).toBeNull();
    draft.undo();
    expect(solutionOf(state().solutions, draft.task)).not.toBeNull();
  });
});

it("a question has an id that no other question has", () => {
  let { lesson } = open().draft;
  for (const question of ["a", "b", "c"]) lesson = addQuestion(lesson, question);
  lesson = addQuestion({ ...lesson, survey: lesson.survey.toSpliced(0, 1) }, "d");
  expect(lesson.survey.map(({ id }) => id)).toEqual(["question_2", "question_3", "question_4"]);
});
