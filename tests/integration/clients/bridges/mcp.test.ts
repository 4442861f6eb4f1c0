/** `corridor mcp` as hosts of AI agents start it: a process that speaks on its standard streams. */
import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { Client } from "@modelcontextprotocol/client";
import { StdioClientTransport } from "@modelcontextprotocol/client/stdio";
import { scriptListSchema } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import {
  callMessage,
  callTool,
  eras,
  type Era,
} from "../../../../apps/relay/src/testing/mcp-client.ts";
import { BridgeProcess, MAIN } from "../../../support/bridges/bridge-process.ts";
import { PEN, startPhysicalRobot } from "../../../support/conformance/physical-robot.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { mcpEnvironment } from "../../../support/mcp/python-mcp.ts";
import { solve } from "../../../support/mcp/solve.ts";
import type { RelayProcess } from "../../../support/relay-process.ts";
import { sharedRelayProcess, startRelayProcess } from "../../../support/test-relay-process.ts";

const run = promisify(execFile);
const AGENT = fileURLToPath(new URL("../../../support/mcp/agent.py", import.meta.url));

const sharedRelay = sharedRelayProcess();

async function robotAtRelay(own?: RelayProcess) {
  const host = await corridorHost(own ?? (await sharedRelay()));
  const { id, driverKey } = host.registration;
  return { ...host, address: `${host.relay.url}/r/${id}#${driverKey}` };
}

/** Starts the bridge as a host does, and connects. */
async function connectAgent(address: string, era: Era): Promise<Client> {
  const transport = new StdioClientTransport({
    command: process.execPath,
    args: [MAIN, "mcp"],
    env: { CORRIDOR_ROBOT: address },
  });
  const mode = era === "2025" ? "legacy" : { pin: era };
  const client = new Client({ name: "test", version: "1.0.0" }, { versionNegotiation: { mode } });
  onTestFinished(() => client.close());
  await client.connect(transport);
  return client;
}

/** Starts the bridge without a library. */
function startRaw(address: string) {
  const child = spawn(process.execPath, [MAIN, "mcp", address], {
    stdio: ["pipe", "pipe", "pipe"],
  });
  onTestFinished(() => void child.kill("SIGKILL"));
  const output = { stdout: "", stderr: "" };
  for (const name of ["stdout", "stderr"] as const) {
    child[name].on("data", (data: Buffer) => (output[name] += data.toString()));
  }
  const exited = once(child, "close").then(([code]) => code as number | null);
  const send = (text: string): void => void child.stdin.write(`${text}\n`);
  return { child, output, exited, send };
}

const initialize = JSON.stringify({
  jsonrpc: "2.0",
  id: 1,
  method: "initialize",
  params: {
    protocolVersion: "2025-06-18",
    capabilities: {},
    clientInfo: { name: "raw", version: "1" },
  },
});

describe.each(eras)("an agent of the era %s by corridor mcp", (era) => {
  it("solves a corridor with sense and act alone, and is in the list of scripts", async () => {
    const { relay, registration, address } = await robotAtRelay();
    const agent = await connectAgent(address, era);
    const seen = await solve((name, args) => callTool(agent, name, args));
    expect(seen).toMatchObject({ goalReached: true, bumps: 0 });
    const answer = await fetch(`${relay.url}/api/v1/robots/${registration.id}/scripts`, {
      headers: { Authorization: `Bearer ${registration.ownerKey}` },
    });
    const { scripts } = scriptListSchema.parse(await answer.json());
    expect(scripts).toMatchObject([{ client: "MCP", connections: 1 }]);
  });
});

