/**
 * Programs as code, run as separate processes: at every decision the same line and, bit for bit, the
 * same pose as the program has in a simulation.
 */
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { setTimeout as sleep } from "node:timers/promises";
import { encodeLink } from "@corridor/link";
import { generateMaze, type MazeDocument } from "@corridor/maze";
import {
  codeFiles,
  codeLanguages,
  emptyProgram,
  programCode,
  type CodeLanguage,
} from "@corridor/program";
import { paperPrograms } from "@corridor/program/testing";
import type { CommandRecord, LineRef, Pose } from "@corridor/protocol";
import type { Page } from "playwright/test";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { inPath } from "../scripts/programs.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { ProgramPath } from "./support/program-path.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";

/** Decisions of a script after which the test ends it: some programs have no end. */
const DECISIONS = 16;
const GOAL = "The robot has reached the goal.";
/** The network is cut once in this number of decisions. */
const DECISIONS_PER_CUT = 4;
/** A cut follows its decision by at most this time, in ms, if the script is connected then. */
const MAX_CUT_DELAY = 60;

const mazes: MazeDocument[] = (["tree", "loops", "rooms"] as const).map((kind) =>
  generateMaze({ kind, columns: 7, rows: 7, seed: 5, name: kind }),
);

/** 30 cells to the goal: 7.5 s at speed 4. */
const corridorMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Long corridor",
  blocks: [".".repeat(32)],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 31, row: 0 }],
};

interface Runtime {
  needs: readonly string[];
  /** @returns the command that runs a file, which it compiles first where the language needs that */
  start: (file: string) => string[];
}

/** Mono stands in for .NET. */
const runtimes: Record<CodeLanguage, Runtime> = {
  python: { needs: ["python3"], start: (file) => [inPath("python3")[0] ?? "", file] },
  javascript: { needs: [], start: (file) => [process.execPath, file] },
  java: {
    needs: ["javac", "java"],
    start: (file) => {
      compile("javac", "-d", dirname(file), file);
      return ["java", "-XX:TieredStopAtLevel=1", "-cp", dirname(file), "Rules"];
    },
  },
  csharp: {
    needs: ["mcs", "mono"],
    start: (file) => {
      compile("mcs", "-r:System.Net.Http", file);
      return ["mono", file.replace(/\.cs$/, ".exe")];
    },
  },
};

function compile(command: string, ...args: string[]): void {
  const { status, stderr } = spawnSync(command, args, { encoding: "utf8" });
  expect(status, stderr).toBe(0);
}

interface ScriptRun {
  /** labels of the decisions, such as "line 1" */
  lines: string[];
  /** the last printed line if the script ended by itself, and its exit code */
  end: { sentence: string; code: number } | null;
}

/**
 * Runs a script to its end, or until it has made many decisions.
 * @param onDecision called with the number of decisions
 */
async function runScript(
  [command = "", ...args]: string[],
  onDecision: (count: number) => void = () => undefined,
): Promise<ScriptRun> {
  const script = spawn(command, args, { stdio: ["ignore", "pipe", "pipe"] });
  const closed = once(script, "close");
  const lines: string[] = [];
  let sentence = "";
  let errors = "";
  script.stderr.on("data", (chunk) => (errors += chunk));
  let isKilled = false;
  for await (const text of createInterface({ input: script.stdout })) {
    const label = /^(line \d+|otherwise): /.exec(text)?.[1];
    if (label === undefined) sentence = text;
    else onDecision(lines.push(label));
    if (lines.length < DECISIONS || isKilled) continue;
    isKilled = script.kill("SIGKILL");
  }
  const [code] = (await closed) as [number | null];
  return { lines, end: code === null ? null : { sentence: `${errors}${sentence}`.trim(), code } };
}

/** Cuts the connections of a script as soon as it has one, after a delay in ms. */
async function cutNextConnection(
  network: FaultProxy,
  delay: number,
  isRunning: () => boolean,
): Promise<void> {
  await sleep(delay);
  while (isRunning() && network.cut() === 0) await sleep(1);
}

function lineOf(label: string): LineRef {
  return label === "otherwise" ? "default" : Number(label.slice("line ".length)) - 1;
}

async function recordsAfter(address: string, seq: number): Promise<CommandRecord[]> {
  const { commands } = await (await api(address, `/commands?after=${seq}`)).json();
  return commands;
}

async function openMaze(page: Page, maze: MazeDocument): Promise<void> {
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  await page.evaluate((hash) => (location.hash = hash), `#${link.text}`);
  await expect(page.getByRole("button", { name: `${maze.name}, Maze menu` })).toBeVisible();
}

