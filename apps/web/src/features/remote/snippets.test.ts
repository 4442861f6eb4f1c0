/** The scripts are run as a user would run them, against a small robot that answers over HTTP. */
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createServer, type IncomingMessage } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import {
  snippet,
  snippetLanguages,
  starterLines,
  starterScript,
  type SnippetLanguage,
} from "./snippets.ts";

const KEY = "d_test-key";

/** What the robot sees on its way, and what a right-hand follower does there. */
const way = [
  { sensors: { front: 150, right: 50, back: 50, left: 50 }, actions: ["move 100"] },
  { sensors: { front: 50, right: 50, back: 50, left: 150 }, actions: ["left 90"] },
  { sensors: { front: 150, right: 150, back: 50, left: 50 }, actions: ["right 90", "move 100"] },
];

function startRobot() {
  let step = 0;
  let polls = 0;
  const actions: string[] = [];
  const refused: string[] = [];
  const server = createServer((request, response) => {
    void answer(request).then((body) => {
      response.writeHead(body === null ? 401 : 200, { "content-type": "application/json" });
      response.end(JSON.stringify(body));
    });
  });
  async function answer(request: IncomingMessage): Promise<unknown> {
    const text = await read(request);
    if (request.headers.authorization !== `Bearer ${KEY}`) {
      refused.push(request.url ?? "");
      return null;
    }
    const path = request.url?.replace("/api/v1/robots/r1", "") ?? "";
    if (path === "/sensors") {
      return { goalReached: step >= way.length, sensors: way[step]?.sensors };
    }
    if (path === "/commands") {
      const { action, distance } = JSON.parse(text) as { action: string; distance?: number };
      actions.push(distance === undefined ? action : `${action} ${distance}`);
      const isLast = actions.length === way.slice(0, step + 1).flatMap((at) => at.actions).length;
      if (isLast) step++;
      polls = 0;
      return { seq: actions.length, state: "accepted" };
    }
    expect(path).toBe(`/commands/${actions.length}?wait=20`);
    polls++;
    return { seq: actions.length, state: polls < 2 ? "started" : "completed" };
  }
  return { server, actions, refused };
}

async function read(request: IncomingMessage): Promise<string> {
  let text = "";
  for await (const chunk of request.setEncoding("utf8")) text += String(chunk);
  return text;
}

const programs = {
  python: ["python3", "script.py"],
  javascript: [process.execPath, "script.mjs"],
  java: ["java", "Robot.java"],
} as const;

/** Lines that a reader takes in: Java says the same in more of them. */
const mostLines: Record<SnippetLanguage, number> = {
  python: 32,
  javascript: 32,
  java: 44,
  curl: 32,
};

const hasJava = spawnSync(programs.java[0], ["-version"]).status === 0;

/** Runs a script to its end. @returns what it printed */
async function run(language: keyof typeof programs, port: number): Promise<string> {
  const [program, file] = programs[language];
  const folder = await mkdtemp(join(tmpdir(), "corridor-script-"));
  const text = snippet(language, `http://127.0.0.1:${port}/api/v1/robots/r1`, KEY);
  await writeFile(join(folder, file), text);
  const child = spawn(program, [file], { cwd: folder, stdio: ["ignore", "pipe", "inherit"] });
  let output = "";
  child.stdout.on("data", (chunk: Buffer) => (output += chunk.toString()));
  const ended = await once(child, "close");
  await rm(folder, { recursive: true });
  expect(ended).toEqual([0, null]);
  return output;
}

describe("the scripts to copy", () => {
  for (const language of ["python", "javascript", "java"] as const) {
    const isMissing = language === "java" && !hasJava;
    it.skipIf(isMissing)(`in ${language} follow the right wall`, async () => {
      const robot = startRobot();
      robot.server.listen(0, "127.0.0.1");
      await once(robot.server, "listening");
      const { port } = robot.server.address() as AddressInfo;
      expect(await run(language, port)).toBe("Goal reached\n");
      expect(robot.actions).toEqual(way.flatMap((at) => at.actions));
      expect(robot.refused).toEqual([]);
      robot.server.close();
    });
  }

  it.each(snippetLanguages)("in %s are short enough to read", (language) => {
    const lines = snippet(language, "https://host/api/v1/robots/r1", KEY).split("\n");
    expect(lines.length).toBeLessThanOrEqual(mostLines[language]);
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(92);
  });

  it("begin with one of six lines, in which a reader finds the address", () => {
    const address = "https://host/r/r1#d_test-key";
    const lines = starterScript(address).trimEnd().split("\n");
    expect(lines).toHaveLength(starterLines);
    expect(lines[0]).toBe("from corridor import Robot");
    expect(lines[1]).toContain(`"${address}"`);
  });
});
