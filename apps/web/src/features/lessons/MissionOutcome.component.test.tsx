import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import type { MazeDocument } from "@corridor/maze";
import { Recording } from "@corridor/recording";
import { expect, it } from "vitest";
import { page } from "vitest/browser";
import { timelineOf } from "../../model/run/timeline-of.ts";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import { ChallengeLine } from "./ChallengeLine.tsx";
import { MissionOutcome } from "./MissionOutcome.tsx";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Corridor",
  blocks: ["..."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 1, row: 0 }],
};

/** A script that drives for half a second after it made the robot wait for a second. */
function scripted(): Recording {
  const recording = new Recording(maze, {
    format: "corridor/program",
    version: 1,
    name: "None",
    rules: [],
    default: "stop",
  });
  recording.addInput({ do: "driver", driver: "remote" });
  for (let tick = 0; tick < 60; tick++) recording.step();
  recording.addInput({ do: "command", command: { action: "forward" }, seq: 1 });
  for (let tick = 0; tick < 30; tick++) recording.step();
  return recording;
}

it("states the time without a script's waiting, which the page receives after the result", async () => {
  const task = taskIn([maze]);
  const { challenge, timeline } = await renderWithServices(
    <>
      <ChallengeLine />
      <MissionOutcome task={task} />
    </>,
  );
  timelineOf(timeline);
  challenge.setState({
    lesson: lessonOfTasks("One task", [task]),
    result: { state: "met", driver: "remote", ticks: 90, bumps: 0, lines: 0 },
  });
  const text = page.getByText("Task solved after 1.5 s");
  await expect.element(text.first()).toBeVisible();
  const delta = scripted().timeline.takeDelta();
  if (delta !== null) timeline.add(delta);
  await expect.poll(() => page.getByText("Task solved after 0.5 s").elements()).toHaveLength(2);
});
