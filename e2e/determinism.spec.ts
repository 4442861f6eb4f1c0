/**
 * The same maze and inputs produce the same bits in Node, in the page's worker in Chromium and
 * Firefox, and on the command line.
 */
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { TimedCommand } from "@corridor/protocol";
import { replayDigest } from "@corridor/simulation";
import { expect, test } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { DigestServer } from "./support/digest-server.ts";

const TICKS = 100_000;
const maze: MazeDocument = generateTree({ columns: 21, rows: 21, seed: 7, name: "Tree" });

function preset(id: string): ProgramDocument {
  const found = programPresets.find((each) => each.id === id);
  if (found === undefined) throw new Error(`no algorithm ${id}`);
  return found.program;
}

/** Turns too early, so the robot scrapes and bumps along the walls for the whole run. */
const scraping: ProgramDocument = {
  ...preset("right-wall"),
  rules: [
    { when: { sensor: "front", is: "<", than: 30 }, do: "right 90" },
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
  ],
};

/** Arbitrary wheel powers, measured turns and pushes against walls. */
const odd: TimedCommand[] = Array.from({ length: 2000 }, (_, i): TimedCommand => {
  const tick = i * 50;
  const power = ((i * 37) % 101) / 101;
  if (i % 5 === 0) return { tick, command: { action: "turn", degrees: ((i * 13.7) % 300) - 150 } };
  if (i % 7 === 0) return { tick, command: { action: "move", distance: 33.3 } };
  return { tick, command: { action: "drive", left: power, right: 0.9 - power / 3 } };
});

const drives = [
  { name: "right wall, without contact", driver: preset("right-wall") },
  { name: "along the walls, in contact", driver: scraping },
  { name: "odd wheel powers", driver: odd },
];

const expected = drives.map(({ driver }) =>
  replayDigest({ maze, driver: "rules" in driver ? new CompiledProgram(driver) : driver }, TICKS),
);

async function digestsOf(open: (url: string) => Promise<() => Promise<void>>): Promise<string[]> {
  const messages = drives.map(({ driver }) => ({
    type: "digest",
    maze,
    driver,
    ticks: TICKS,
  }));
  const server = await DigestServer.start(messages);
  const close = await open(server.url);
  try {
    return await server.digests;
  } finally {
    await close();
    server.close();
  }
}

test("every drive has a different digest", () => {
  expect(new Set(expected).size).toBe(drives.length);
});

test("the page's worker in Chromium produces the bits of Node", async ({ page }) => {
  const digests = await digestsOf(async (url) => {
    await page.goto(url);
    return async () => {};
  });
  expect(digests).toEqual(expected);
});

test("the page's worker in Firefox produces the bits of Node", async () => {
  const firefox = ["firefox-esr", "firefox"].flatMap(inPath)[0];
  test.skip(firefox === undefined, "Firefox is not installed");
  const folder = mkdtempSync(join(tmpdir(), "corridor-firefox-"));
  const digests = await digestsOf(async (url) => {
    const args = ["--headless", "--no-remote", "--profile", folder, url];
    const browser = spawn(firefox ?? "", args, { stdio: "ignore" });
    return async () => {
      const ended = once(browser, "exit");
      browser.kill();
      await ended;
    };
  });
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  expect(digests).toEqual(expected);
});

test("the command line produces the bits of Node", () => {
  const folder = mkdtempSync(join(tmpdir(), "corridor-digest-"));
  const file = (name: string, content: unknown): string => {
    const path = join(folder, name);
    writeFileSync(path, JSON.stringify(content));
    return path;
  };
  const main = new URL("../apps/cli/src/main.ts", import.meta.url).pathname;
  const digests = drives.map(({ driver }) => {
    const option = "rules" in driver ? "--program" : "--commands";
    const args = [
      "simulate",
      "--maze",
      file("maze.json", maze),
      option,
      file("driver.json", driver),
    ];
    const seconds = String(TICKS / 60);
    const { stdout } = spawnSync(
      process.execPath,
      [main, ...args, "--digest", "--seconds", seconds],
      {
        encoding: "utf8",
      },
    );
    return JSON.parse(stdout).digest;
  });
  rmSync(folder, { recursive: true });
  expect(digests).toEqual(expected);
});
