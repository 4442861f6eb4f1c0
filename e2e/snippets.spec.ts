/** A beginner's first scripts, run as copied, in every state of the robot's page. */
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { expect, test } from "./fixtures.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";
import { exampleCommand, runScript } from "./support/script.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

interface Script {
  name: string;
  command: readonly string[];
  text: string;
}

const [python = ""] = exampleCommand("Python");
const [node = ""] = exampleCommand("JavaScript");
const [java = ""] = exampleCommand("Java");
/** A short program needs less processor time without Java's second compiler. */
const quickStart = ["-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"];

/** The scripts of the page, /docs and the README, saved as files where the program needs one. */
async function firstScripts(page: Page, address: string, folder: string): Promise<Script[]> {
  const section = page.getByRole("region", { name: "Connect with" });
  const copied = async (kind: string): Promise<string> => {
    await section.getByRole("combobox").selectOption({ label: kind });
    await section.getByRole("button", { name: "Copy", exact: true }).click();
    return page.evaluate(() => navigator.clipboard.readText());
  };
  const saved = async (file: string, text: string): Promise<string> => {
    await writeFile(join(folder, file), text);
    return join(folder, file);
  };
  const starter = await copied("Python");
  const inJava = await copied("Java");
  const { origin } = new URL(address);
  await saved("corridor.py", await (await fetch(`${origin}/corridor.py`)).text());
  const readme = await readFile(new URL("../README.md", import.meta.url), "utf8");
  const block = (language: string): string =>
    (new RegExp(`\`\`\`${language}\\n([^]*?)\`\`\``).exec(readme)?.[1] ?? "").replace(
      /http:[^"]+/,
      address,
    );
  const module = [node, "--input-type=module", "-"];
  const all: Script[] = [
    { name: "first script", command: [python, await saved("first.py", starter)], text: starter },
    { name: "Python", command: [python, "-"], text: await copied("Python without corridor.py") },
    { name: "JavaScript", command: module, text: await copied("JavaScript") },
    { name: "curl", command: ["sh"], text: await copied("curl") },
    {
      name: "README in Python",
      command: [python, await saved("readme.py", block("python"))],
      text: block("python"),
    },
    { name: "README in TypeScript", command: module, text: block("ts") },
  ];
  if (inPath("java").length > 0) {
    const file = await saved("Robot.java", inJava);
    all.push({ name: "Java", command: [java, ...quickStart, file], text: inJava });
  }
  await openMoreSection(page);
  for (const { name, text } of all) {
    expect(text.trim().split("\n").length, name).toBeLessThanOrEqual(13);
  }
  return all;
}

const CHOOSE_REMOTE = "Remote is not driving: choose Remote on the robot's page.";

/** States of the page, each after the other, and the last line that a script prints then. */
const states = [
  {
    state: "on Remote",
    prepare: async () => undefined,
    last: /^("state":")?completed"?$|^\d+(\.\d+)?$|^$/,
  },
  {
    state: "with paused scripts",
    prepare: async (page: Page) => {
      const scripts = page.getByRole("region", { name: "Scripts" });
      await scripts.getByRole("button", { name: "Pause scripts" }).click();
      await expect(scripts.getByRole("button", { name: "Let scripts drive" })).toBeVisible();
    },
    last: /Press 'Let scripts drive' under Remote on the robot's page/,
  },
  {
    state: "paused",
    prepare: async (page: Page) => {
      const scripts = page.getByRole("region", { name: "Scripts" });
      await scripts.getByRole("button", { name: "Let scripts drive" }).click();
      await expect(scripts.getByRole("button", { name: "Pause scripts" })).toBeVisible();
      await page.getByRole("button", { name: "Pause", exact: true }).click();
      await expect(page.getByRole("button", { name: "Run", exact: true })).toBeVisible();
    },
    last: /The run is paused: press Run on the robot's page\./,
  },
  {
    state: "on Me",
    prepare: async (page: Page) => {
      await page.getByRole("button", { name: "Run", exact: true }).click();
      await page.getByRole("radio", { name: "Me", exact: true }).click();
      await expect(page.getByRole("radio", { name: "Me", exact: true })).toBeChecked();
    },
    last: new RegExp(CHOOSE_REMOTE),
  },
  {
    state: "closed",
    prepare: (page: Page) => page.close(),
    last: /open it again and choose Remote|Open the page again/,
  },
];

test("every first script ends with instructions in each state of the page", async ({ page }) => {
  const folder = await mkdtemp(join(tmpdir(), "corridor-first-"));
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  const scripts = await firstScripts(page, address, folder);

  await test.step("a misspelled action is reported with its name and the valid actions", async () => {
    for (const { name, command, text } of scripts) {
      const misspelled = text.replace(/action(.{1,6})left 90/, "action$1turn left");
      if (misspelled === text) continue;
      // Java reads a file instead of its input.
      if (name === "Java") await writeFile(join(folder, "Robot.java"), misspelled);
      const { code, output } = await runScript([...command], misspelled);
      expect(output, name).toMatch(/found '?turn left'?, expected one of forward, reverse, stop/);
      expect(code, name).toBe(1);
      if (name === "Java") await writeFile(join(folder, "Robot.java"), text);
    }
  });

  const run = async ({ name, command, text }: Script) => {
    const { code, output } = await runScript([...command], text);
    return { name, code, output, last: output.trimEnd().split("\n").at(-1) ?? "" };
  };
  for (const { state, prepare, last } of states) {
    await test.step(`the page is ${state}`, async () => {
      await prepare(page);
      for (const ended of await Promise.all(scripts.map(run))) {
        expect(ended.last, `${ended.name}: ${ended.output}`).toMatch(last);
        expect(ended.output, ended.name).not.toContain("Traceback");
        expect(ended.code, ended.name).toBe(state === "on Remote" ? 0 : 1);
      }
    });
  }
  await rm(folder, { recursive: true });
});
