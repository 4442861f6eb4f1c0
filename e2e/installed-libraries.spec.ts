/** The libraries for scripts, installed or downloaded outside of the repository, with a page's robot. */
import { spawnSync } from "node:child_process";
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import { createRequire } from "node:module";
import type { AddressInfo } from "node:net";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright/test";
import { publint } from "publint";
import { expect, test } from "./fixtures.ts";
import { EmptyFolder } from "./support/installed-package.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const CLIENT = fileURLToPath(new URL("../packages/client/", import.meta.url));
const PACKAGE = join(CLIENT, "dist");
const PYTHON_CLIENT = fileURLToPath(new URL("../packages/client-python/", import.meta.url));
const require = createRequire(import.meta.url);

let folder: EmptyFolder;
let otherSite: Server | undefined;
test.beforeEach(async () => {
  folder = await EmptyFolder.create();
});
test.afterEach(async () => {
  otherSite?.close();
  otherSite = undefined;
  await folder.remove();
});

/** The code block of a library's README that contains `excerpt`, with the robot's address. */
async function example(excerpt: string, address: string, library = CLIENT): Promise<string> {
  const text = await readFile(join(library, "README.md"), "utf8");
  const blocks = [...text.matchAll(/^( *)```(?:js|ts|python)\n([^]*?)^ *```$/gm)];
  const found = blocks
    .map(([, indent = "", code = ""]) => code.replaceAll(new RegExp(`^${indent}`, "gm"), ""))
    .filter((code) => code.includes(excerpt));
  expect(found).toHaveLength(1);
  return (found[0] ?? "").replaceAll("http://HOST/r/ID#KEY", address);
}

/** The script with the installed package in place of the downloaded file. */
function withPackage(script: string): string {
  expect(script).toContain('"./corridor.js"');
  return script.replace('"./corridor.js"', '"@corridor/client"');
}

/** A page's robot in the first maze, faster than in real time. */
async function openRobot(page: Page): Promise<string> {
  await page.goto("/");
  await setSpeed(page, "16");
  return copyAddress(page);
}

/** Puts the robot of a page back to its start. */
async function startOver(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect(page.getByText("Robot at 50, 650, facing right")).toBeAttached();
}

/** The number of the last command of the robot. */
async function lastCommand(address: string): Promise<number> {
  const { commands } = await (await api(address, "/commands?after=0")).json();
  return commands.at(-1)?.seq ?? 0;
}

/** The actions of all commands after a number. All of them must have completed. */
async function completedActions(address: string, after: number): Promise<string[]> {
  const { commands } = await (await api(address, `/commands?after=${after}`)).json();
  return commands.map((command: { state: string; action: string }) => {
    expect(command).toMatchObject({ state: "completed" });
    return command.action;
  });
}

/**
 * The command pip for an environment without it: that of the system, because its installation takes
 * longer than all else.
 */
function pipFor(python: string): [string, ...string[]] {
  const quiet = ["--quiet", "--disable-pip-version-check"];
  const ofSystem = ["-m", "pip", "--python", python] as const;
  if (folder.try("python3", ...ofSystem, "--version").code === 0) {
    return ["python3", ...ofSystem, ...quiet];
  }
  folder.run(python, "-m", "ensurepip");
  return [python, "-m", "pip", ...quiet];
}

/** @returns the address of an empty page with another origin than the relay */
async function serveOtherSite(): Promise<string> {
  otherSite = createServer((_request, response) => {
    response.setHeader("Content-Type", "text/html");
    response.end("<title>Another site</title>");
  });
  await once(otherSite.listen(0, "127.0.0.1"), "listening");
  return `http://127.0.0.1:${(otherSite.address() as AddressInfo).port}/`;
}

