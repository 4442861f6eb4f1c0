/** Host and script with a real relay, and the examples as users run them. */
import { execFile } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it, onTestFinished } from "vitest";
import { HostConnection } from "../../../packages/client/src/host-connection.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { robotIn } from "../../support/client/robot-in.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

const run = promisify(execFile);
const EXAMPLES = join(import.meta.dirname, "../../../examples");

const TREE = [
  "#########",
  "#.#.....#",
  "#.#.###.#",
  "#...#...#",
  "#.#######",
  "#.#.#...#",
  "#.#.#.###",
  "#.....###",
  "#########",
];

const CORRIDOR = ["#".repeat(42), `#${".".repeat(40)}#`, "#".repeat(42)];

const sharedRelay = sharedRelayProcess();

/** @param options default: those of the library */
async function scriptFor(address: string, options: { ttl?: number } = {}): Promise<RobotClient> {
  const script = await RobotClient.connect(address, options);
  onTestFinished(() => script.close());
  return script;
}

describe("a script and a robot at a real relay", () => {
  it("drives, reads and stops", async () => {
    const { robot, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const script = await scriptFor(registration.address);
    expect(await script.right90()).toMatchObject({ state: "completed", duplicate: false });
    expect((await script.sensors()).front).toBe(3_950);
    expect(await script.move(100)).toMatchObject({ distance: 100, pose: { x: 250, heading: 90 } });
    expect((await script.sensors()).front).toBe(3_850);
    expect(await script.stop()).toMatchObject({ action: "stop", state: "completed" });
    expect(robot.done.map(({ action }) => action)).toEqual(["right 90", "move"]);
  });

  it("neither loses, duplicates nor reorders commands when the relay is killed", async () => {
    const { relay, robot, registration } = await robotIn(CORRIDOR);
    // A busy machine needs more than the default of 10 s for two restarts.
    const script = await scriptFor(registration.address, { ttl: 60_000 });
    await script.right90();
    const records: Promise<{ seq: number; state: string }>[] = [];
    for (let n = 0; n < 30; n++) records.push(script.move(100));
    await records[4];
    await relay.killAndRestart();
    await records[17];
    await relay.killAndRestart();
    const all = await Promise.all(records);
    expect(all.map(({ state }) => state)).toEqual(Array.from({ length: 30 }, () => "completed"));
    expect(all.map(({ seq }) => seq)).toEqual(all.map((_record, index) => index + 2));
    expect(robot.done).toHaveLength(31);
    expect(robot.snapshot().pose.x).toBe(3_150);
    expect(robot.statuses.filter((kind) => kind === "lost").length).toBeGreaterThanOrEqual(2);
  });

  it("reads the maze of its robot", async () => {
    const { relay, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const script = await scriptFor(registration.address);
    await expect(script.maze()).rejects.toMatchObject({ code: "no-maze" });
    const maze = {
      name: "Two cells",
      blocks: ["####", "#..#", "####"],
      start: { column: 1, row: 1, heading: "east" },
      goals: [{ column: 2, row: 1 }],
    };
    const given = await fetch(`${relay.url}/api/v1/robots/${registration.id}/maze`, {
      method: "PUT",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({ format: "corridor/maze", version: 1, ...maze }),
    });
    expect(given.status).toBe(204);
    expect(await script.maze()).toEqual(maze);
    const wrongKey = registration.address.replace(/#.*/, "#wch_AAAAAAAAAAAAAAAAAAAAAA");
    await expect(scriptFor(wrongKey)).rejects.toMatchObject({ code: "not-authorised" });
  });

  it("follows the commands of another script and the robot, also over a restart", async () => {
    const { relay, registration } = await robotIn(CORRIDOR);
    const watcher = await scriptFor(registration.address);
    const driver = await scriptFor(registration.address);
    const events = watcher.events();
    let x = 0;
    /** Reads until a command is completed, or until a gap. */
    const follow = async (seq: number | "gap"): Promise<void> => {
      for (;;) {
        const { value: event } = await events.next();
        if (event === undefined) throw new Error("The events have ended.");
        if (event.kind === "snapshot") ({ x } = event.snapshot.pose);
        if (event.kind === "gap" && seq === "gap") return;
        const isDone = event.kind === "command" && event.command.state === "completed";
        if (isDone && event.command.seq === seq) return;
      }
    };
    await Promise.all([driver.right90(), follow(1)]);
    // If the watcher reconnected after the next command, the gap would replace its states.
    await Promise.all([relay.killAndRestart(), follow("gap")]);
    await Promise.all([driver.move(100), follow(2)]);
    expect(x).toBe(250);
  });

  it("retains commands while the page is disconnected, and cancels those that a reload has lost", async () => {
    const { relay, robot, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const script = await scriptFor(registration.address);
    await script.right90();
    robot.connection.close();
    const waiting = script.move(100);
    const host = (
      fresh: boolean,
      onCommand: (seq: number, connection: HostConnection) => void,
    ): HostConnection => {
      const connection = new HostConnection({
        origin: relay.url,
        credentials: registration,
        lastApplied: 1,
        fresh,
        snapshot: () => robot.snapshot(),
        onCommand: ({ seq }) => onCommand(seq, connection),
        onStop: () => undefined,
        onCancel: () => undefined,
        onGiveBack: () => undefined,
        onYield: () => undefined,
        onState: () => undefined,
        onRefused: () => undefined,
        onStatus: () => undefined,
        onDrivers: () => undefined,
      });
      onTestFinished(() => connection.close());
      return connection;
    };
    const started = Promise.withResolvers<void>();
    const first = host(false, (seq, connection) => {
      connection.started(seq);
      started.resolve();
    });
    await started.promise;
    // The relay must have received `started` before the page disconnects.
    for await (const { command } of log(relay.url, registration)) if (command === "started") break;
    first.close();
    host(true, () => undefined);
    await expect(waiting).rejects.toMatchObject({
      code: "cancelled",
      hint: "The robot's page was reloaded and ended this command. Send a new command.",
    });
  });

  it("explains to a script whose command a pause ended how to continue", async () => {
    const { relay, robot, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const script = await scriptFor(registration.address);
    await script.right90();
    robot.connection.close();
    for await (const event of script.events()) {
      if (event.kind === "snapshot" && event.snapshot.state === "gone") break;
    }
    const hint = expect.stringContaining("Press 'Let scripts drive'") as string;
    const error = script.move(100).catch((thrown: unknown) => thrown);
    for await (const { command } of log(relay.url, registration)) {
      if (command === "accepted") break;
    }
    const paused = await fetch(`${relay.url}/api/v1/robots/${registration.id}/pause`, {
      method: "PUT",
      headers: { Authorization: `Bearer ${registration.ownerKey}` },
    });
    expect(paused.status).toBe(204);
    expect(await error).toMatchObject({ code: "cancelled", hint });
    await expect(script.move(100)).rejects.toMatchObject({ code: "refused", hint });
  });

  it("ends a script at once when its key is revoked", async () => {
    const { relay, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const robot = await RobotClient.connect(registration.address);
    const made = await fetch(`${relay.url}/api/v1/robots/${registration.id}/keys`, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({ kind: "drive", replace: true }),
    });
    expect(made.status).toBe(201);
    await expect(robot.move(10)).rejects.toMatchObject({
      code: "not-authorised",
      message: expect.stringContaining("revoked") as string,
    });
    const { address } = (await made.json()) as { address: string };
    const next = await RobotClient.connect(address);
    await next.move(10);
    next.close();
  });

  it("distinguishes a wrong key from a missing robot", async () => {
    const { relay, registration } = await robotIn(CORRIDOR, await sharedRelay());
    const wrongKey = `${relay.url}/r/${registration.id}#drv_AAAAAAAAAAAAAAAAAAAAAA`;
    await expect(RobotClient.connect(wrongKey)).rejects.toMatchObject({ code: "not-authorised" });
    const noRobot = `${relay.url}/r/AAAAAAAAAAAAAAAAAAAAAA#${registration.driverKey}`;
    await expect(RobotClient.connect(noRobot)).rejects.toMatchObject({ code: "no-robot" });
  });
});

/** Polls the state of the newest command. */
async function* log(origin: string, robot: { id: string; driverKey: string }) {
  for (;;) {
    const answer = await fetch(`${origin}/api/v1/robots/${robot.id}/commands`, {
      headers: { Authorization: `Bearer ${robot.driverKey}` },
    });
    const { commands } = (await answer.json()) as { commands: { state: string }[] };
    yield { command: commands.at(-1)?.state };
  }
}

describe("the examples", () => {
  it.each([
    { name: "Python", program: "python3", file: "python/right_wall.py" },
    { name: "JavaScript", program: process.execPath, file: "javascript/right-wall.ts" },
  ])("the right-wall follower in $name visits every cell, without a bump", async (example) => {
    const { robot, registration } = await robotIn(TREE, await sharedRelay());
    const cells = String(robot.openCells);
    const { stdout } = await run(example.program, [
      join(EXAMPLES, example.file),
      registration.address,
      "--until-cells",
      cells,
    ]);
    expect(robot.visited.size).toBe(robot.openCells);
    expect(robot.snapshot().bumps).toBe(0);
    expect(stdout).toMatch(new RegExp(`${cells} cells visited after \\d+ moves\\.\\n$`));
  });

  it.each([
    { name: "Python", program: "python3", file: "python/right_wall.py" },
    { name: "JavaScript", program: process.execPath, file: "javascript/right-wall.ts" },
  ])("the $name program reports an invalid address in one sentence", async (example) => {
    const failed = run(example.program, [join(EXAMPLES, example.file), "http://localhost/r/abc"]);
    await expect(failed).rejects.toMatchObject({
      code: 1,
      stderr: expect.stringMatching(/^[^\n]*not a robot's address[^\n]*\n$/),
    });
  });

  it("the Python program continues after the relay was killed", async () => {
    const { relay, robot, registration } = await robotIn(TREE);
    const cells = String(robot.openCells);
    const file = join(EXAMPLES, "python/right_wall.py");
    const program = run("python3", [file, registration.address, "--until-cells", cells]);
    await expect.poll(() => robot.visited.size, { timeout: 20_000 }).toBeGreaterThan(4);
    await relay.killAndRestart();
    const { stdout } = await program;
    expect(stdout).toContain(`${cells} cells visited`);
    expect(robot.snapshot().bumps).toBe(0);
  });
});
