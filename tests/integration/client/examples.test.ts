/** Runs the single-file examples as users do, with a real relay. */
import { execFile, execFileSync } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import { scriptListSchema } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { beforeAll, describe, expect, it, onTestFinished } from "vitest";
import { startTruncatingProxy } from "../../support/client/truncating-proxy.ts";
import { startForwardProxy } from "../../support/client/forward-proxy.ts";
import { shortRunOptions } from "../../support/java.ts";
import { robotIn } from "../../support/client/robot-in.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

/** Prevents .NET from using the network and the home directory; ignored by other programs. */
const DOTNET = {
  DOTNET_CLI_TELEMETRY_OPTOUT: "1",
  DOTNET_NOLOGO: "1",
  DOTNET_SYSTEM_GLOBALIZATION_INVARIANT: "1",
  DOTNET_CLI_HOME: tmpdir(),
};
const env = { ...process.env, ...DOTNET };
const run = (program: string, args: readonly string[], more: NodeJS.ProcessEnv = {}) =>
  promisify(execFile)(program, args, { env: { ...env, ...more } });
const EXAMPLES = join(import.meta.dirname, "../../../examples");
const TREE = ["#######", "#.#...#", "#.#.#.#", "#...#.#", "#######"];

interface Example {
  language: string;
  /** the command without the address */
  command: readonly [program: string, ...args: string[]];
  /** arguments that check whether the program is installed */
  probe: readonly string[];
  /** compiles the example into a folder. @returns the command that runs it */
  build?: (folder: string) => Promise<Example["command"]>;
}

const examples: readonly Example[] = [
  {
    language: "Python",
    command: ["python3", join(EXAMPLES, "python/right_wall.py")],
    probe: ["--version"],
  },
  {
    language: "Java",
    command: ["java", ...shortRunOptions, join(EXAMPLES, "java/Robot.java")],
    probe: ["-version"],
  },
  {
    language: "Go",
    command: ["go", "run", join(EXAMPLES, "go/robot.go")],
    probe: ["version"],
    // Like "go run", but once for all tests.
    build: async (folder) => {
      const program = join(folder, "robot");
      await run("go", ["build", "-o", program, join(EXAMPLES, "go/robot.go")]);
      return [program];
    },
  },
  {
    language: "C#",
    command: ["dotnet", "run", join(EXAMPLES, "csharp/Robot.cs")],
    probe: ["--version"],
    // .NET versions before 10 require a project.
    build: async (folder) => {
      const { stdout: version } = await run("dotnet", ["--version"]);
      const [major = "", minor = ""] = version.split(".");
      const framework = `${Number(major) < 5 ? "netcoreapp" : "net"}${major}.${minor}`;
      const project = join(folder, "Robot.csproj");
      writeFileSync(project, csharpProject(framework, join(EXAMPLES, "csharp/Robot.cs")));
      await run("dotnet", ["build", project, "--output", join(folder, "out")]);
      return ["dotnet", join(folder, "out/Robot.dll")];
    },
  },
  {
    language: "curl",
    command: ["bash", join(EXAMPLES, "curl/right_wall.sh")],
    probe: ["-c", "curl --version && awk 1 /dev/null"],
  },
];

function csharpProject(framework: string, file: string): string {
  return `<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <OutputType>Exe</OutputType>
    <TargetFramework>${framework}</TargetFramework>
    <TreatWarningsAsErrors>true</TreatWarningsAsErrors>
  </PropertyGroup>
  <ItemGroup><Compile Include="${file}" /></ItemGroup>
</Project>`;
}

const sharedRelay = sharedRelayProcess();

/** A host whose commands all expire. @returns its origin */
async function startLateHost(): Promise<string> {
  const host = createServer((request, response) => {
    const isCommand = (request.url ?? "").endsWith("/commands");
    const answer = isCommand
      ? { seq: 1, action: "move", state: "expired", reason: "too late" }
      : snapshotOf({ seq: 1 });
    response.writeHead(isCommand ? 202 : 200, { "Content-Type": "application/json" });
    request.resume().on("end", () => response.end(JSON.stringify(answer)));
  });
  host.listen(0, "127.0.0.1");
  await once(host, "listening");
  onTestFinished(() => {
    host.close();
    host.closeAllConnections();
  });
  return `http://127.0.0.1:${(host.address() as AddressInfo).port}`;
}

