/**
 * The command `corridor`, installed outside of the repository or downloaded from a relay as
 * `corridor-cli.mjs`, and `grade.mjs`. They do what the sources do.
 * conformance.spec.ts runs `corridor conformance`.
 */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Client } from "@modelcontextprotocol/client";
import { StdioClientTransport } from "@modelcontextprotocol/client/stdio";
import { publint } from "publint";
import { expect, test } from "./fixtures.ts";
import { EmptyFolder, userEnvironment } from "./support/installed-package.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const CLI = fileURLToPath(new URL("../apps/cli/", import.meta.url));
const PACKAGE = join(CLI, "dist");
const SOURCE = join(CLI, "src/main.ts");

let folder: EmptyFolder;
test.beforeEach(async () => {
  folder = await EmptyFolder.create();
});
test.afterEach(async () => {
  await folder.remove();
});

/** The code blocks of the README in their order. */
async function blocksOfReadme(): Promise<{ language: string; code: string }[]> {
  const text = await readFile(join(CLI, "README.md"), "utf8");
  return [...text.matchAll(/^```(\w+)\n([^]*?)^```$/gm)].map(([, language = "", code = ""]) => ({
    language,
    code,
  }));
}

/** Saves the documents of the README. */
async function writeDocuments(): Promise<void> {
  const documents = (await blocksOfReadme()).filter(({ language }) => language === "json");
  const names = ["maze.json", "right-wall.json", "forward.json", "lesson.json"];
  expect(documents).toHaveLength(names.length);
  for (const [at, name] of names.entries()) await folder.write(name, documents[at]?.code ?? "");
}

/** The installed command, which `npx corridor` starts. */
function command(): string {
  return join(folder.path, "node_modules/.bin/corridor");
}

function corridor(...args: string[]) {
  return folder.try(command(), ...args);
}

/** The same command from the sources. */
function fromSources(...args: string[]) {
  return folder.try(process.execPath, SOURCE, ...args);
}

test("the installed command does what its README and its sources do", async () => {
  const { files } = await folder.install(PACKAGE);
  await writeDocuments();

  await test.step("the npm package contains one file of code and needs no other package", async () => {
    expect(files.toSorted()).toEqual([
      "LICENSE",
      "README.md",
      "THIRD-PARTY-LICENSES",
      "corridor.js",
      "package.json",
    ]);
    const manifest = JSON.parse(await readFile(join(PACKAGE, "package.json"), "utf8"));
    expect(Object.keys(manifest).filter((field) => /dependencies/i.test(field))).toEqual([]);
    expect((await publint({ pkgDir: PACKAGE, strict: true })).messages).toEqual([]);
  });

  await test.step("each command of the README prints what the README shows", async () => {
    const blocks = await blocksOfReadme();
    const examples = blocks.flatMap(({ language, code }, at) => {
      const runsHere =
        language === "sh" && /^npx corridor (?:simulate|grade|maze) [^>]*$/.test(code);
      return runsHere ? [{ words: code.trim().split(" "), output: blocks[at + 1] }] : [];
    });
    expect(examples).toHaveLength(4);
    for (const { words, output } of examples) {
      const [npx = "", ...args] = words;
      expect(output?.language).toBe("text");
      expect(folder.run(npx, ...args)).toBe(output?.code);
      expect(fromSources(...args.slice(1)).stdout).toBe(output?.code);
    }
  });

  await test.step("simulate and grade print the same as from the sources, on all cores too", async () => {
    const [maze, rightWall, forward] = ["maze.json", "right-wall.json", "forward.json"];
    const everyCore = ["--seconds", "86400", "--until", "goal"];
    for (const args of [
      ["simulate", "--maze", maze, "--program", rightWall, "--digest"],
      ["grade", "--program", rightWall, forward, "--maze", maze, "--why", "--seconds", "30"],
      // The limit is so high that worker threads start. The runs end at the goal.
      ["grade", "--program", rightWall, "--maze", maze, maze, maze, ...everyCore],
      ["grade", "--challenge", "lesson.json", "--program", rightWall, "--unseen", "tree:7x7:100:1"],
      ["--help"],
      ["grade", "--help"],
    ]) {
      const installed = corridor(...args);
      expect(installed).toMatchObject({ code: 0, stderr: "" });
      expect(installed).toEqual(fromSources(...args));
    }
  });

  await test.step("invalid files and unknown commands exit with code 2", async () => {
    for (const args of [
      ["simulate", "--maze", "maze.json", "--program", "maze.json"],
      ["grade", "--program", "nowhere.json", "--maze", "maze.json"],
      ["conformance", "http://localhost/r/abc"],
      ["grad"],
      [],
    ]) {
      const installed = corridor(...args);
      expect(installed).toMatchObject({ code: 2, stdout: "" });
      expect(installed).toEqual(fromSources(...args));
    }
  });
});