test("the npm package contains the built files, drives as in its README, and has types", async ({
  page,
}) => {
  const { tarball, files } = await folder.install(PACKAGE);
  expect(files.toSorted()).toEqual([
    "LICENSE",
    "README.md",
    "host.d.ts",
    "host.js",
    "index.d.ts",
    "index.js",
    "learn.d.ts",
    "learn.js",
    "package.json",
    "show.d.ts",
    "show.js",
    "teach.d.ts",
    "teach.js",
    "watch.d.ts",
    "watch.js",
  ]);
  expect((await publint({ pkgDir: PACKAGE, strict: true })).messages).toEqual([]);
  // The package has ES modules only.
  const checker = join(dirname(require.resolve("@arethetypeswrong/cli/package.json")), "dist");
  folder.run(process.execPath, join(checker, "index.js"), tarball, "--profile", "esm-only");

  await test.step("TypeScript checks a script", async () => {
    const script = withPackage(await example("while ((await", "http://HOST/r/ID#KEY"));
    await folder.write(
      "drive.mts",
      `${script}
import { HostConnection } from "@corridor/client/host";
import { StudentConnection } from "@corridor/client/learn";
import { ScreenConnection } from "@corridor/client/show";
import { TeacherConnection } from "@corridor/client/teach";
import { WatchConnection } from "@corridor/client/watch";
export const connections = [
  HostConnection,
  StudentConnection,
  ScreenConnection,
  TeacherConnection,
  WatchConnection,
];
// @ts-expect-error: a move needs a distance in cm
await robot?.move("far");
`,
    );
    const options = ["--noEmit", "--strict", "--target", "es2024", "--module", "nodenext"];
    folder.run(process.execPath, require.resolve("typescript/bin/tsc"), ...options, "drive.mts");
  });

  await test.step("the README's first example drives from an empty folder", async () => {
    const address = await openRobot(page);
    await folder.write("drive.mjs", withPackage(await example("while ((await", address)));
    expect(folder.run(process.execPath, "drive.mjs")).toMatch(/^\d+(\.\d+)?\n$/);
    const actions = await completedActions(address, 0);
    expect(actions[0]).toBe("move");
    expect(actions.at(-1)).toBe("left 90");
  });
});

test("scripts with the downloaded corridor.js, a page of another site and the Python wheel drive", async ({
  page,
  relay,
  browser,
}) => {
  folder.run("curl", "-sSfO", `${relay}/corridor.js`);

  await test.step("an uncaught error prints its sentence and a short stack", async () => {
    await folder.write(
      "drive.mjs",
      `import { RobotClient } from "./corridor.js";
await RobotClient.connect("http://HOST");
`,
    );
    const { status, stderr } = spawnSync(process.execPath, ["drive.mjs"], {
      cwd: folder.path,
      encoding: "utf8",
    });
    expect(status).toBe(1);
    expect(stderr).toMatch(/^ClientError: .*\(bad-address\)/m);
    expect(stderr.length).toBeLessThan(2_000);
  });

  await test.step("corridor.js contains the license of the library in it", async () => {
    const answer = await fetch(`${relay}/corridor.js`);
    expect(await answer.text()).toMatch(/^\/\*! Contains zod:\s+MIT License\s+Copyright/);
  });

  folder.run("python3", "-m", "venv", "--without-pip", "env");
  const python = join(
    folder.path,
    "env",
    process.platform === "win32" ? "Scripts/python" : "bin/python",
  );
  const pip = pipFor(python);
  folder.run(...pip, "wheel", "--no-deps", "--wheel-dir", "wheels", PYTHON_CLIENT);
  folder.run(...pip, "install", "--no-index", "--find-links", "wheels", "corridor");

  // A page draws also while its robot stands: it opens last.
  const address = await openRobot(page);

  for (const { runtime, flags } of [
    { runtime: "Node", flags: [] },
    {
      runtime: "a Node without WebSocket, such as Node 20",
      flags: ["--no-experimental-websocket"],
    },
  ]) {
    await test.step(`a script next to the downloaded corridor.js drives in ${runtime}`, async () => {
      await startOver(page);
      const last = await lastCommand(address);
      const script = await example("while ((await", address);
      expect(script.trimEnd().split("\n").length).toBeLessThanOrEqual(12);
      await folder.write("drive.mjs", script);
      expect(folder.run(process.execPath, ...flags, "drive.mjs")).toMatch(/^\d+(\.\d+)?\n$/);
      expect((await completedActions(address, last)).at(-1)).toBe("left 90");
    });
  }

  await test.step("a page of another site imports corridor.js and drives", async () => {
    // The relay rejects WebSockets of other sites, which the browser reports as an error in this
    // context. The library falls back to long polling.
    const context = await browser.newContext();
    const other = await context.newPage();
    await other.goto(await serveOtherSite());
    const state = await other.evaluate(
      async ([library = "", robotAddress = ""]) => {
        const { RobotClient } = await import(library);
        const robot = await RobotClient.connect(robotAddress);
        const record = await robot.right90();
        robot.close();
        return record.state;
      },
      [`${relay}/corridor.js`, address],
    );
    expect(state).toBe("completed");
    await context.close();
  });

  await test.step("the Python README's first example drives from an empty folder with the installed wheel", async () => {
    await startOver(page);
    const last = await lastCommand(address);
    await folder.write(
      "drive.py",
      await example("robot.forward(100)\nrobot.left(90)", address, PYTHON_CLIENT),
    );
    expect(folder.run(python, "drive.py")).toMatch(/^\d+\n$/);
    expect((await completedActions(address, last)).at(-1)).toBe("left 90");
  });
});
