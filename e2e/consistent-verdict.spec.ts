/**
 * Wrong answers to missions. Every place of the page that explains why the run failed gives the same
 * line, the same time and the same sentence. same-verdict.exhaustive.test.ts covers all missions.
 */
import { encodeLink } from "@corridor/link";
import type { ProgramDocument } from "@corridor/program";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { commandRow } from "./support/remote-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";

/** lines such as "front < 50: left 90", and the action of "otherwise" */
interface Answer {
  otherwise: string;
  lines: readonly string[];
}

test.use(smallWindow);

const forward = (...lines: string[]): Answer => ({ otherwise: "forward", lines });
const delayedRight = "right > 60: delayed right 90";

/** Runs that end at a bump or at the time limit, in a mission with one maze and with three. */
const wrongAnswers: readonly { mission: number; id: string; answers: readonly Answer[] }[] = [
  {
    mission: 3,
    id: "one-line",
    answers: [forward("front < 50: reverse"), forward("front < 50: delayed left 90")],
  },
  {
    mission: 12,
    id: "every-maze",
    answers: [forward("front < 50: left 90"), forward(delayedRight, "front < 50: delayed left 90")],
  },
];

for (const { mission, id, answers } of wrongAnswers) {
  test(`mission ${mission}: every explanation of a failed run is the same`, async ({ page }) => {
    const corridor = new CorridorPage(page);
    const lessons = new LessonsPanel(page);
    await recordAnnouncements(page);
    await corridor.open(`/?first#mission/${id}`);
    await lessons.expectMission(mission);
    for (const answer of answers) {
      await storeAnswer(page, id, answer);
      await corridor.reload();
      await lessons.expectMission(mission);
      await expect(corridor.program.action(1)).toHaveValue(ruleOf(answer.lines[0] ?? "").do);
      await corridor.speed.selectOption("max");
      await corridor.run.click();
      await expectSameVerdict(corridor, lessons);
    }
  });
}

test("shows a script that collides or reaches the goal the cards of a program", async ({
  corridor,
  page,
}) => {
  // Two squares to the goal, and two more to the wall.
  await corridor.open(`/#${corridorOfFive()}`);
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  await api(address, "/commands", { action: "move", distance: 200 });
  await api(address, "/commands/1?wait=20");
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText("Your script takes the robot from start to goal.");
  // The goal is reached before the full distance. Waiting time is counted separately.
  await expect(solved).toContainText(/driving time1\.\d s.*waiting time\d+\.\d s/);
  await expect(corridor.drivingTime).toHaveText("Time 0:02.0 driving");
  await api(address, "/commands", { action: "move", distance: 5000 });
  await api(address, "/commands/2?wait=20");
  const bump = page.getByRole("region", { name: "Bump" });
  await expect(bump).toContainText(
    /^BumpBump at \d+\.\d s\. “move 5000” needed 5025 cm ahead\. Front read 250 cm\./,
  );
  const [, time = ""] = /Bump at (\d+\.\d) s/.exec((await bump.textContent()) ?? "") ?? [];
  expect(await runNoteOf(corridor)).toContain(`at ${time} s`);
  await expect(commandRow(page, /move 5000/)).toContainText(/after 225 cm.*collided/);
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect(solved).toBeHidden();
});

test("the panel and the lines show the same tick in every frame, at any speed", async ({
  corridor,
  page,
}) => {
  const { program } = corridor;
  await corridor.choosePreset("Empty");
  await program.deleteAllLines();
  await program.addLine("front >", "60", "forward");
  await program.addLine("front <", "61", "turn 180");
  await corridor.run.click();
  const line = await program.line(1).elementHandle();
  const panel = await corridor.sensor("front").elementHandle();
  for (const speed of ["1×", "16×"]) {
    await corridor.speed.selectOption(speed);
    const { frames, different } = await page.evaluate(readFrames, [line, panel] as const);
    expect(frames, `frames with a new reading at ${speed}`).toBeGreaterThan(4);
    expect(different, `at ${speed}`).toEqual([]);
  }
});

