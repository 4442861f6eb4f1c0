/** The line and the figures that the page displays where a run has ended. */
import { encodeLink } from "@corridor/link";
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...smallWindow });

test("names the line that drove into the wall everywhere, until the run goes on", async ({
  corridor,
}) => {
  const link = encodeLink({
    maze: {
      format: "corridor/maze",
      version: 1,
      name: "Dead end",
      blocks: ["#######", "#.....#", "#######"],
      start: { column: 1, row: 1, heading: "east" },
      goals: [],
    },
    program: {
      format: "corridor/program",
      version: 1,
      name: "Too late",
      default: "forward",
      // True only where the robot touches the wall already.
      rules: [{ when: { sensor: "front", is: "<", than: 26 }, do: "turn 180" }],
    },
  });
  await corridor.open(`/#${link.ok ? link.text : ""}`);
  await expect(corridor.mazeMenu).toHaveAccessibleName("Dead end, Maze menu");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const { program, timeline } = corridor;
  const current = program.region.locator("[aria-current]");
  await expect(corridor.runNote).toContainText(/^Bump/i);
  await expect(current).toHaveCount(1);
  await expect(current).toHaveRole("group");
  await expect(timeline.slider).toHaveAttribute(
    "aria-valuetext",
    /^\d\.\d s, “otherwise” drives, bump$/,
  );
  await expect(program.line(1)).toHaveAccessibleName(/is 25, true\.$/);

  // The run goes on with the turn that line 1 chose.
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  await expect(program.line(1)).toHaveAttribute("aria-current", "step");
  await corridor.pause.click();
  await expect(timeline.slider).toHaveAttribute("aria-valuetext", /s, line 1 drives/);
  await expect(timeline.playhead).toHaveText("1");
});

test("shows the time of the clock on the card of a mission whose program was edited on the way", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(3);
  await corridor.program.action(1).selectOption("reverse");
  await corridor.run.click();
  await expect(corridor.clock).toHaveText(/0:0[3-9]\./);
  await corridor.pause.click();
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
  const solved = page.getByRole("region", { name: "Solved!" });
  const clock = (await corridor.clock.textContent()) ?? "";
  const seconds = Number(/0:(\d\d\.\d)$/.exec(clock)?.[1]);
  await expect(solved.getByRole("definition").first()).toHaveText(`${seconds.toFixed(1)} s`);
});
