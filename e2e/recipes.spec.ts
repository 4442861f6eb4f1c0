/** The recipes of /docs, as they are displayed, with a robot in a page. */
import { encodeLink } from "@corridor/link";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { expect, test } from "./fixtures.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";

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
  "HTTP with curl": { command: ["sh"], file: "recipe.sh" },
};

const follower = "wall-follower-that-stops-at-the-goal";
/** All code of the page: the section, the language and what the script prints. */
const recipes = [
  { section: follower, language: "Python", prints: /^Goal reached after 0 bumps\n$/ },
  { section: follower, language: "JavaScript", prints: /^Goal reached after 0 bumps\n$/ },
  { section: follower, language: "HTTP with curl", prints: /^Goal reached after 0 bumps\n$/ },
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
  { section: "read-the-maze", language: "HTTP with curl", prints: /"blocks":\["#####"/ },
  { section: "watch-a-robot", language: "Python", prints: /front \d/, isEndless: true },
  {
    section: "watch-a-robot",
    language: "HTTP with curl",
    prints: /event: snapshot/,
    isEndless: true,
  },
  {
    section: "several-scripts",
    language: "Python",
    prints: /^\['left 90', 'right 90'\]\n$/,
  },
  { section: "start-over", language: "Python", prints: /Goal reached\n$/ },
];

interface Sample {
  section: string;
  language: string;
  text: string;
}

async function samplesOf(page: Page, relay: string): Promise<Sample[]> {
  const docs = await page.context().newPage();
  await docs.goto(`${relay}/docs/recipes`);
  const samples = await docs.locator("main pre").evaluateAll((all) => {
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
  await docs.close();
  return samples;
}

for (const { section, language, prints, isEndless = false } of recipes) {
  test(`${section} in ${language} does what it says`, async ({ page, relay }) => {
    const link = encodeLink({ maze });
    if (!link.ok) throw new Error(link.code);
    const folder = await mkdtemp(join(tmpdir(), "corridor-recipe-"));
    await page.goto(`/#${link.text}`);
    await setSpeed(page, "16");
    const address = await copyAddress(page);
    const samples = await samplesOf(page, relay);
    expect(samples.map((sample) => `${sample.section} ${sample.language}`)).toEqual(
      recipes.map((recipe) => `${recipe.section} ${recipe.language}`),
    );
    const sample = samples.find((each) => each.section === section && each.language === language);
    const [robot = "", key = ""] = address.split("#");
    const text = (sample?.text ?? "")
      .replaceAll("http://HOST/r/ID#KEY", address)
      .replaceAll("http://HOST/api/v1/robots/ID", robot.replace("/r/", "/api/v1/robots/"))
      .replaceAll("Bearer KEY", `Bearer ${key}`);
    const { command, file } = programs[language] ?? { command: [], file: "" };
    await writeFile(
      join(folder, "corridor.py"),
      await (await fetch(`${relay}/corridor.py`)).text(),
    );
    await writeFile(join(folder, file), text);
    const [program, ...words] = [...command, file];
    const script = spawn(program, words, {
      cwd: folder,
      stdio: ["ignore", "pipe", "pipe"],
      env: { ...process.env, FORCE_COLOR: "0" },
      // A group of its own, which ends with what the script has started.
      detached: true,
    });
    const ended = once(script, "close");
    let output = "";
    script.stdout.on("data", (chunk) => (output += chunk));
    script.stderr.on("data", (chunk) => (output += chunk));
    if (isEndless) {
      await expect.poll(() => output).toMatch(prints);
      process.kill(-(script.pid ?? Number.NaN), "SIGTERM");
      await ended;
    } else {
      const [code] = await ended;
      expect(output).toMatch(prints);
      expect(code).toBe(0);
    }
    await rm(folder, { recursive: true });
  });
}