/** Whether the program is installed; if not, its tests are skipped with a message. */
function isInstalled({ language, command: [program], probe }: Example): boolean {
  try {
    execFileSync(program, probe, { stdio: "ignore", env });
    return true;
  } catch {
    process.stderr.write(`examples.test.ts: skipped ${language}: ${program} is not installed\n`);
    return false;
  }
}

describe.each(examples)("the right-wall follower in $language", (example) => {
  const isMissing = !isInstalled(example);
  let [program, ...args] = example.command;
  const start = async (...more: string[]) => run(program, [...args, ...more]);

  beforeAll(async () => {
    if (isMissing || example.build === undefined) return;
    const folder = mkdtempSync(join(tmpdir(), "corridor-"));
    [program, ...args] = await example.build(folder);
    return () => rmSync(folder, { recursive: true, force: true });
  }, 120_000);

  it.skipIf(isMissing)(
    "visits every cell without a bump although the relay is killed meanwhile",
    async () => {
      const { relay, robot, registration } = await robotIn(TREE);
      const cells = String(robot.openCells);
      const program = start(registration.address, "--until-cells", cells);
      await expect.poll(() => robot.visited.size, { timeout: 40_000 }).toBeGreaterThan(3);
      await relay.killAndRestart();
      // After a slow start of the relay, the next attempt may come later than a command expires.
      robot.connection.open();
      const { stdout } = await program;
      expect(stdout).toMatch(new RegExp(`${cells} cells visited after \\d+ moves\\.\\n$`));
      expect(robot.visited.size).toBe(robot.openCells);
      expect(robot.snapshot().bumps).toBe(0);
    },
  );

  it.skipIf(isMissing)("continues despite truncated responses, and sends its name", async () => {
    const { relay, robot, registration } = await robotIn(TREE, await sharedRelay());
    const proxy = await startTruncatingProxy(relay.url, 7);
    const { hash, pathname } = new URL(registration.address);
    const cells = String(robot.openCells);
    await start(`${proxy.origin}${pathname}${hash}`, "--until-cells", cells);
    expect(proxy.truncated).toBeGreaterThan(2);
    expect(robot.visited.size).toBe(robot.openCells);
    expect(robot.snapshot().bumps).toBe(0);
    const listed = await fetch(`${relay.url}/api/v1/robots/${registration.id}/scripts`, {
      headers: { Authorization: `Bearer ${registration.ownerKey}` },
    });
    const { scripts } = scriptListSchema.parse(await listed.json());
    expect(scripts.map(({ name, client }) => ({ name, client }))).toEqual([
      { name: "Right wall", client: example.language },
    ]);
  });

  it.skipIf(isMissing)("uses the network's proxy", async () => {
    const { relay, robot, registration } = await robotIn(TREE, await sharedRelay());
    const proxy = await startForwardProxy(relay.url);
    const { hash, pathname } = new URL(registration.address);
    const cells = String(robot.openCells);
    const address = `${proxy.service}${pathname}${hash}`;
    await run(program, [...args, address, "--until-cells", cells], proxy.env);
    expect(robot.visited.size).toBe(robot.openCells);
    expect(robot.snapshot().bumps).toBe(0);
    expect(proxy.forwarded).toBeGreaterThan(0);
  });

  it.skipIf(isMissing)("reports an expired command as an error", async () => {
    const address = `${await startLateHost()}/r/AAAAAAAAAAAAAAAAAAAAAA#drv_AAAAAAAAAAAAAAAAAAAAAA`;
    await expect(start(address, "--moves", "3")).rejects.toMatchObject({
      code: 1,
      stderr: expect.stringMatching(/expired[^\n]*\n$/),
    });
  });

  it.skipIf(isMissing)("reports an invalid address or key in one sentence", async () => {
    const { registration } = await robotIn(TREE, await sharedRelay());
    const [withoutKey] = registration.address.split("#");
    const noKey = start(`${withoutKey}`);
    await expect(noKey).rejects.toMatchObject({
      stderr: expect.stringMatching(/^This is not a robot's address[^\n]*\n$/),
    });
    const key = "drv_AAAAAAAAAAAAAAAAAAAAAA";
    const wrongKey = start(`${withoutKey}#${key}`);
    await expect(wrongKey).rejects.toMatchObject({
      stderr: expect.stringMatching(/^[^\n]*key[^\n]*\n$/),
    });
    await expect(wrongKey).rejects.not.toMatchObject({ stderr: expect.stringContaining(key) });
  });
});
