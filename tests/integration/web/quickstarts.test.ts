/** Runs the scripts as a user would, against a small robot that responds over HTTP. */
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { quickstarts } from "@corridor/quickstarts";
import { describe, expect, it, onTestFinished } from "vitest";
import { shortRunOptions } from "../../support/java.ts";

const KEY = "d_test-key";
const languages = ["plainPython", "javascript", "java", "csharp", "go", "curl"] as const;
type Language = (typeof languages)[number];

const programs = {
  plainPython: ["python3", "drive.py"],
  javascript: [process.execPath, "drive.mjs"],
  java: ["java", ...shortRunOptions, "Robot.java"],
  // Mono stands in for .NET.
  csharp: ["sh", "-c", "mcs -r:System.Net.Http Robot.cs && exec mono Robot.exe"],
  go: ["sh", "-c", "go build -o drive drive.go && exec ./drive"],
  curl: ["sh", "drive.sh"],
} as const;

/** What runs each text, beside Node.js. */
const needs: Record<Language, readonly [program: string, option: string][]> = {
  plainPython: [["python3", "--version"]],
  javascript: [],
  java: [["java", "-version"]],
  csharp: [
    ["mcs", "--version"],
    ["mono", "--version"],
  ],
  go: [["go", "version"]],
  curl: [["curl", "--version"]],
};

/**
 * How a robot responds to a command and to the request for its record, and what the script prints.
 */
const endings = [
  { name: "was done", record: { state: "completed", reason: null }, prints: "completed" },
  {
    name: "was cancelled",
    record: { state: "cancelled", reason: "Remote is not driving: choose Remote." },
    prints: "Remote is not driving: choose Remote.",
  },
  { name: "was refused", detail: "The owner has paused.", prints: "The owner has paused." },
];

/** @returns the origin of a service with the robot, and the requests that the robot receives */
async function startRobot({ record, detail }: (typeof endings)[number]) {
  const requests: string[] = [];
  const server = createServer((request, response) => {
    let body = "";
    request.setEncoding("utf8").on("data", (part: string) => (body += part));
    request.on("end", () => {
      expect(request.headers.authorization).toBe(`Bearer ${KEY}`);
      const path = request.url?.replace("/api/v1/robots/r1", "") ?? "";
      requests.push(`${request.method} ${path} ${body.replaceAll(" ", "")}`.trim());
      const command = { seq: 7, action: "left 90", state: "accepted", reason: null };
      const answer = path === "/commands" ? command : { ...command, ...record };
      const problem = { type: "/problems/driving-paused", title: "Paused", status: 409, detail };
      response.writeHead(detail === undefined ? 200 : 409, { "content-type": "application/json" });
      response.end(JSON.stringify(detail === undefined ? answer : problem));
    });
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  onTestFinished(() => void server.close());
  const { port } = server.address() as AddressInfo;
  return { origin: `http://127.0.0.1:${port}`, requests };
}

/** Runs a script to its end. @returns its last printed line, and its exit code */
async function run(language: Language, origin: string) {
  const [program, ...args] = programs[language];
  const { file, text } = quickstarts[language];
  const folder = await mkdtemp(join(tmpdir(), "corridor-script-"));
  await writeFile(join(folder, file ?? ""), text({ origin, id: "r1", key: KEY, urlKey: "" }));
  const child = spawn(program, args, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  let output = "";
  let errors = "";
  child.stdout.on("data", (chunk: Buffer) => (output += chunk.toString()));
  child.stderr.on("data", (chunk: Buffer) => (errors += chunk.toString()));
  const [code] = (await once(child, "close")) as [number | null];
  await rm(folder, { recursive: true });
  // Python prints the reason of a failure to the error output, and then exits.
  return { last: `${output}${errors}`.trimEnd().split("\n").at(-1) ?? "", code };
}

describe.each(languages)("the script to copy in %s", (language) => {
  const missing = needs[language].find(([name, option]) => spawnSync(name, [option]).status !== 0);

  it.for(endings)("prints at its end that the command $name", async (ending, { skip }) => {
    if (missing !== undefined) return skip(`there is no ${missing[0]} here`);
    const { origin, requests } = await startRobot(ending);
    const { last, code } = await run(language, origin);
    expect(language === "curl" ? /"\w+":"(.*)"/.exec(last)?.[1] : last).toBe(ending.prints);
    // A shell or a build server sees that the robot did not drive.
    expect(code).toBe(ending.prints === "completed" ? 0 : 1);
    const follow = ending.detail === undefined ? ["GET /commands/7?wait=25"] : [];
    expect(requests).toEqual(['POST /commands {"action":"left90"}', ...follow]);
  });
});
