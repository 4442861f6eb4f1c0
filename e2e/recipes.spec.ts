/** The recipes of /docs, run as displayed, with the robot of a page. */
import { encodeLink } from "@corridor/link";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { expect, test } from "./fixtures.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const maze = {
  format: "corridor/maze" as const,
  version: 1 as const,
  name: "Bend",
  blocks: ["#####", "#...#", "###.#", "#####"],
  start: { column: 1, row: 1, heading: "east" as const },
  goals: [{ column: 3, row: 2 }],
};

const [python = "python3"] = inPath("python3");
const programs: Record<string, { command: string[]; file: string }> = {
  Python: { command: [python], file: "recipe.py" },
  JavaScript: { command: [process.execPath], file: "recipe.mjs" },
  curl: { command: ["sh"], file: "recipe.sh" },
};

/**
 * Turns the robot slightly and moves it off its square's centre, as a first script leaves it at a
 * wall.
 */
async function bump(_page: Page, address: string): Promise<void> {
  const commands = [
    { action: "turn", degrees: 3 },
    { action: "move", distance: 1000 },
    { action: "turn", degrees: 5 },
  ];
  const states = [];
  for (const command of commands) {
    const { seq } = await (await api(address, "/commands", command)).json();
    states.push((await (await api(address, `/commands/${seq}?wait=25`)).json()).state);
  }
  expect(states).toEqual(["completed", "collided", "completed"]);
}

/** Presses Reset while the robot drives. The speed is slow enough for the press to be in time. */
async function reset(page: Page, address: string): Promise<void> {
  const motion = async () => (await (await api(address, "/sensors?wait=25")).json()).motion;
  await expect.poll(motion).toBe("move");
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await setSpeed(page, "16");
}

interface Recipe {
  section: string;
  language: string;
  prints: RegExp;
  isEndless?: boolean;
  /** what the robot does before the script */
  before?: (page: Page, address: string) => Promise<void>;
  /** what the owner does while the script runs */
  meanwhile?: (page: Page, address: string) => Promise<void>;
}