describe("corridor mcp", () => {
  it("drives on after the relay was killed", { timeout: 120_000 }, async () => {
    const { relay, page, address } = await robotAtRelay(await startRelayProcess());
    const agent = await connectAgent(address, "2025");
    const act = { action: "move", distance: 100 };
    expect(await callTool(agent, "act", act)).toMatchObject({ isError: false });
    await relay.killAndRestart();
    expect(await callTool(agent, "act", act)).toMatchObject({ isError: false });
    expect(page.robot.done).toHaveLength(2);
  });

  it("drives a physical robot", { timeout: 60_000 }, async () => {
    const { address, stop } = await startPhysicalRobot({ room: PEN });
    onTestFinished(() => stop());
    const agent = await connectAgent(address, "2026-07-28");
    const moved = await callTool(agent, "act", { action: "move", distance: 100 });
    expect(moved).toMatchObject({ structured: { record: { state: "completed" } } });
    expect(await callTool(agent, "reset")).toMatchObject({ isError: true });
  });

  it("explains to the agent that its key was revoked", async () => {
    const { relay, registration, address } = await robotAtRelay();
    const agent = await connectAgent(address, "2025");
    await callTool(agent, "sense");
    await fetch(`${relay.url}/api/v1/robots/${registration.id}/keys`, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({ kind: "drive", replace: true }),
    });
    await expect
      .poll(async () => callTool(agent, "sense"))
      .toMatchObject({ isError: true, text: expect.stringContaining("was revoked") });
  });

  it("prints nothing but the protocol to standard output, whatever it receives", async () => {
    const { registration, address } = await robotAtRelay();
    const { output, exited, send, child } = startRaw(address);
    send(initialize);
    await expect.poll(() => output.stdout, { timeout: 10_000 }).toContain("\n");
    for (const wrong of ["{", "[]", "7", "x".repeat(20_000)]) send(wrong);
    send(JSON.stringify(callMessage("act", { action: "fly" }, 2)));
    await expect.poll(() => output.stdout, { timeout: 10_000 }).toContain('"id":2');
    child.stdin.end();
    expect(await exited).toBe(0);
    for (const line of output.stdout.trim().split("\n")) {
      expect(JSON.parse(line)).toMatchObject({ jsonrpc: "2.0" });
    }
    expect(JSON.stringify(output)).not.toContain(registration.driverKey.slice(4));
  });

  it("ends its motions and exits with 0 when the host closes standard input", async () => {
    const { page, address } = await robotAtRelay();
    page.endsCommands = false;
    const { output, exited, send, child } = startRaw(address);
    send(initialize);
    send(JSON.stringify(callMessage("act", { action: "move", distance: 300 }, 2)));
    await expect.poll(() => page.running, { timeout: 10_000 }).toBe(1);
    child.stdin.end();
    expect(await exited).toBe(0);
    await expect.poll(() => page.running).toBe(0);
    expect(output.stderr).toBe("");
  });

  it("exits with 1 and a sentence if the robot rejects the key", async () => {
    const { address } = await robotAtRelay();
    const bridge = BridgeProcess.launch(["mcp"], {
      CORRIDOR_ROBOT: address.replace("drv_", "drv_x"),
    });
    expect(await bridge.exited).toBe(1);
    expect(bridge.output).toEqual({
      stdout: "",
      stderr: expect.stringMatching(/^The robot rejects this key \(not-authorised\)\. .*\n$/),
    });
  });
});

describe("an agent in Python", () => {
  it.for(["auto", "legacy"])(
    "starts corridor mcp and solves a corridor (%s)",
    { timeout: 300_000 },
    async (mode, { skip }) => {
      const found = mcpEnvironment();
      if ("missing" in found) return skip(found.missing);
      const { address } = await robotAtRelay();
      const { stdout } = await run(found.python, [AGENT, mode, process.execPath, MAIN, "mcp"], {
        env: { ...process.env, CORRIDOR_ROBOT: address },
      });
      expect(JSON.parse(stdout)).toMatchObject({
        tools: ["sense", "look", "wait", "act", "stop", "reset"],
        snapshot: { goalReached: true, bumps: 0 },
        refused: true,
      });
    },
  );
});
