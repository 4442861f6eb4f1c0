/** Runs the code in the READMEs and in /docs/commands, with a real relay. */
import { execFile, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it, onTestFinished } from "vitest";
import { createdKeySchema } from "@corridor/protocol";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { robotWithCode, type RobotWithCode } from "../../support/client/robot-with-code.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

const ROOT = join(import.meta.dirname, "../../..");
const LIBRARY = join(ROOT, "packages/client-python/src");

const node = [process.execPath, "--input-type=module", "-e"];
const python = ["python3", "-c"];
const bash = ["bash", "-c"];

/** The only code block of a README that contains `excerpt`. */
function blockIn(readme: string, excerpt: string): string {
  const text = readFileSync(join(ROOT, readme), "utf8");
  const blocks = [...text.matchAll(/^( *)```(?:ts|js|python|sh|bash)\n([^]*?)^ *```$/gm)];
  const found = blocks.filter(([, , block]) => block?.includes(excerpt));
  expect(found).toHaveLength(1);
  const [[, indent = "", block = ""] = []] = found;
  return block.replaceAll(new RegExp(`^${indent}`, "gm"), "");
}

/** Replaces the placeholder address and code, and the downloaded library by the one in the repository. */
function withRobot(program: string, { origin, registration, code }: RobotWithCode): string {
  return program
    .replaceAll(/http:\/\/(?:HOST|localhost:8080)\/r\/ID#KEY/g, registration.address)
    .replaceAll(/http:\/\/(?:HOST|localhost:8080)/g, origin)
    .replaceAll(/BCDF ?GHJK/g, code)
    .replace('"./corridor.js"', '"@corridor/client"');
}

/** @returns the standard output */
async function run([program = "", ...args]: readonly string[], code: string): Promise<string> {
  const env = { ...process.env, PYTHONPATH: LIBRARY };
  const { stdout } = await promisify(execFile)(program, [...args, code], { cwd: ROOT, env });
  return stdout;
}

const sharedRelay = sharedRelayProcess();
const hasCurl = spawnSync("curl", ["--version"]).status === 0;

const robotHere = async (maze: readonly string[]): Promise<RobotWithCode> =>
  robotWithCode((await sharedRelay()).url, maze);

describe("the code in the documentation", () => {
  it.each([
    { readme: "packages/client/README.md", excerpt: "while ((await", by: node },
    { readme: "packages/client-python/README.md", excerpt: "while robot.sensor.front", by: python },
    { readme: "packages/client-python/README.md", excerpt: "asyncio.run", by: python },
  ])("$readme drives by an address: $excerpt", async ({ readme, excerpt, by }) => {
    const testBed = await robotHere(["#####", "#...#", "#####"]);
    const script = await RobotClient.connect(testBed.registration.address);
    await script.right90();
    script.close();
    await run(by, withRobot(blockIn(readme, excerpt), testBed));
    expect(testBed.robot.done[1]).toMatchObject({ action: "move", distance: 100 });
  });

  it.each([
    { readme: "packages/client/README.md", excerpt: "now.goalReached", by: node },
    { readme: "packages/client-python/README.md", excerpt: "robot.goal_reached", by: python },
  ])("$readme follows the right wall to the goal: $excerpt", async ({ readme, excerpt, by }) => {
    const testBed = await robotHere(["#####", "#...#", "###.#", "#####"]);
    testBed.robot.goal = { column: 3, row: 2 };
    expect(await run(by, withRobot(blockIn(readme, excerpt), testBed))).toMatch(
      /^Goal reached after 0 bumps\n$/,
    );
    expect(testBed.robot.snapshot().pose).toMatchObject({ x: 350, y: 250 });
  });

  it.each([
    { readme: "packages/client/README.md", excerpt: "await robot.maze()", by: node },
    { readme: "packages/client-python/README.md", excerpt: "robot.maze()", by: python },
  ])("$readme reads the maze: $excerpt", async ({ readme, excerpt, by }) => {
    const testBed = await robotHere(["####", "#..#", "####"]);
    const { origin, registration } = testBed;
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
    const output = await run(by, withRobot(blockIn(readme, excerpt), testBed));
    expect(output).toMatch(/^Two cells/);
    expect(output).toContain("Goal at 2 1\n");
  });

  it.for([
    { readme: "packages/client/README.md", excerpt: "RobotClient.pair(", by: node, turns: 1 },
    { readme: "packages/client-python/README.md", excerpt: "Robot.pair(", by: python, turns: 1 },
    { readme: "examples/README.md", excerpt: "python3 -c", by: bash, turns: 0 },
    { readme: "examples/README.md", excerpt: "curl -s", by: bash, turns: 0 },
  ])(
    "$readme gets an address by a code: $excerpt",
    async ({ readme, excerpt, by, turns }, { skip }) => {
      skip(excerpt.startsWith("curl") && !hasCurl, "curl is not installed");
      const testBed = await robotHere(["####", "#..#", "####"]);
      const [output] = await Promise.all([
        run(by, withRobot(blockIn(readme, excerpt), testBed)),
        testBed.answer(true),
      ]);
      const { origin, registration, robot } = testBed;
      const address = /http:[^"\s]+/.exec(output)?.[0];
      expect(address).toContain(`${origin}/r/${registration.id}#drv_`);
      expect(address).not.toBe(registration.address);
      expect(robot.done).toHaveLength(turns);
    },
  );

  it.each([
    {
      language: "JavaScript",
      by: node,
      program: `import { RobotClient } from "@corridor/client";
        const robot = await RobotClient.connect(ADDRESS);
        console.log((await robot.sensors()).front);
        for await (const { kind } of robot.events()) { console.log(kind); break; }
        await robot.move(100).catch(({ code }) => console.log(code));
        robot.close();`,
    },
    {
      language: "Python",
      by: python,
      program: [
        "from corridor import NotAuthorisedError, Robot",
        "robot = Robot(ADDRESS)",
        "print(robot.sensor.front)",
        "for event in robot.events():",
        "    print(event.kind)",
        "    break",
        "try: robot.forward(100)",
        "except NotAuthorisedError as error: print(error.code)",
      ].join("\n"),
    },
  ])("a watch link reads in $language, and does not drive", async ({ by, program }) => {
    const { origin, registration, robot } = await robotHere(["####", "#..#", "####"]);
    const response = await fetch(`${origin}/api/v1/robots/${registration.id}/keys`, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({ kind: "watch" }),
    });
    const { address } = createdKeySchema.parse(await response.json());
    const output = await run(by, program.replace("ADDRESS", JSON.stringify(address)));
    expect(output).toBe("50\nsnapshot\nnot-authorised\n");
    expect(robot.done).toEqual([]);
  });

  it("the function in /docs/commands retries, and the robot moves once", async () => {
    const testBed = await robotHere(["#####", "#...#", "#####"]);
    const script = await RobotClient.connect(testBed.registration.address);
    await script.right90();
    script.close();
    const { origin, attempts } = await startProxyThatDropsFirstResponse(testBed.origin);
    const [, key = ""] = testBed.registration.address.split("#");
    const program = blockIn("apps/relay/src/site/docs/pages/commands.md", "randomUUID")
      .replace("http://HOST", origin)
      .replace("/ID", `/${testBed.registration.id}`)
      .replace("KEY", key);
    expect(await run(node, program)).toBe("Command 2 was stored by an earlier attempt\n");
    expect(attempts).toHaveLength(2);
    await expect.poll(() => testBed.robot.done.length).toBe(2);
    expect(testBed.robot.done[1]).toMatchObject({ action: "move", distance: 100 });
  });
});

/** A proxy in front of the relay that drops the first response. */
async function startProxyThatDropsFirstResponse(relay: string) {
  const attempts: string[] = [];
  const forward = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const chunks: Buffer[] = [];
    for await (const chunk of request) chunks.push(chunk as Buffer);
    const body = Buffer.concat(chunks).toString();
    const { method = "", url = "", headers } = request;
    const forwarded = Object.entries(headers).filter(([name]) =>
      ["authorization", "content-type", "idempotency-key"].includes(name),
    ) as [string, string][];
    const answer = await fetch(relay + url, { method, headers: forwarded, body });
    const text = await answer.text();
    attempts.push(body);
    if (attempts.length === 1) response.destroy();
    else response.writeHead(answer.status).end(text);
  };
  const server = createServer((request, response) => {
    forward(request, response).catch(() => response.destroy());
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  onTestFinished(() => void server.close());
  return { origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, attempts };
}
