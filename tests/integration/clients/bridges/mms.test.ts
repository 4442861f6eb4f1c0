/** `corridor mms` in its own process, with programs in theirs and a robot at a real relay. */
import { scriptListSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { MazeFrame } from "../../../../packages/mouse/src/maze-frame.ts";
import { documentOf, mouseMazes } from "../../../../packages/mouse/src/testing/mouse-mazes.ts";
import { BridgeProcess } from "../../../support/bridges/bridge-process.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

const support = new URL("../../../support/mouse/", import.meta.url).pathname;
const [maze] = mouseMazes.map((each) => documentOf(each));
const python = ["python3", `${support}flood_fill.py`];
const javascript = [process.execPath, `${support}wall-follower.mjs`];

/** A program in a line. It may use `ask`, which sends a command and reads its response. */
function script(code: string): string[] {
  const ask = `
    const input = require("node:readline").createInterface({ input: process.stdin });
    const lines = input[Symbol.asyncIterator]();
    const say = (line) => console.log(line);
    const ask = async (line) => { say(line); return (await lines.next()).value; };
    const log = (text) => console.error(text);`;
  return [process.execPath, "-e", `${ask}(async () => { ${code} })()`];
}

const sharedRelay = sharedRelayProcess();

async function robotInMaze() {
  const host = await corridorHost(await sharedRelay(), maze);
  const { id, driverKey, ownerKey } = host.registration;
  const address = `${host.relay.url}/r/${id}#${driverKey}`;
  const start = (program: string[]): BridgeProcess =>
    BridgeProcess.launch(["mms", "--", ...program], { CORRIDOR_ROBOT: address });
  const asOwner = async (method: string, path: string, body?: object): Promise<Response> =>
    fetch(`${host.relay.url}/api/v1/robots/${id}${path}`, {
      method,
      headers: { Authorization: `Bearer ${ownerKey}`, "Content-Type": "application/json" },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
  return { ...host, address, start, asOwner };
}

describe("corridor mms", () => {
  it.each([
    { name: "Python", program: python, log: /^score / },
    { name: "JavaScript", program: javascript, log: /^turns / },
  ])("lets a program in $name drive to the centre", async ({ program, log }) => {
    const { start, page } = await robotInMaze();
    const bridge = start(program);
    expect(await bridge.exited).toBe(0);
    expect(bridge.output).toEqual({ stdout: "", stderr: expect.stringMatching(log) });
    if (maze === undefined) throw new Error("no maze");
    const frame = new MazeFrame(maze);
    const { x, y } = frame.placeOf(page.robot.pose);
    expect(frame.isGoal({ x: Math.floor(x / 2), y: Math.floor(y / 2) })).toBe(true);
    expect(page.robot.snapshot().bumps).toBe(0);
  });

  it("shows the owner a script named mms, and sends no display command to the robot", async () => {
    const { start, page, asOwner } = await robotInMaze();
    const bridge = start(
      script(`for (let i = 0; i < 500; i++) say("setText 0 0 " + i);
        await ask("moveForward"); log("ready"); setInterval(() => undefined, 1000);`),
    );
    await bridge.says(/ready/);
    const { scripts } = scriptListSchema.parse(await (await asOwner("GET", "/scripts")).json());
    expect(scripts).toMatchObject([{ client: "mms", name: null, connections: 1 }]);
    expect(page.robot.done.map(({ action }) => action)).toEqual(["reset", "move"]);
    const texts = (): string[] => page.marks.flatMap(({ cells }) => cells.map(({ text }) => text));
    await expect.poll(() => texts().at(-1), { timeout: 5_000 }).toBe("499");
    expect(texts().length).toBeLessThan(20);
    bridge.signal("SIGINT");
    expect(await bridge.exited).toBe(0);
    await expect.poll(() => page.marks.at(-1)).toEqual({ fresh: true, pitch: 1, cells: [] });
  });

  it("reads the address as an argument, and gives the program all of its own", async () => {
    const { address } = await robotInMaze();
    const program = script(`log(process.argv.slice(1)); process.exit()`);
    const bridge = BridgeProcess.launch(["mms", address, "--", ...program, "--", "--help", "-h"]);
    expect(await bridge.exited).toBe(0);
    expect(bridge.output.stderr).toContain("'--help', '-h'");
  });

  it("prints one line for an invalid command, and responds to the next", async () => {
    const { start } = await robotInMaze();
    const bridge = start(script(`say("fly"); log(await ask("mazeWidth")); process.exit()`));
    expect(await bridge.exited).toBe(0);
    expect(bridge.output.stderr).toBe("Invalid command: fly\n6\n");
  });

  it("stops a program that floods its output, and one that never reads", async () => {
    const { start } = await robotInMaze();
    const flood = `const more = () => { while (process.stdout.write("mazeWidth\\n".repeat(1000)));
      process.stdout.once("drain", more); }; input.pause(); more();`;
    const bridge = start(script(`${flood} setTimeout(() => log("still here"), 1500);`));
    await bridge.says(/still here/);
    bridge.signal("SIGTERM");
    expect(await bridge.exited).toBe(0);
    expect(bridge.output.stderr).toBe("still here\n");
  });

  it("responds after a flood of display commands", async () => {
    const { start } = await robotInMaze();
    const bridge = start(
      script(`const text = "setText 1 1 abc\\nsetColor 2 2 g\\n".repeat(2000);
        for (let i = 0; i < 500; i++) if (!process.stdout.write(text))
          await new Promise((resolve) => process.stdout.once("drain", resolve));
        log(await ask("mazeHeight")); process.exit();`),
    );
    expect(await bridge.exited).toBe(0);
    expect(bridge.output.stderr).toBe("6\n");
  });

  it.each([
    { name: "fails", code: "process.exit(3)", message: /ended with exit code 3\.\n$/ },
    {
      name: "is killed",
      code: 'process.kill(process.pid, "SIGKILL")',
      message: /with SIGKILL\.\n$/,
    },
  ])("exits with 1 when the program $name", async ({ code, message }) => {
    const { start } = await robotInMaze();
    const bridge = start(script(code));
    expect(await bridge.exited).toBe(1);
    expect(bridge.output.stderr).toMatch(message);
  });

  it("stops the robot and the program on Ctrl+C", async () => {
    const { start, page } = await robotInMaze();
    const bridge = start(script(`await ask("mazeWidth"); log("ready"); await ask("moveForward");`));
    await bridge.says(/ready/);
    page.endsCommands = false;
    await expect.poll(() => page.running, { timeout: 10_000 }).toBe(1);
    bridge.signal("SIGINT");
    expect(await bridge.exited).toBe(0);
    expect(page.running).toBe(0);
  });

  it("stops the robot when the program ends while it drives", async () => {
    const { start, page } = await robotInMaze();
    const code = `await ask("mazeWidth"); log("ready"); setTimeout(() => say("moveForward"), 500);
      setTimeout(() => process.exit(), 2000);`;
    const bridge = start(script(code));
    await bridge.says(/ready/);
    page.endsCommands = false;
    await expect.poll(() => page.running, { timeout: 10_000 }).toBe(1);
    expect(await bridge.exited).toBe(0);
    expect(page.running).toBe(0);
  });

  it("ends the program when the key is revoked, and prints the reason once", async () => {
    const { start, asOwner } = await robotInMaze();
    const bridge = start(
      script(`await ask("turnLeft"); log("ready"); for (;;) await ask("turnLeft");`),
    );
    await bridge.says(/ready/);
    await asOwner("POST", "/keys", { kind: "drive", replace: true });
    expect(await bridge.exited).toBe(1);
    expect(bridge.output.stderr.match(/The key is invalid or was revoked\./g)).toHaveLength(1);
  });

  it.each([
    {
      name: "a missing program",
      program: ["./missing"],
      message: "There is no program ./missing.",
    },
    {
      name: "a file that is no program",
      program: [`${support}flood_fill.py`],
      message: "Write its language",
    },
  ])("exits with 1 for $name, before it moves the robot", async ({ program, message }) => {
    const { start, page } = await robotInMaze();
    const bridge = start(program);
    expect(await bridge.exited).toBe(1);
    expect(bridge.output.stderr).toContain(message);
    expect(page.robot.done).toEqual([]);
  });

  it("explains how to name the program", async () => {
    for (const args of [
      ["mms", "--"],
      ["mms", "./mouse"],
    ]) {
      const bridge = BridgeProcess.launch(args);
      expect(await bridge.exited).toBe(2);
      expect(bridge.output.stderr).toContain("expected -- and a program");
    }
  });

  it("says why a watch key cannot drive", async () => {
    const { relay, registration, asOwner } = await robotInMaze();
    const { address } = (await (await asOwner("POST", "/keys", { kind: "watch" })).json()) as {
      address: string;
    };
    expect(address).toContain(`${relay.url}/r/${registration.id}`);
    const bridge = BridgeProcess.launch(["mms", address, "--", ...javascript]);
    expect(await bridge.exited).toBe(1);
    expect(bridge.output.stderr).toContain("A watch key permits only reading.");
  });
});
