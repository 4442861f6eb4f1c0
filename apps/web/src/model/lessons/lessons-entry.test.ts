import { expect, it } from "vitest";
import { setProgram } from "../workspace/workspace-store.ts";
import { LessonsEntry } from "./lessons-entry.ts";
import { lines } from "./missions/mission.ts";
import { lessonsPage } from "./testing/lessons-page.ts";
import { sampleLesson } from "./testing/sample-lesson.ts";

it("keeps the lesson open in the copy of a project that another tab has stored", () => {
  const { ports, challenge, workspace, fork } = lessonsPage();
  new LessonsEntry(ports);
  challenge.setState({ lesson: sampleLesson });
  fork();
  setProgram(workspace, lines("reverse"));
  expect(challenge.getState().lesson).toBe(sampleLesson);
});

it("closes the lesson when a project without one opens", () => {
  const { ports, challenge } = lessonsPage();
  new LessonsEntry(ports);
  challenge.setState({ lesson: sampleLesson });
  ports.projects.begin(sampleLesson.tasks[0]?.mazes[0] ?? fail(), lines("reverse"));
  expect(challenge.getState().lesson).toBeNull();
});

function fail(): never {
  throw new Error("no maze");
}