const follower = {
  section: "wall-follower-that-stops-at-the-goal",
  before: bump,
  prints: /^Goal reached after 1 bumps\n$/,
};
/** all code samples of the page: the section, the language and the script's output */
const recipes: Recipe[] = [
  { ...follower, language: "Python" },
  { ...follower, language: "JavaScript" },
  { ...follower, language: "curl" },
  { section: "react-to-a-bump", language: "Python", prints: /^Wall after 2\d\d cm\n$/ },
  {
    section: "read-the-maze",
    language: "Python",
    prints: /^Bend 5 4\nGoal at 3 2\nRobot at 1 1\n$/,
  },
  {
    section: "read-the-maze",
    language: "JavaScript",
    prints: /^Bend 5 4\nGoal at 3 2\nRobot at 1 1\n$/,
  },
  { section: "read-the-maze", language: "curl", prints: /"blocks":\["#####"/ },
  { section: "watch-a-robot", language: "Python", prints: /front \d/, isEndless: true },
  { section: "watch-a-robot", language: "JavaScript", prints: /front \d/, isEndless: true },
  {
    section: "watch-a-robot",
    language: "curl",
    prints: /event: snapshot/,
    isEndless: true,
  },
  {
    section: "several-scripts",
    language: "Python",
    prints: /^\['left 90', 'right 90'\]\n$/,
  },
  {
    section: "start-over",
    language: "Python",
    before: (page) => setSpeed(page, "0.25"),
    meanwhile: reset,
    prints: /^The robot was put back to its start\.\nGoal reached\n$/,
  },
];

interface Sample {
  section: string;
  language: string;
  text: string;
}

/** The code samples of an open page of /docs. */
async function samplesOf(docs: Page): Promise<Sample[]> {
  return docs.locator("main pre").evaluateAll((all) => {
    const headings = [...document.querySelectorAll("main h2")];
    return all.map((pre) => ({
      section:
        headings.findLast(
          (heading) =>
            (heading.compareDocumentPosition(pre) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0,
        )?.id ?? "",
      language: pre.closest(".panel")?.getAttribute("aria-label") ?? "Python",
      text: pre.textContent,
    }));
  });
}

/** Starts a sample with the libraries in its folder. */
async function start(sample: string, language: string, address: string) {
  const folder = await mkdtemp(join(tmpdir(), "corridor-recipe-"));
  const [robot = "", key = ""] = address.split("#");
  const text = sample
    .replaceAll("http://HOST/r/ID#KEY", address)
    .replaceAll("http://HOST/api/v1/robots/ID", robot.replace("/r/", "/api/v1/robots/"))
    .replaceAll("Bearer KEY", `Bearer ${key}`);
  const { command, file } = programs[language] ?? { command: [], file: "" };
  for (const library of ["corridor.py", "corridor.js"]) {
    const code = await (await fetch(new URL(`/${library}`, address))).text();
    await writeFile(join(folder, library), code);
  }
  await writeFile(join(folder, file), text);
  const [program, ...args] = [...command, file];
  const script = spawn(program, args, {
    cwd: folder,
    stdio: ["ignore", "pipe", "pipe"],
    env: { ...process.env, FORCE_COLOR: "0" },
    // A process group of its own, so that the kill includes the script's child processes.
    detached: true,
  });
  const running = { output: "", ended: once(script, "close"), stop };
  async function stop(): Promise<void> {
    if (script.exitCode === null) process.kill(-(script.pid ?? Number.NaN), "SIGTERM");
    await running.ended;
    await rm(folder, { recursive: true });
  }
  script.stdout.on("data", (chunk) => (running.output += chunk));
  script.stderr.on("data", (chunk) => (running.output += chunk));
  return running;
}

/** Puts the robot of the small maze back to its start. */
async function startOver(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect(page.getByText("Robot at 150, 150, facing right")).toBeAttached();
}

/** Runs a code sample with the robot of the page. */
async function runRecipe(page: Page, samples: readonly Sample[], recipe: Recipe, address: string) {
  const { section, language, prints, isEndless = false } = recipe;
  await recipe.before?.(page, address);
  const sample = samples.find((each) => each.section === section && each.language === language);
  const script = await start(sample?.text ?? "", language, address);
  await recipe.meanwhile?.(page, address);
  if (isEndless) await expect.poll(() => script.output).toMatch(prints);
  else {
    const [code] = await script.ended;
    expect(script.output).toMatch(prints);
    expect(code).toBe(0);
  }
  await script.stop();
}

// The robot of one page drives them all.
test("every recipe, and the wall follower of both libraries' pages, has the documented result", async ({
  page,
}) => {
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  await page.goto(`/#${link.text}`);
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  const docs = await page.context().newPage();
  await docs.goto("/docs/recipes");
  const samples = await samplesOf(docs);
  expect(samples.map((sample) => `${sample.section} ${sample.language}`)).toEqual(
    recipes.map((each) => `${each.section} ${each.language}`),
  );
  for (const recipe of recipes) {
    await test.step(`${recipe.section} in ${recipe.language}`, async () => {
      await startOver(page);
      await runRecipe(page, samples, recipe, address);
    });
  }
  for (const [path, language] of [
    ["/docs/python", "Python"],
    ["/docs/javascript", "JavaScript"],
  ] as const) {
    await test.step(path, async () => {
      await startOver(page);
      await bump(page, address);
      await docs.goto(path);
      const sample = (await samplesOf(docs)).find(({ text }) =>
        text.includes("Goal reached after"),
      );
      const script = await start(sample?.text ?? "", language, address);
      expect(await script.ended).toEqual([0, null]);
      expect(script.output, path).toBe("Goal reached after 1 bumps\n");
      await script.stop();
    });
  }

  await test.step("the wall follower in curl ends with a sentence if the service does not respond", async () => {
    const sample = samples.find(({ language }) => language === "curl");
    const text = sample?.text.replaceAll("http://HOST", "http://localhost:1") ?? "";
    const script = await start(text, "curl", address.replace(/[\w-]+#[\w-]+$/, "ID#KEY"));
    expect(await script.ended).toEqual([1, null]);
    expect(script.output).toContain("The service did not respond. Check the address");
    expect(script.output).not.toContain("awk");
    await script.stop();
  });
});
