/** The quickstarts for clients of other protocols, run as copied, with a robot at a real relay. */
import { execFile, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { scriptListSchema } from "@corridor/protocol";
import { quickstarts, type QuickstartId } from "@corridor/quickstarts";
import { Client, StreamableHTTPClientTransport } from "@modelcontextprotocol/client";
import { Ros, Topic } from "roslib";
import { describe, expect, it, onTestFinished } from "vitest";
import { NotInstallableError, requireEnvironment } from "../../../scripts/python.ts";
import { BridgeProcess, MAIN } from "../../support/bridges/bridge-process.ts";
import { skipWithoutMaven } from "../../support/maven.ts";
import { corridorHost } from "../../support/mcp/corridor-host.ts";
import { urlWithKey } from "../../support/ros/url-with-key.ts";
import { runWithCxf } from "../../support/soap/cxf-project.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";
import { VipleClient } from "../../support/viple/viple-client.ts";

const run = promisify(execFile);
const ROOT = fileURLToPath(new URL("../../../", import.meta.url));
const TIMEOUT_MS = 300_000;

const sharedRelay = sharedRelayProcess();

/** A robot, and a folder with the file of a quickstart. */
async function prepare(id: QuickstartId) {
  const { relay, page, registration } = await corridorHost(await sharedRelay());
  const urlKey = (await urlWithKey(relay.url, registration)).split("/").at(-1) ?? "";
  const { driverKey: key, ownerKey } = registration;
  const { file, text, client } = quickstarts[id];
  const written = text({ origin: relay.url, id: registration.id, key, urlKey });
  const folder = mkdtempSync(join(tmpdir(), "corridor-quickstart-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  if (file !== null && !file.includes("/")) writeFileSync(join(folder, file), written);
  /** Whether the owner reads a script of this kind, as the page's mark shows. */
  const expectListed = async (): Promise<void> => {
    const answer = await fetch(`${relay.url}/api/v1/robots/${registration.id}/scripts`, {
      headers: { Authorization: `Bearer ${ownerKey}` },
    });
    const { scripts } = scriptListSchema.parse(await answer.json());
    expect(scripts.map((each) => each.client)).toContain(client);
  };
  const actions = () => page.robot.done.map(({ action }) => action);
  return { relay, page, folder, text: written, actions, expectListed };
}

/** Python with packages, or why it cannot be installed here. */
function python(name: string, requirements: string, minMinor = 9) {
  try {
    return { program: requireEnvironment(name, join(ROOT, requirements), minMinor) };
  } catch (error) {
    if (error instanceof NotInstallableError) return { missing: error.message };
    throw error;
  }
}

function missingProgram(...programs: [program: string, option: string][]): string | null {
  const missing = programs.find(([program, option]) => spawnSync(program, [option]).status !== 0);
  return missing === undefined ? null : `there is no ${missing[0]} here`;
}

describe("the quickstart of", () => {
  it("roslibpy turns the robot by velocities", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = python("ros", "tests/support/ros/requirements.txt");
    if ("missing" in found) return skip(found.missing);
    const { folder, actions, expectListed } = await prepare("roslibpy");
    const { stdout } = await run(found.program, ["drive.py"], { cwd: folder });
    expect(stdout).toMatch(/^front [\d.]+\n/);
    expect(actions()).toContain("drive");
    await expectListed();
  });

  it("roslibpy says why the robot does not move", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = python("ros", "tests/support/ros/requirements.txt");
    if ("missing" in found) return skip(found.missing);
    const { page, folder } = await prepare("roslibpy");
    page.connection.close();
    const { stdout } = await run(found.program, ["drive.py"], { cwd: folder });
    expect(stdout).toContain("The robot's page is closed or offline: open it again");
  });

  it("roslib turns the robot by velocities", { timeout: TIMEOUT_MS }, async () => {
    const { folder, actions, expectListed } = await prepare("roslib");
    symlinkSync(join(ROOT, "node_modules"), join(folder, "node_modules"));
    const { stdout } = await run(process.execPath, ["drive.mjs"], { cwd: folder });
    expect(stdout).toMatch(/^front [\d.]+\n/);
    expect(actions()).toContain("drive");
    await expectListed();
  });

  it("roslib says why the robot does not move", { timeout: TIMEOUT_MS }, async () => {
    const { page, folder } = await prepare("roslib");
    symlinkSync(join(ROOT, "node_modules"), join(folder, "node_modules"));
    page.connection.close();
    const { stdout } = await run(process.execPath, ["drive.mjs"], { cwd: folder });
    expect(stdout).toContain("The robot's page is closed or offline: open it again");
  });

  it("roslib says that its key is wrong", { timeout: TIMEOUT_MS }, async () => {
    const { folder, text } = await prepare("roslib");
    symlinkSync(join(ROOT, "node_modules"), join(folder, "node_modules"));
    writeFileSync(join(folder, "drive.mjs"), text.replace(/drv_[\w-]+/, "drv_wrong"));
    const { stdout } = await run(process.execPath, ["drive.mjs"], { cwd: folder });
    expect(stdout).toMatch(/^The key is invalid or was revoked\./);
  });

  it("any rosbridge tool connects by the URL alone", async () => {
    const { text, expectListed } = await prepare("rosbridge");
    const ros = new Ros({ url: text });
    onTestFinished(() => ros.close());
    const topic = new Topic<{ ranges: number[] }>({
      ros,
      name: "/scan",
      messageType: "sensor_msgs/LaserScan",
    });
    const scan = await new Promise<{ ranges: number[] }>((resolve) => topic.subscribe(resolve));
    expect(scan.ranges).toHaveLength(4);
    await expectListed();
  });

  it.each(["claudeCode", "vsCode", "cursor"] as const)(
    "%s has the URL and the header of an agent that drives",
    async (id) => {
      const { text, actions, expectListed } = await prepare(id);
      const [, url = ""] = /(http\S+\/mcp)\b/.exec(text) ?? [];
      const [, authorization = ""] =
        /"(?:Authorization: |Authorization": ")(.*?)"/.exec(text) ?? [];
      const agent = new Client({ name: "agent", version: "1.0.0" });
      onTestFinished(() => agent.close());
      const headers = { Authorization: authorization };
      await agent.connect(
        new StreamableHTTPClientTransport(new URL(url), { requestInit: { headers } }),
      );
      const done = await agent.callTool({ name: "act", arguments: { action: "left 90" } });
      expect(done.isError ?? false).toBe(false);
      expect(actions()).toEqual(["left 90"]);
      await expectListed();
    },
  );

  it("zeep drives the robot", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = python("soap", "tests/support/soap/requirements.txt");
    if ("missing" in found) return skip(found.missing);
    const { folder, actions, expectListed } = await prepare("soapPython");
    const { stdout } = await run(found.program, ["drive.py"], { cwd: folder });
    expect(stdout).toBe("front 450.0\ncompleted\n");
    expect(actions()).toEqual(["left 90"]);
    await expectListed();
  });

  it("SOAP in C# drives the robot", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const missing = missingProgram(["mcs", "--version"], ["mono", "--version"]);
    if (missing !== null) return skip(missing);
    const { folder, actions, expectListed } = await prepare("soapCsharp");
    await run("mcs", ["-r:System.Net.Http", "Drive.cs"], { cwd: folder });
    const { stdout } = await run("mono", ["Drive.exe"], { cwd: folder });
    expect(stdout).toBe("front 450\ncompleted\n");
    expect(actions()).toEqual(["left 90"]);
    await expectListed();
  });

  it("SOAP in Java drives the robot", { timeout: 2 * TIMEOUT_MS }, ({ skip }) =>
    skipWithoutMaven(skip, async () => {
      const { text, actions, expectListed } = await prepare("soapJava");
      const [, wsdl = ""] = /^\/\/ mvn -q compile exec:java -D wsdl="(.*)"$/m.exec(text) ?? [];
      const output = await runWithCxf("Drive", text, { wsdl });
      expect(output.slice(output.indexOf("front"))).toBe("front 450.0\nCOMPLETED\n");
      expect(actions()).toEqual(["left 90"]);
      await expectListed();
    }),
  );

  it("a generated client drives the robot", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = python("openapi-python-client", "tests/support/openapi/requirements.txt", 11);
    if ("missing" in found) return skip(found.missing);
    const { folder, text, actions, expectListed } = await prepare("generated");
    const [, command = ""] = /^# Then: openapi-python-client (.*)$/m.exec(text) ?? [];
    const env = { ...process.env, PATH: `${dirname(found.program)}:${process.env["PATH"]}` };
    const generator = ["-m", "openapi_python_client", ...command.split(" ")];
    await run(found.program, generator, { cwd: folder, env });
    const { stdout } = await run(found.program, ["drive.py"], { cwd: folder });
    expect(stdout).toBe("completed\n");
    expect(actions()).toEqual(["left 90"]);
    await expectListed();
  });

  it("a micromouse program starts it in a bridge", { timeout: TIMEOUT_MS }, async () => {
    const { relay, folder, text, actions, expectListed } = await prepare("micromouse");
    const [download, start = ""] = text.split("\n");
    expect(download).toBe(`curl -O ${relay.url}/corridor-cli.mjs`);
    const program = `print("turnLeft", flush=True)\ninput()\n`;
    writeFileSync(join(folder, "Main.py"), program);
    // The relay serves the command only after a build.
    const command = start.replace("node corridor-cli.mjs", `"${process.execPath}" "${MAIN}"`);
    await run("sh", ["-c", command], { cwd: folder });
    expect(actions()).toEqual(["reset", "left 90"]);
    await expectListed();
  });

  it("ASU VIPLE starts a bridge that its diagrams drive", { timeout: TIMEOUT_MS }, async () => {
    const { text, actions, expectListed } = await prepare("viple");
    const [, address = ""] = /^node corridor-cli\.mjs viple "(.*)"$/m.exec(text) ?? [];
    const { simulatorPort } = await BridgeProcess.startViple(address);
    const diagram = await VipleClient.open(simulatorPort);
    diagram.send({ servos: [{ servoSpeed: -90, isTurn: true }] });
    await expect.poll(actions, { timeout: 10_000 }).toEqual(["turn"]);
    await expectListed();
  });
});
