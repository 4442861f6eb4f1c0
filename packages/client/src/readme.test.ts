/** Runs the examples of the READMEs and of /docs/commands at a real relay, as published. */
import { execFile, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it, onTestFinished } from "vitest";
import { RobotClient } from "./robot-client.ts";
import { robotWithCode, type RobotWithCode } from "./testing/robot-with-code.ts";

const ROOT = join(import.meta.dirname, "../../..");
const LIBRARY = join(ROOT, "packages/client-python/src");

const node = [process.execPath, "--input-type=module", "-e"];
const python = ["python3", "-c"];
const bash = ["bash", "-c"];

/** The one block of a README in which this stands. */
function shown(readme: string, words: string): string {
  const text = readFileSync(join(ROOT, readme), "utf8");
  const blocks = [...text.matchAll(/^( *)```(?:ts|js|python|sh|bash)\n([^]*?)^ *```$/gm)];
  const found = blocks.filter(([, , block]) => block?.includes(words));
  expect(found).toHaveLength(1);
  const [[, indent = "", block = ""] = []] = found;
  return block.replaceAll(new RegExp(`^${indent}`, "gm"), "");
}

/** The same with this robot in place of the one in the README. */
function withRobot(program: string, { origin, registration, code }: RobotWithCode): string {
  return program
    .replaceAll(/http:\/\/(?:HOST|localhost:8080)\/r\/ID#KEY/g, registration.address)
    .replaceAll(/http:\/\/(?:HOST|localhost:8080)/g, origin)
    .replaceAll(/BCDF ?GHJK/g, code);
}

/** @returns what it wrote on its standard output */
async function run([program = "", ...words]: readonly string[], text: string): Promise<string> {
  const env = { ...process.env, PYTHONPATH: LIBRARY };
  const { stdout } = await promisify(execFile)(program, [...words, text], { cwd: ROOT, env });
  return stdout;
}

/** Whether it is on this machine. */
const hasCurl = spawnSync("curl", ["--version"]).status === 0;

describe("what a README shows", () => {
  it.each([
    { readme: "packages/client/README.md", words: "finally", by: node },
    { readme: "packages/client-python/README.md", words: "while robot.sensor.front", by: python },
    { readme: "packages/client-python/README.md", words: "asyncio.run", by: python },
  ])("$readme drives by an address: $words", async ({ readme, words, by }) => {
    const scene = await robotWithCode(["#####", "#...#", "#####"]);
    const script = await RobotClient.connect(scene.registration.address);
    await script.right90();
    script.close();
    await run(by, withRobot(shown(readme, words), scene));
    expect(scene.robot.done[1]).toMatchObject({ action: "move", distance: 100 });
  });

  it.each([
    { readme: "packages/client/README.md", words: "goalReached, bumps", by: node },
    { readme: "packages/client-python/README.md", words: "robot.goal_reached", by: python },
  ])("$readme follows the right wall to the goal: $words", async ({ readme, words, by }) => {
    const scene = await robotWithCode(["#####", "#...#", "###.#", "#####"]);
    scene.robot.goal = { column: 3, row: 2 };
    expect(await run(by, withRobot(shown(readme, words), scene))).toMatch(
      /^Goal reached after 0 bumps\n$/,
    );
    expect(scene.robot.snapshot().pose).toMatchObject({ x: 350, y: 250 });
  });

  it.each([
    { readme: "packages/client/README.md", words: "await robot.maze()", by: node },
    { readme: "packages/client-python/README.md", words: "robot.maze()", by: python },
  ])("$readme reads the maze: $words", async ({ readme, words, by }) => {
    const scene = await robotWithCode(["####", "#..#", "####"]);
    const { origin, registration } = scene;
    await fetch(`${origin}/api/v1/robots/${registration.id}/maze`, {
      method: "PUT",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({
        format: "corridor/maze",
        version: 1,
        name: "Two cells",
        blocks: ["####", "#..#", "####"],
        start: { column: 1, row: 1, heading: "east" },
        goals: [{ column: 2, row: 1 }],
      }),
    });
    const output = await run(by, withRobot(shown(readme, words), scene));
    expect(output).toMatch(/^Two cells/);
    expect(output).toContain("Goal at 2 1\n");
  });

  it.for([
    { readme: "packages/client/README.md", words: "RobotClient.pair(", by: node, turns: 1 },
    { readme: "packages/client-python/README.md", words: "Robot.pair(", by: python, turns: 1 },
    { readme: "examples/README.md", words: "python3 -c", by: bash, turns: 0 },
    { readme: "examples/README.md", words: "curl -s", by: bash, turns: 0 },
  ])(
    "$readme gets an address by a code: $words",
    async ({ readme, words, by, turns }, { skip }) => {
      skip(words.startsWith("curl") && !hasCurl, "curl is not on this machine");
      const scene = await robotWithCode(["####", "#..#", "####"]);
      const [said] = await Promise.all([
        run(by, withRobot(shown(readme, words), scene)),
        scene.say(true),
      ]);
      const { origin, registration, robot } = scene;
      const address = /http:[^"\s]+/.exec(said)?.[0];
      expect(address).toContain(`${origin}/r/${registration.id}#drv_`);
      expect(address).not.toBe(registration.address);
      expect(robot.done).toHaveLength(turns);
    },
  );

  it("the function in /docs/commands retries, and the robot moves once", async () => {
    const scene = await robotWithCode(["#####", "#...#", "#####"]);
    const script = await RobotClient.connect(scene.registration.address);
    await script.right90();
    script.close();
    const { origin, tries } = await networkThatLosesTheFirstAnswer(scene.origin);
    const [, key = ""] = scene.registration.address.split("#");
    const program = shown("apps/relay/src/docs/pages/commands.md", "randomUUID")
      .replace("http://HOST", origin)
      .replace("/ID", `/${scene.registration.id}`)
      .replace("KEY", key);
    expect(await run(node, program)).toBe("Command 2 was stored by an earlier attempt\n");
    expect(tries).toHaveLength(2);
    await expect.poll(() => scene.robot.done.length).toBe(2);
    expect(scene.robot.done[1]).toMatchObject({ action: "move", distance: 100 });
  });
});

/** In front of the relay: the first request reaches it, and its answer is lost. */
async function networkThatLosesTheFirstAnswer(relay: string) {
  const tries: string[] = [];
  const pass = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const chunks: Buffer[] = [];
    for await (const chunk of request) chunks.push(chunk as Buffer);
    const body = Buffer.concat(chunks).toString();
    const { method = "", url = "", headers } = request;
    const passed = Object.entries(headers).filter(([name]) =>
      ["authorization", "content-type", "idempotency-key"].includes(name),
    ) as [string, string][];
    const answer = await fetch(relay + url, { method, headers: passed, body });
    const text = await answer.text();
    tries.push(body);
    if (tries.length === 1) response.destroy();
    else response.writeHead(answer.status).end(text);
  };
  const server = createServer((request, response) => {
    pass(request, response).catch(() => response.destroy());
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  onTestFinished(() => void server.close());
  return { origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, tries };
}
