/** Shared challenges: a mission shared by a student, and a challenge that a teacher wrote. */
import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/** A challenge as a teacher might write it: not a mission, and with another goal. */
const everySquare: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Sweep the corridor",
  words: {
    task: "Visit every square without a bump.",
    short: "Visit every square in 1 line",
    hints: ["Where does the robot turn round?"],
  },
  mazes: [
    {
      format: "corridor/maze",
      version: 1,
      name: "Sweep the corridor",
      blocks: ["......"],
      start: { column: 3, row: 0, heading: "east" },
      goals: [],
    },
  ],
  program: null,
  goal: { kind: "visit" },
  allowed: {
    drivers: ["program"],
    lines: 1,
    conditions: null,
    actions: null,
    edits: ["condition", "number", "action", "otherwise", "lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 60 },
  par: null,
};

test("shares a challenge with its task, its rules and the return to the recipient's own maze, and opens one that a teacher wrote", async ({
  corridor,
  page,
  openWindow,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(7);
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const dialog = corridor.dialog("Share this challenge");
  await expect(dialog.getByRole("checkbox", { name: "Challenge" })).toBeChecked();
  await expect(dialog).toContainText("Turn into the opening on the right");
  const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();

  const recipient = await openWindow(smallWindow);
  await recipient.open(link);
  const recipientLessons = new LessonsPanel(recipient.page);
  await expect(recipientLessons.card).toContainText("The side opening");
  await expect(
    recipient.page.getByRole("main").getByText("Turn into the opening on the right"),
  ).toBeVisible();
  await expect(recipient.program.number(1)).toBeDisabled();
  await recipient.program.action(1).selectOption("delayed right 90");
  await recipient.speed.selectOption("max");
  await recipient.run.click();
  await expect(recipientLessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
  await recipient.open();
  await expect(recipientLessons.card).toContainText("The side opening");
  await recipientLessons.button("Back to my maze").click();
  await expect(recipientLessons.card).toBeHidden();
  await expect(recipient.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");

  await test.step("opens a teacher's challenge from a link: every square in one line", () =>
    openEverySquare(recipient));
});

async function openEverySquare(corridor: CorridorPage): Promise<void> {
  const link = encodeLink({ lesson: lessonOf(everySquare) });
  if (!link.ok) throw new Error(link.code);
  await corridor.open(`/#${link.text}`);
  const lessons = new LessonsPanel(corridor.page);
  await expect(lessons.card).toContainText("Visit every square without a bump.");
  await expect(corridor.message("You opened a shared challenge.")).toBeVisible();
  await corridor.program.addLine("front <", "50", "right 90");
  await lessons.button("Check the program").click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
  await corridor.program.number(1).fill("20");
  await lessons.button("Check the program").click();
  await expect(lessons.outcome).toHaveText(
    /^Bump at 2\.\d s\. Line 1 never decided\. It was needed at 2\.0 s, when front was 50 cm\.$/,
  );
}