for (const language of codeLanguages) {
  test(`scripts in ${language} drive the paths of the programs of the thesis through lost connections`, async ({
    page,
    relay,
  }) => {
    const { needs, start } = runtimes[language];
    const missing = needs.find((name) => inPath(name).length === 0);
    if (missing !== undefined) {
      process.stderr.write(
        `code-export.spec.ts: skipped ${language}, ${missing} is not installed\n`,
      );
    }
    test.skip(missing !== undefined, `${missing} is not installed`);
    test.setTimeout(400_000);
    const target = Number(new URL(relay).port);
    const random = new SeededRandom(1);
    const network = await FaultProxy.start({ target: () => target, random });
    const folder = await mkdtemp(join(tmpdir(), "corridor-code-"));
    await page.goto("/");
    await setSpeed(page, "max");
    const address = await copyAddress(page);
    const scripts = await Promise.all(
      paperPrograms.map(async ({ figure, program }) => {
        const code = programCode(program, language, address.replace(relay, network.origin));
        if (!code.ok) throw new Error(`no code for figure ${figure}`);
        const file = join(folder, `${figure}`, codeFiles[language].file);
        await mkdir(dirname(file));
        await writeFile(file, code.text);
        return { figure, program, command: start(file) };
      }),
    );
    const ends = new Set<string>();
    let seq = 0;
    for (const maze of mazes) {
      await openMaze(page, maze);
      await page.getByRole("radio", { name: "Remote" }).click();
      for (const { figure, program, command } of scripts) {
        const name = `figure ${figure} in ${maze.name}`;
        let isRunning = true;
        const { lines, end } = await runScript(command, (count) => {
          if (count % DECISIONS_PER_CUT !== 1) return;
          void cutNextConnection(network, random.between(0, MAX_CUT_DELAY), () => isRunning);
        });
        isRunning = false;
        const records = await recordsAfter(address, seq);
        seq = records.at(-1)?.seq ?? seq;
        const ended = records.filter(({ state }) => /completed|collided/.test(state));
        // The script begins with a reset, and each decision starts at the end of the one before.
        const poses = ended.map(({ pose }) => pose as Pose);
        expect(ended[0]?.action, `${name}: ${end?.sentence}`).toBe("reset");
        const decisions = lines
          .slice(0, poses.length)
          .map((label, at) => ({ line: lineOf(label), pose: poses[at] as Pose }));
        expect(decisions.length, name).toBeGreaterThan(0);
        const path = new ProgramPath(maze, program);
        expect(path.firstDifference(decisions), name).toBeNull();
        const last = poses.at(-1) as Pose;
        if (end?.sentence.includes("against a wall") === true)
          expect(path.endsAt(last), name).toBe(true);
        else if (end !== null) expect(end, name).toEqual({ sentence: GOAL, code: 0 });
        else expect(decisions.length, name).toBeGreaterThanOrEqual(DECISIONS - 1);
        ends.add(end?.sentence ?? "none");
      }
    }
    expect(network.cuts).toBeGreaterThan(10);
    expect([...ends]).toContain(GOAL);
    await network.close();
    await rm(folder, { recursive: true });
  });
}

test("a script that was silent for so long that the robot stopped continues on the path", async ({
  page,
  relay,
}) => {
  test.setTimeout(120_000);
  const target = Number(new URL(relay).port);
  const network = await FaultProxy.start({ target: () => target, random: new SeededRandom(1) });
  await page.goto("/");
  await setSpeed(page, "4");
  const address = await copyAddress(page);
  await openMaze(page, corridorMaze);
  await page.getByRole("radio", { name: "Remote" }).click();
  const program = emptyProgram();
  const code = programCode(program, "python", address.replace(relay, network.origin));
  if (!code.ok) throw new Error("no code");
  const running = runScript([...runtimes.python.start("-c"), code.text]);
  const motion = async () => (await (await api(address, "/sensors")).json()).motion as string;
  await expect.poll(motion).toBe("forward");
  network.breakFor(4_500);
  const { lines, end } = await running;
  expect(end).toEqual({ sentence: GOAL, code: 0 });
  const records = await recordsAfter(address, 0);
  expect(records.map(({ state }) => state)).toEqual(["completed", "cancelled", "completed"]);
  const decisions = lines.map((label, at) => ({
    line: lineOf(label),
    pose: records[at]?.pose as Pose,
  }));
  expect(new ProgramPath(corridorMaze, program).firstDifference(decisions)).toBeNull();
  await network.close();
});

test("the panel shows the program as code, follows each edit, and copies a file that drives", async ({
  corridor,
  page,
}) => {
  test.setTimeout(120_000);
  const { program } = corridor;
  await program.button("Show as code").click();
  const code = program.region.getByRole("textbox", { name: "The program as code" });
  await expect(code).toHaveValue(/ {4}if right > 60:\n {8}drive\("line 1", "delayed right 90"\)/);
  // The robot's address is there, but a projector does not show its key.
  await expect(code).toHaveValue(/ROBOT = "http:[^"]+\/r\/[\w-]{22}#•••• •••• \w{4}"/);
  await program.number(1).fill("61.5");
  await expect(code).toHaveValue(/if right > 61\.5:[^]+"right > 61\.5 or front < 50"/);
  await program.region.getByRole("radio", { name: "C#" }).check({ force: true });
  await expect(code).toHaveValue(/if \(right > 61\.5\) \{/);
  await program.region.getByRole("radio", { name: "Python" }).check({ force: true });

  await program.button("Copy").click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const download = page.waitForEvent("download");
  await program.button("Save rules.py").click();
  const saved = await download;
  expect(saved.suggestedFilename()).toBe("rules.py");
  expect(await readFile(await saved.path(), "utf8")).toBe(copied);

  await setSpeed(page, "max");
  await page.getByRole("radio", { name: "Remote" }).click();
  const { lines, end } = await runScript([...runtimes.python.start("-c"), copied]);
  expect(lines.length).toBeGreaterThan(0);
  expect(end === null || end.sentence === GOAL, end?.sentence).toBe(true);
});

test("shows the code in sight on a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  await phone.program.button("Show as code").tap();
  await expect(phone.program.button("Save rules.py")).toBeInViewport();
  await expect(
    phone.program.region.getByRole("textbox", { name: "The program as code" }),
  ).toBeInViewport();
});
