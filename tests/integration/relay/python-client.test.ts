/** Imports the downloaded single-file client with a real Python. */
import { execFile } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import { startTestRelay, testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

const run = promisify(execFile);

async function download(origin: string): Promise<string> {
  const folder = testFolder();
  const answer = await fetch(`${origin}/corridor.py`);
  expect(answer.status).toBe(200);
  expect(answer.headers.get("content-type")).toContain("text/x-python");
  writeFileSync(join(folder, "corridor.py"), await answer.text());
  return folder;
}

describe("/corridor.py", () => {
  it("is sufficient for a script beside it to drive a robot", async () => {
    const relay = await startTestRelay();
    const { address } = await relay.register();
    const folder = await download(relay.origin);
    const script = `
import sys
from corridor import *

robot = Robot(sys.argv[1])
print([robot, robot.commands, AsyncRobot.__name__])
try:
    robot.left("far")
except CommandError as error:
    print(error)
`;
    const { stdout } = await run("python3", ["-c", script, address], { cwd: folder });
    const [place] = address.split("#");
    expect(stdout.split("\n").slice(0, 2)).toEqual([
      `[<Robot ${place}>, [], 'AsyncRobot']`,
      "left() does not accept 'far' as degrees (bad-command). Pass a number from -3600 to 3600 degrees.",
    ]);
  });

  it("contains each import once and no import of package modules", async () => {
    const relay = await startTestRelay();
    const text = await (await fetch(`${relay.origin}/corridor.py`)).text();
    expect(text).not.toMatch(/^from \./m);
    const imports = text.match(/^(?:import|from) .*$/gm) ?? [];
    expect(new Set(imports).size).toBe(imports.length);
    expect(text.startsWith('"""Drive a robot')).toBe(true);
  });

  it("is read-only", async () => {
    const relay = await startTestRelay();
    const answer = await fetch(`${relay.origin}/corridor.py`, { method: "POST" });
    expect(answer.status).toBe(405);
  });
});
