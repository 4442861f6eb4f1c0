import { describe, expect, it } from "vitest";
import { taskWith } from "../testing/teacher-task.ts";
import {
  toggled,
  withGoal,
  withGoalKind,
  withSeconds,
  withDriver,
  withUnseen,
} from "./task-edits.ts";

describe("an edit of a task keeps its fields consistent", () => {
  it("the time limit covers the time that the robot must last", () => {
    const task = withSeconds(withGoalKind(taskWith(), "last"), 20);
    expect(task.goal).toEqual({ kind: "last", seconds: 20 });
    expect(withGoal(task, { kind: "last", seconds: 50 }).checks.seconds).toBe(50);
  });

  it("the reading at which the robot stops has a lower and an upper bound", () => {
    const task = withGoalKind(taskWith(), "stop");
    const goal = { kind: "stop", sensor: "front", from: 40, to: 60 } as const;
    expect(withGoal(task, { ...goal, from: 80 }).goal).toEqual({ ...goal, from: 80, to: 80 });
    expect(withGoal(task, { ...goal, to: 20 }).goal).toEqual({ ...goal, from: 20, to: 20 });
  });

  it("no more unseen mazes have to pass than there are", () => {
    const task = withUnseen(taskWith(), { count: 10 });
    expect(task.unseen).toMatchObject({ kind: "tree", count: 10, pass: 10 });
  });
});

describe("the drivers of a task", () => {
  it("are a program alone in a new task, until the teacher allows more", () => {
    expect(taskWith().allowed.drivers).toEqual(["program"]);
    expect(withDriver(taskWith(), "me").allowed.drivers).toEqual(["program", "me"]);
  });

  it("begin with the program again after it was left out for a while", () => {
    const byHand = withDriver(withDriver(taskWith(), "me"), "program");
    expect(byHand.allowed.drivers).toEqual(["me"]);
    expect(withDriver(byHand, "program").allowed.drivers).toEqual(["program", "me"]);
  });

  it("stay in their order when another one is allowed", () => {
    const { allowed } = taskWith();
    const mission = taskWith({ allowed: { ...allowed, drivers: ["me", "program"] } });
    expect(withDriver(mission, "remote").allowed.drivers).toEqual(["me", "program", "remote"]);
  });
});

describe("a list of what is allowed", () => {
  it("changes by one entry, in the order of all", () => {
    const all = ["a", "b", "c"] as const;
    expect(toggled(all, null, "b")).toEqual(["a", "c"]);
    expect(toggled(all, ["c"], "a")).toEqual(["a", "c"]);
    expect(toggled(all, null, "c", ["a"])).toEqual(["a", "c"]);
  });
});