/** The link of a corridor of five squares from west to east, with the goal in the third. */
function corridorOfFive(): string {
  const link = encodeLink({
    maze: {
      format: "corridor/maze",
      version: 1,
      name: "",
      blocks: ["#######", "#.....#", "#######"],
      start: { column: 1, row: 1, heading: "east" },
      goals: [{ column: 3, row: 1 }],
    },
  });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/**
 * Samples each frame for two seconds. @returns the number of new readings, and the differing pairs
 */
async function readFrames([line, panel]: readonly [Node | null, Node | null]) {
  const different: string[] = [];
  let [frames, last] = [0, ""];
  for (const end = performance.now() + 2000; performance.now() < end;) {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const panelReading = panel?.textContent ?? "";
    const [, lineReading = ""] = /([\d.]+) > 60/.exec(line?.textContent ?? "") ?? [];
    if (panelReading !== last) frames++;
    last = panelReading;
    // The line has a second decimal where one decimal would contradict its truth value.
    if (Math.abs(Number(lineReading) - Number(panelReading)) > 0.051)
      different.push(`${lineReading}, ${panelReading}`);
  }
  return { frames, different };
}

async function expectSameVerdict(corridor: CorridorPage, lessons: LessonsPanel): Promise<void> {
  const { page } = corridor;
  // The run ends with a bump, at the time limit, or at the goal of the displayed maze. The note of a
  // bump or a goal may follow the outcome.
  await expect
    .poll(async () => {
      const outcome = (await lessons.outcome.allTextContents()).join();
      const note = await runNoteOf(corridor);
      return note === "" && !outcome.includes("Time is up") ? "" : outcome + note;
    })
    .toMatch(/\.\d s\. (?!This mission).+\.|Time is up after .+\.|Goal reached/);
  const check = lessons.button(/^Check in (all|both)/);
  const hasManyMazes = (await check.count()) > 0;
  const before = await lessons.outcome.allTextContents();
  if (hasManyMazes) {
    await check.click();
    await expect(lessons.outcome).toHaveText(/^Maze \d: .+\./);
  }
  const outcome = (await lessons.outcome.textContent()) ?? "";
  const verdict = outcome.replace(/^Maze \d: /, "");
  // The check of this same maze reports the verdict of the run.
  if (before.length > 0 && outcome.startsWith("Maze 1: Bump")) expect(before).toEqual([verdict]);
  const runNote = await runNoteOf(corridor);
  if (runNote.startsWith("Goal reached")) {
    expect(outcome).toMatch(/^Maze [2-9]: /);
    return;
  }
  await expect.poll(async () => (await announcementsOf(page)).join("\n")).toContain(verdict);
  if (!verdict.startsWith("Bump")) {
    // The robot waits at the tick of the verdict.
    const seconds = Number(/(?:after|in) (\d+) s/.exec(verdict)?.[1]);
    const minutes = Math.floor(seconds / 60);
    const clock = `${minutes > 0 ? `${minutes} min ` : ""}${seconds % 60}`;
    await expect(corridor.timeline.slider).toHaveAttribute(
      "aria-valuetext",
      new RegExp(`^${clock}\\.0 s`),
    );
    const announcements = await announcementsOf(page);
    expect(announcements.filter((text) => text.includes("look at"))).toEqual([]);
    await expect(page.getByRole("region", { name: /^Bump/ })).toHaveCount(0);
    return;
  }
  const time = /^Bump at (\d+\.\d) s\./.exec(verdict)?.[1] ?? "";
  const line = /[Ll]ine \d|“otherwise” chose/.exec(verdict.replace(/A line for this place.*/, ""));
  const isMissing = verdict.includes("is missing") || verdict.includes("no line");
  const cause = isMissing ? null : (line?.[0].replace(" chose", "").toLowerCase() ?? null);
  const title = cause === null ? "Bump" : `Bump: look at ${cause}`;

  const card = page.getByRole("region", { name: /^Bump/ });
  await expect(card).toHaveAccessibleName(title);
  await expect(card).toContainText(verdict);
  // The student must find the fix: no button applies it.
  await expect(card.getByRole("button", { name: /^(Change|Add|Delete|Move|Let) / })).toHaveCount(0);
  expect(runNote).toContain(`at ${time} s`);
  await expect(corridor.timeline.slider).toHaveAttribute(
    "aria-valuetext",
    new RegExp(`^${time} s`),
  );
  // The red mark of the timeline has the number of this line and no other.
  const number = /line (\d)/.exec(cause ?? "")?.[1] ?? "";
  await expect(corridor.timeline.playhead).toHaveText(number);
  await expect
    .poll(async () => (await announcementsOf(page)).filter((text) => /^Bump[:.]/.test(text)))
    .toEqual([`${title}.`]);
  const marked = await page
    .locator("[aria-label*=', look here']")
    .evaluateAll((lines) => lines.map((each) => each.getAttribute("aria-label") ?? ""));
  expect(marked.map((name) => name.split(",")[0]?.toLowerCase())).toEqual(
    cause === null ? [] : [cause.replaceAll(/[“”]/g, "")],
  );
}

async function runNoteOf(corridor: CorridorPage): Promise<string> {
  return (await corridor.runNote.textContent()) ?? "";
}

function programOf({ otherwise, lines }: Answer): Pick<ProgramDocument, "default" | "rules"> {
  return { default: otherwise as ProgramDocument["default"], rules: lines.map(ruleOf) };
}

function ruleOf(line: string): ProgramDocument["rules"][number] {
  const [, sensor, is, than = "", , plus, action] =
    /^(\w+) ([<>]) (right|\d+)( \+ (\d+))?: (.+)$/.exec(line) ?? [];
  const when =
    than === "right"
      ? { sensor, is, than, plus: Number(plus) }
      : { sensor, is, than: Number(than) };
  return { when, do: action } as ProgramDocument["rules"][number];
}

/** Stores an answer as the attempt's program. The page shows it after a reload. */
async function storeAnswer(page: Page, mission: string, answer: Answer): Promise<void> {
  const attempt = JSON.stringify({ mission, program: programOf(answer) });
  await page.evaluate((text) => sessionStorage.setItem("attempt", text), attempt);
}

async function recordAnnouncements(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const announcements: string[] = [];
    Object.assign(window, { announcements });
    new MutationObserver(() => {
      const text = document.querySelector("#spoken")?.textContent ?? "";
      if (text !== "" && announcements.at(-1) !== text) announcements.push(text);
    }).observe(document, { subtree: true, childList: true, characterData: true });
    const attempt = sessionStorage.getItem("attempt");
    if (attempt === null) return;
    const { mission, program } = JSON.parse(attempt);
    const { works } = JSON.parse(localStorage.getItem("corridor.lessons") ?? "{}");
    const key = `corridor.work.${works[mission]}`;
    const project = JSON.parse(localStorage.getItem(key) ?? "{}");
    Object.assign(project.program, program);
    localStorage.setItem(key, JSON.stringify(project));
  });
}

function announcementsOf(page: Page): Promise<string[]> {
  return page.evaluate(() => (window as unknown as { announcements: string[] }).announcements);
}
