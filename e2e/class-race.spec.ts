/** The race of a class in a maze that the teacher chooses, on the dashboard and the big screen. */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { answers } from "../apps/web/src/model/lessons/missions/testing/answers.ts";
import { sampleLesson, sampleTask } from "../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { wideWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...wideWindow });

const task = {
  ...sampleTask("every-maze", "Every maze"),
  unseen: { kind: "tree", columns: 11, rows: 11, seed: 7, count: 50, pass: 1 } as const,
};
const tasks = [task, sampleTask("one-line", "One line")];
const lesson: LessonDocument = { ...sampleLesson, name: "Races", tasks };
/** A big screen of fewer pixels: the robots of a race move all the time. */
const smallScreen = { viewport: { width: 960, height: 540 } };

/** Joins, and claims the task with the solution of the mission. */
async function joinAndSolve(relay: string, code: string): Promise<ScriptedStudent> {
  const mark = lessonMark(lesson);
  const student = await ScriptedStudent.join(relay, code);
  const { solution } = answers["every-maze"];
  const link = encodeLink({ completion: { lesson: mark, task: 0, attempt: solution } });
  if (!link.ok) throw new Error(link.code);
  student.report({ kind: "opened", lesson: mark, task: 1 });
  student.report({ kind: "solved", task: 1, lines: 2, code: link.text });
  return student;
}

test("a race takes place in the maze that the teacher chooses, also on the big screen, and ends when the results of another task are shown", async ({
  page,
  relay,
  openWindow,
}) => {
  const teacher = await ClassTeacher.start(relay, null, lesson);
  await page.goto(`/class/${teacher.created.id}#${teacher.created.teacherKey}`);
  const { page: screen } = await openWindow(smallScreen);
  await screen.goto(`${relay}/class/${teacher.created.id}#${teacher.created.screenKey}`);
  const students = [
    await joinAndSolve(relay, teacher.code),
    await joinAndSolve(relay, teacher.code),
  ];
  const result = /^Robot 1: \d+\.\d s, \d lines, 2 students$/;
  const race = { name: "Race: 2 robots, one maze" };
  await test.step("a race on the big screen ends when the results of another task are shown", async () => {
    const results = page.getByRole("combobox", { name: "Task of the results" });
    await screen.getByRole("button", race).click();
    await expect(screen.getByText("0 of 2 at the goal")).toBeVisible();
    await results.selectOption("Task 2 of 2");
    await expect(screen.getByText("0 of 2 solved")).toBeVisible();
    await expect(screen.getByRole("button", { name: "Close race" })).toHaveCount(0);
    await expect(screen.getByText("Where robots bump")).toBeVisible();
    await results.selectOption("Task 1 of 2");
  });
  await screen.getByRole("button", race).click();
  await expect(screen.getByText(result)).toBeVisible();
  const first = await screen.getByText(result).textContent();
  await page.getByRole("button", race).click();
  const dialog = page.getByRole("dialog", { name: "Race" });
  const choice = dialog.getByRole("combobox", { name: "Maze" });
  await expect(choice.getByRole("option")).toHaveText([
    ...task.mazes.map((_, at) => `Maze ${at + 1}`),
    ...Array.from({ length: 10 }, (_, at) => `Tree ${at + 1} of seed 7`),
  ]);
  // The second maze is the mirror of the first one.
  await choice.selectOption("Maze 3");
  await expect(screen.getByText("0 of 2 at the goal")).toBeVisible();
  await expect(dialog.getByText(result)).toBeVisible();
  const time = await dialog.getByText(result).textContent();
  expect(time).not.toBe(first);
  await expect(screen.getByText(time ?? "", { exact: true })).toBeVisible();
  await choice.selectOption("Tree 1 of seed 7");
  await expect(screen.getByText("0 of 2 at the goal")).toBeVisible();
  await expectNoAxeViolations(page, "race in a chosen maze");
  await page.setViewportSize({ width: 320, height: 700 });
  await expect.poll(() => horizontalOverflow(page)).toEqual([]);
  for (const student of students) student.close();
});
