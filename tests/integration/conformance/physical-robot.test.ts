/** Scripts drive the example of a physical robot in the same way as the page's robot. */
import { execFile, execFileSync } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { SILENT_WORDS, type CommandRecord } from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { startPhysicalRobot } from "../../support/conformance/physical-robot.ts";

const run = promisify(execFile);
const EXAMPLES = join(import.meta.dirname, "../../../examples");
const TREE = "#####,#.#.#,#.#.#,#...#,#####";

/** @returns the robot's address */
async function startHost(room: string): Promise<string> {
  const robot = await startPhysicalRobot({ room });
  onTestFinished(robot.stop);
  return robot.address;
}

/** The commands of a robot by single requests. */
function apiOf(address: string) {
  const [robot = "", key = ""] = address.split("#");
  const url = robot.replace("/r/", "/api/v1/robots/");
  const headers = { Authorization: `Bearer ${key}`, "Content-Type": "application/json" };
  const ask = async (path: string, init: RequestInit): Promise<CommandRecord> =>
    (await (await fetch(url + path, { ...init, headers })).json()) as CommandRecord;
  return {
    send: (command: object) => ask("/commands", { method: "POST", body: JSON.stringify(command) }),
    get: (path: string, signal: AbortSignal | null = null) => ask(path, { signal }),
  };
}

function has([program = "", ...words]: string[]): boolean {
  try {
    execFileSync(program, words, { stdio: "ignore" });
    return true;
  } catch {
    process.stderr.write(`physical-robot.test.ts: skipped a test, there is no ${program} here\n`);
    return false;
  }
}

describe("the physical robot", () => {
  it("rejects a reset and has no maze, after which a script continues", async () => {
    const script = `
import sys
from corridor import CommandError, NoMazeError, Robot

with Robot(sys.argv[1]) as robot:
    try:
        robot.reset()
    except CommandError as error:
        print(error.code, error.hint)
    try:
        robot.maze()
    except NoMazeError as error:
        print(error.code, error.hint)
    print(robot.right().state)
`;
    const env = { ...process.env, PYTHONPATH: join(EXAMPLES, "../packages/client-python/src") };
    const { stdout } = await run("python3", ["-c", script, await startHost(TREE)], { env });
    expect(stdout).toBe(
      `refused This robot cannot put itself at its start. Carry it there, or continue from where it is.
no-maze This robot has no map of its room. Use only its sensors.
completed
`,
    );
  });

  it("stops soon after a script has ended that waits for its command", async () => {
    const { send, get } = apiOf(
      await startHost("####################,#..................#,####################"),
    );
    const { seq } = await send({ action: "right 90" });
    await get(`/commands/${seq}?wait=25`);
    const forward = await send({ action: "forward" });
    const script = new AbortController();
    const waiting = get(`/commands/${forward.seq}?wait=25`, script.signal);
    setTimeout(() => script.abort(), 500);
    await expect(waiting).rejects.toThrow("aborted");
    // Each look counts as contact with the script.
    await vi.waitFor(
      async () =>
        expect(await get(`/commands/${forward.seq}`)).toMatchObject({ state: "cancelled" }),
      { timeout: 30_000, interval: 5_000 },
    );
  });

  it("is at the goal once the whole robot stands in the cell", async () => {
    const { send, get } = apiOf(await startHost("###,#G#,#.#,#S#,###"));
    const { seq } = await send({ action: "forward", until: [{ goal: true }] });
    const record = await get(`/commands/${seq}?wait=25`);
    expect(record.state).toBe("completed");
    expect(record.distance).toBeGreaterThan(170);
  });

  it("is driven by the Python library, including motions without an end", async () => {
    const script = `
import sys, time
from corridor import Robot

with Robot(sys.argv[1]) as robot:
    robot.right()
    robot.forward()
    assert robot.wait_until(lambda sensor: sensor.front < 1000, timeout=30).front < 1000
    assert robot.snapshot().motion == "forward"
    robot.reverse()
    time.sleep(4)
    last = robot.commands[-1]
    print(last.action, last.state, last.reason)
    robot.forward()
`;
    const env = { ...process.env, PYTHONPATH: join(EXAMPLES, "../packages/client-python/src") };
    const address = await startHost(`${"#".repeat(16)},#${".".repeat(14)}#,${"#".repeat(16)}`);
    const { stdout } = await run("python3", ["-c", script, address], { env });
    expect(stdout).toBe(
      `reverse cancelled The script ${SILENT_WORDS} for 3 s, so the robot stopped.\n`,
    );
    const { origin, pathname, hash } = new URL(address);
    const log = await fetch(`${origin}/api/v1/robots/${pathname.slice(3)}/commands?after=4`, {
      headers: { Authorization: `Bearer ${hash.slice(1)}` },
    });
    // The client stops the robot at the end of its `with` block.
    expect(await log.json()).toMatchObject({
      commands: [{ action: "stop", state: "completed" }],
    });
  });

  it("rejects a command that was delayed on the long-poll connection", async () => {
    const { origin, pathname, hash } = new URL(await startHost(TREE));
    const api = `${origin}/api/v1/robots/${pathname.slice(3)}`;
    const post = async (path: string, body: object, key = hash.slice(1)) => {
      const headers = { Authorization: `Bearer ${key}`, "Content-Type": "application/json" };
      const response = await fetch(api + path, {
        method: "POST",
        body: JSON.stringify(body),
        headers,
      });
      return (await response.json()) as { key: string };
    };
    const hello = { type: "hello", version: 1, role: "drive", key: hash.slice(1), sentAt: 1_500 };
    const { key } = await post("/long-poll", hello);
    // By the script's clock, the command was sent 1.5 s before the hello.
    const delayed = { action: "left 90", ttl: 1_000 };
    const messages = [{ type: "command", key: "delayed-1", command: delayed, sentAt: 0 }];
    await post("/long-poll/messages", { first: 1, messages }, key);
    const fetched = await fetch(`${api}/long-poll/messages?after=0&wait=5`, {
      headers: { Authorization: `Bearer ${key}` },
    });
    expect(await fetched.json()).toMatchObject({
      messages: expect.arrayContaining([
        { type: "problem", key: "delayed-1", problem: expect.objectContaining({ status: 422 }) },
      ]),
    });
  });

  it.for([
    {
      language: "Python",
      words: ["python3", "python/right_wall.py"],
      probe: ["python3", "--version"],
    },
    { language: "Java", words: ["java", "java/Robot.java"], probe: ["java", "-version"] },
    {
      language: "JavaScript",
      words: [process.execPath, "javascript/right-wall.ts"],
      probe: [process.execPath, "--version"],
    },
    { language: "Bash", words: ["bash", "curl/right_wall.sh"], probe: ["curl", "--version"] },
  ])("is driven by the unchanged script in $language", async ({ words, probe }, { skip }) => {
    const [program = "", file = ""] = words;
    skip(!has(probe));
    const address = await startHost(TREE);
    const script = [join(EXAMPLES, file), address, "--until-cells", "7"];
    const { stdout } = await run(program, script);
    expect(stdout).toMatch(/7 cells visited after \d+ moves\.\n$/);
    expect(stdout).not.toContain("Bumped");
  });
});
