/** The examples in further languages as their users run them, against the real relay. */
import { execFile, execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import { beforeAll, describe, expect, it, onTestFinished } from "vitest";
import { registerRobot } from "./register-robot.ts";
import { GridRobot } from "./testing/grid-robot.ts";
import { startRelayProcess } from "./testing/relay-process.ts";

const run = promisify(execFile);
const EXAMPLES = join(import.meta.dirname, "../../../examples");
const TREE = ["#######", "#.#...#", "#.#.#.#", "#...#.#", "#######"];

interface Example {
  language: string;
  /** the words of the command, before the address */
  command: readonly [program: string, ...words: string[]];
  /** asks the program whether it is there */
  probe: readonly string[];
  /** translates the example first, into a folder. @returns the command that runs it */
  build?: (folder: string) => Promise<Example["command"]>;
}

const examples: readonly Example[] = [
  {
    language: "Java",
    command: ["java", join(EXAMPLES, "java/Robot.java")],
    probe: ["-version"],
  },
  {
    language: "Go",
    command: ["go", "run", join(EXAMPLES, "go/robot.go")],
    probe: ["version"],
    // As "go run" does, but once for all tests.
    build: async (folder) => {
      const program = join(folder, "robot");
      await run("go", ["build", "-o", program, join(EXAMPLES, "go/robot.go")]);
      return [program];
    },
  },
  {
    language: "C#",
    command: ["dotnet", "run", join(EXAMPLES, "csharp/Robot.cs")],
    probe: ["--version"],
  },
  {
    language: "curl",
    command: ["bash", join(EXAMPLES, "curl/right_wall.sh")],
    probe: ["-c", "curl --version && awk 1 /dev/null"],
  },
];

/** Whether the program is on this machine; a test without it is skipped, and says so. */
function isHere({ language, command: [program], probe }: Example): boolean {
  try {
    execFileSync(program, probe, { stdio: "ignore" });
    return true;
  } catch {
    process.stderr.write(`examples.test.ts: skipped ${language}, there is no ${program} here\n`);
    return false;
  }
}

async function robotIn(maze: readonly string[]) {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.origin, fetch);
  const robot = new GridRobot(relay.origin, registration, maze);
  onTestFinished(() => robot.link.close());
  return { relay, robot, registration };
}

describe.each(examples)("the right-wall follower in $language", (example) => {
  const isMissing = !isHere(example);
  let [program, ...words] = example.command;
  const start = async (...more: string[]) => run(program, [...words, ...more]);

  beforeAll(async () => {
    if (isMissing || example.build === undefined) return;
    const folder = mkdtempSync(join(tmpdir(), "corridor-"));
    [program, ...words] = await example.build(folder);
    return () => rmSync(folder, { recursive: true, force: true });
  }, 120_000);

  it.skipIf(isMissing)("visits every cell without a bump, the relay killed under way", async () => {
    const { relay, robot, registration } = await robotIn(TREE);
    const cells = String(robot.openCells);
    const program = start(registration.address, "--until-cells", cells);
    await expect.poll(() => robot.visited.size, { timeout: 40_000 }).toBeGreaterThan(3);
    await relay.killAndRestart();
    const { stdout } = await program;
    expect(stdout).toMatch(new RegExp(`${cells} cells visited after \\d+ moves\\.\\n$`));
    expect(robot.visited.size).toBe(robot.openCells);
    expect(robot.snapshot().bumps).toBe(0);
  });

  it.skipIf(isMissing)("says in one sentence what is wrong with an address or a key", async () => {
    const { registration } = await robotIn(TREE);
    const [place] = registration.address.split("#");
    const noKey = start(`${place}`);
    await expect(noKey).rejects.toMatchObject({
      stderr: expect.stringMatching(/^This is not a robot's address[^\n]*\n$/),
    });
    const key = "drv_AAAAAAAAAAAAAAAAAAAAAA";
    const wrongKey = start(`${place}#${key}`);
    await expect(wrongKey).rejects.toMatchObject({
      stderr: expect.stringMatching(/^[^\n]*key[^\n]*\n$/),
    });
    await expect(wrongKey).rejects.not.toMatchObject({ stderr: expect.stringContaining(key) });
  });
});