test("the downloaded grade.mjs grades in an empty folder, on all cores too", async ({ relay }) => {
  folder.run("curl", "-sSfO", `${relay}/grade.mjs`);
  await writeDocuments();
  const lesson = ["--challenge", "lesson.json", "--program", "right-wall.json", "forward.json"];
  for (const args of [
    [...lesson, "--require", "50%"],
    [...lesson, "--require", "all"],
    // So many unseen mazes that worker threads start.
    [...lesson, "--unseen", "tree:7x7:100:1"],
    ["--program", "right-wall.json", "--maze", "maze.json", "--csv"],
    ["--challenge", "nowhere.json", "--program", "right-wall.json"],
  ]) {
    const downloaded = folder.try(process.execPath, "grade.mjs", ...args);
    expect(downloaded).toEqual(fromSources("grade", ...args));
  }
  const help = folder.run(process.execPath, "grade.mjs", "--help");
  expect(help).toContain("node grade.mjs --challenge LESSON");
  expect(await readFile(join(folder.path, "grade.mjs"), "utf8")).toContain("Colin McDonnell");
});

test("the downloaded corridor-cli.mjs has the commands, under its name", async ({ relay }) => {
  folder.run("curl", "-sSfO", `${relay}/corridor-cli.mjs`);
  await writeDocuments();
  const run = ["simulate", "--maze", "maze.json", "--program", "right-wall.json"];
  const downloaded = (...args: string[]) =>
    folder.try(process.execPath, "corridor-cli.mjs", ...args);
  expect(downloaded(...run)).toEqual(fromSources(...run));
  expect(downloaded("ros", "--help").stdout).toMatch(/^Usage: node corridor-cli\.mjs ros "http/);
  expect(downloaded("ross").stderr).toContain("Run node corridor-cli.mjs --help");
  const text = await readFile(join(folder.path, "corridor-cli.mjs"), "utf8");
  for (const name of ["zod", "ws", "ajv"]) {
    expect(text).toMatch(new RegExp(`^${name} \\d`, "m"));
  }
});

test("a ROS client and an agent drive the page's robot by corridor-cli.mjs", async ({
  page,
  relay,
}) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  folder.run("curl", "-sSfO", `${relay}/corridor-cli.mjs`);

  const environment = { ...userEnvironment, CORRIDOR_ROBOT: address };
  const bridge = spawn(process.execPath, ["corridor-cli.mjs", "ros", "--port", "0"], {
    cwd: folder.path,
    env: environment,
    stdio: ["ignore", "ignore", "pipe"],
  });
  const exited = once(bridge, "close");
  const [line] = await once(bridge.stderr, "data");
  const [, url = ""] = /connect to (\S+)\./.exec(String(line)) ?? [];
  const ros = new WebSocket(url);
  await once(ros, "open");
  ros.send(JSON.stringify({ op: "send_action_goal", action: "/do", args: { action: "right 90" } }));
  const [message] = await once(ros, "message");
  expect(JSON.parse(message.data)).toMatchObject({ op: "action_result", status: 4 });
  bridge.kill("SIGINT");
  expect(await exited).toEqual([0, null]);

  const agent = new Client({ name: "agent", version: "1.0.0" });
  await agent.connect(
    new StdioClientTransport({
      command: process.execPath,
      args: ["corridor-cli.mjs", "mcp"],
      cwd: folder.path,
      env: { CORRIDOR_ROBOT: address },
    }),
  );
  const turn = { action: "left 90", key: "turn-0001" };
  const turned = await agent.callTool({ name: "act", arguments: turn });
  expect(turned).toMatchObject({ structuredContent: { record: { state: "completed" } } });
  await agent.close();
  const { commands } = await (await api(address, "/commands?after=0")).json();
  expect(commands).toMatchObject([
    { action: "right 90", state: "completed" },
    { action: "left 90", state: "completed" },
  ]);
});
