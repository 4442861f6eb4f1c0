/** The example of a physical robot: it passes the kit, and scripts drive it as they drive the page's. */
import { execFile, execFileSync, spawn } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it, onTestFinished } from "vitest";
import { runChecks } from "./run-checks.ts";

const run = promisify(execFile);
const EXAMPLES = join(import.meta.dirname, "../../../examples");
const TREE = "#####,#.#.#,#.#.#,#...#,#####";

/** @returns the robot's address */
async function startHost(room: string): Promise<string> {
  const words = ["--port", "0", "--haste", "4", "--room", room];
  const program = join(EXAMPLES, "physical-robot/robot_host.py");
  const child = spawn("python3", [program, ...words], { stdio: ["ignore", "pipe", "inherit"] });
  onTestFinished(() => void child.kill("SIGKILL"));
  for await (const data of child.stdout) {
    const line = String(data).trim();
    if (line !== "") return line;
  }
  throw new Error("the host did not start");
}

function has(program: string, versionOption: string): boolean {
  try {
    execFileSync(program, [versionOption], { stdio: "ignore" });
    return true;
  } catch {
    process.stderr.write(`physical-robot.test.ts: skipped a test, there is no ${program} here\n`);
    return false;
  }
}

describe("the physical robot", () => {
  it("does all that scripts rely on", async () => {
    const results = await runChecks(await startHost("#####,#...#,#...#,#...#,#####"));
    expect(results.filter(({ outcome }) => outcome.kind !== "passed")).toEqual([]);
  });

  it.each([
    { language: "Python", words: ["python3", "python/right_wall.py"], option: "--version" },
    { language: "Java", words: ["java", "java/Robot.java"], option: "-version" },
    { language: "Bash", words: ["bash", "curl/right_wall.sh"], option: "--version" },
  ])("is driven by the unchanged script in $language", async ({ words, option }) => {
    const [program = "", file = ""] = words;
    if (!has(program, option)) return;
    const address = await startHost(TREE);
    const script = [join(EXAMPLES, file), address, "--until-cells", "7"];
    const { stdout } = await run(program, script);
    expect(stdout).toMatch(/7 cells visited after \d+ moves\.\n$/);
    expect(stdout).not.toContain("Bumped");
  });
});
