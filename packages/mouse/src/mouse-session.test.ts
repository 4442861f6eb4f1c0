import type { MazeDocument } from "@corridor/maze";
import { READ_ONLY } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { MouseSession } from "./mouse-session.ts";
import { GridWorld } from "./testing/grid-world.ts";
import { ManualTimers, settled } from "@corridor/protocol/testing";
import { documentOf, gridOfDrawing } from "./testing/mouse-mazes.ts";
import { startMouse, type MouseWorld } from "./testing/mouse-world.ts";
import { refusal, SimulatedPort } from "./testing/simulated-port.ts";

const small = {
  name: "3 x 3",
  drawing: `
o---o---o---o
|       |   |
o   o   o   o
|   |       |
o   o---o   o
|   |       |
o---o---o---o
`,
};

/** Blocks without posts, inside a border. */
const rooms: MazeDocument = {
  ...documentOf(small),
  blocks: ["#######", "#.....#", "#..#..#", "#.....#", "#.##..#", "#######"],
  start: { column: 1, row: 4, heading: "north" },
};

function gridOfBlocks({ blocks }: MazeDocument): GridWorld {
  const [columns, rows] = [(blocks[0]?.length ?? 0) - 2, blocks.length - 2];
  const isBlock = (x: number, y: number): boolean => (blocks[rows - y]?.[x + 1] ?? "#") === "#";
  return new GridWorld(columns, rows, (x, y, side) => {
    const [dx = 0, dy = 0] =
      [
        [0, 1],
        [1, 0],
        [0, -1],
        [-1, 0],
      ][side] ?? [];
    return isBlock(x + dx, y + dy);
  });
}

async function responsesTo(world: MouseWorld, commands: string[]): Promise<string[]> {
  const responses: string[] = [];
  for (const command of commands) responses.push(await world.lines.ask(command));
  return responses;
}

describe("a program", () => {
  it.each([
    ["mazeWidth", "3"],
    ["mazeHeight", "3"],
    ["wallFront", "false"],
    ["wallFront 4", "false"],
    ["wallFront 5", "true"],
    ["wallLeft", "true"],
    ["wallRight", "true"],
    ["wallBack", "true"],
    ["wallFrontRight", "true"],
    ["wallFrontLeft", "true"],
    ["wallBackRight", "true"],
    ["wallBackLeft", "true"],
    ["moveForward", "ack"],
    ["moveForward 2", "ack"],
    ["moveForward 3", "crash"],
    ["moveForward 0", "crash"],
    ["moveForward -1", "crash"],
    ["moveForward x", "crash"],
    ["moveForwardHalf", "ack"],
    ["moveForwardHalf 4", "ack"],
    ["moveForwardHalf 5", "crash"],
    ["turnRight", "ack"],
    ["turnLeft90", "ack"],
    ["turnRight45", "ack"],
    ["wasReset", "false"],
    ["ackReset", "ack"],
    ["getStat total-distance", "0"],
    ["getStat score", "2000"],
    ["getStat best-run-turns", "-1"],
  ])("asks %j at the start, and reads %j", async (command, expected) => {
    const world = await startMouse(documentOf(small));
    expect(await world.lines.ask(command)).toBe(expected);
  });

  it("drives in the middle of cells: up to the wall, and not at all if it is next to one", async () => {
    const world = await startMouse(documentOf(small));
    expect(await responsesTo(world, ["moveForward 9", "moveForward"])).toEqual(["crash", "crash"]);
    expect(world.port.simulation.pose.y).toBeCloseTo(150, 9);
    expect(world.port.simulation.bumps).toBe(0);
    expect(await world.lines.ask("getStat total-distance")).toBe("2");
  });

  it("turns by 45 degrees, and does not drive diagonally", async () => {
    const world = await startMouse(documentOf(small));
    const commands = ["turnRight45", "wallFront", "moveForward", "wallFrontLeft", "wallFrontRight"];
    expect(await responsesTo(world, commands)).toEqual(["ack", "true", "crash", "false", "true"]);
    expect(world.port.simulation.pose).toEqual({ x: 150, y: 550, heading: 45 });
    expect(await responsesTo(world, ["turnLeft45", "moveForward"])).toEqual(["ack", "ack"]);
  });

  it("stands between two posts after half a step", async () => {
    const world = await startMouse(documentOf(small));
    const commands = ["moveForwardHalf", "wallLeft", "wallRight", "wallFront 2", "wallFront 4"];
    expect(await responsesTo(world, commands)).toEqual(["ack", "true", "true", "false", "true"]);
    expect(world.port.simulation.pose.y).toBeCloseTo(450, 9);
  });

  it("reads nothing after a command that does not exist, and the reader sees one line", async () => {
    const world = await startMouse(documentOf(small));
    await world.session.receive(`fly\r\nmazeWidth 3\n${"x".repeat(1000)}\nmaze`);
    await world.session.receive("Width\n");
    await settled();
    expect(world.transcript).toEqual(["< 3"]);
    const long = `Invalid command: ${"x".repeat(60)}`;
    expect(world.reports).toEqual(["Invalid command: fly", "Invalid command: mazeWidth 3", long]);
  });

  it("receives responses in order, and display commands take effect while it drives", async () => {
    const world = await startMouse(documentOf(small));
    await world.session.receive("moveForward\nsetText 0 0 hi\nwallFront\nturnLeft\nmazeWidth\n");
    await world.timers.pass(0);
    expect(world.marks).toHaveLength(1);
    await settled();
    expect(world.transcript).toEqual(["< ack", "< false", "< ack", "< 3"]);
  });

  it("is not read on while 64 commands wait", async () => {
    const port = new SimulatedPort(documentOf(small));
    const read: string[] = [];
    let accept = (): void => undefined;
    const session = await MouseSession.start({
      port,
      timers: new ManualTimers(),
      // A program that does not read its input.
      respond: (line) => {
        read.push(line);
        return new Promise((resolve) => {
          accept = resolve;
        });
      },
      report: () => undefined,
      mark: () => undefined,
      onEnd: () => undefined,
    });
    let isRead = false;
    const reading = session.receive("mazeWidth\n".repeat(70)).then(() => (isRead = true));
    for (let turn = 0; turn < 10; turn += 1) await settled();
    expect([read.length, isRead]).toEqual([1, false]);
    for (let turn = 0; turn < 8; turn += 1) {
      accept();
      await settled();
    }
    await reading;
    expect(read).toHaveLength(9);
    session.close();
  });

  it("that is closed receives nothing any more", async () => {
    const world = await startMouse(documentOf(small));
    const reading = world.session.receive("mazeWidth\n".repeat(200));
    world.session.close();
    await reading;
    await settled();
    expect(world.transcript.length).toBeLessThan(64);
    expect(world.port.isClosed).toBe(true);
    expect(world.ends).toEqual([]);
  });
});

describe("the robot", () => {
  it("is reset, and turned to the north of the program, before the first command", async () => {
    const maze = documentOf(small);
    const world = await startMouse({ ...maze, start: { ...maze.start, heading: "south" } });
    expect(world.port.orders).toEqual([{ action: "reset" }, { action: "turn 180" }]);
    expect(world.port.simulation.pose.heading).toBe(0);
    expect(await world.lines.ask("ackReset")).toBe("ack");
    expect(world.port.orders).toHaveLength(4);
  });

  it.each(["east", "west"] as const)(
    "that starts facing %s is turned by 90 degrees",
    async (heading) => {
      const maze = documentOf(small);
      const world = await startMouse({ ...maze, start: { ...maze.start, heading } });
      expect(world.port.simulation.pose.heading).toBe(0);
    },
  );

  it("that starts elsewhere is reported", async () => {
    const world = await startMouse({
      ...documentOf(small),
      start: { column: 3, row: 3, heading: "north" },
    });
    expect(world.reports).toEqual([expect.stringContaining("does not start in a corner")]);
  });

  it.each(["reset-disabled", "not-supported"])(
    "that refuses a reset (%s) is used as it is",
    async (kind) => {
      const world = await startMouse(documentOf(small), (port) => {
        port.refusals.push(refusal(kind, "No reset."));
      });
      expect(world.reports).toEqual(["No reset."]);
      expect(await world.lines.ask("moveForward")).toBe("ack");
    },
  );

  it("that may only be watched is refused", async () => {
    const maze = documentOf(small);
    const started = startMouse(maze, (port) => port.refusals.push(refusal("forbidden", READ_ONLY)));
    await expect(started).rejects.toThrow(READ_ONLY);
  });

  it("that was reset by its page says so until the program acknowledges it", async () => {
    const world = await startMouse(documentOf(small));
    await world.lines.ask("moveForward");
    world.port.reset();
    expect(await responsesTo(world, ["wasReset", "wasReset", "ackReset", "wasReset"])).toEqual([
      "true",
      "true",
      "ack",
      "false",
    ]);
    const stats = ["moveForward", "getStat current-run-effective-distance"];
    expect(await responsesTo(world, stats)).toEqual(["ack", "16"]);
  });

  it("that is reset while it drives has crashed", async () => {
    const world = await startMouse(documentOf(small));
    await world.lines.ask("moveForward");
    world.port.endings.push({ state: "cancelled", reason: "The robot was put back to its start." });
    const answer = world.lines.ask("moveForward");
    await settled();
    world.port.reset();
    expect(await answer).toBe("crash");
    expect(await world.lines.ask("wasReset")).toBe("true");
    expect(world.timers.waiting).toBe(0);
  });

  it("that another driver takes over ends the program, with the reason", async () => {
    const world = await startMouse(documentOf(small));
    world.port.endings.push({ state: "cancelled", reason: "The robot's page took over." });
    world.lines.say("moveForward");
    await world.timers.pass(1000);
    expect(world.ends).toEqual(["The robot's page took over."]);
    expect(world.port.isClosed).toBe(true);
    expect(world.transcript).toEqual(["> moveForward"]);
  });

  it("that bumps has crashed", async () => {
    const world = await startMouse(documentOf(small));
    world.port.endings.push({ state: "collided", reason: "" });
    expect(await world.lines.ask("moveForward")).toBe("crash");
  });

  it("that starts nothing in time is asked again, and the reason is shown once", async () => {
    const world = await startMouse(documentOf(small));
    const paused = { state: "expired", reason: "The run is paused." } as const;
    world.port.endings.push(paused, paused);
    expect(await world.lines.ask("moveForward")).toBe("ack");
    expect(world.reports).toEqual(["The run is paused."]);
    expect(world.port.orders.filter(({ action }) => action === "move")).toHaveLength(3);
  });

  it("that accepts a command only later receives it then", async () => {
    const world = await startMouse(documentOf(small));
    world.port.refusals.push(refusal("too-many-requests", "Too many.", 1));
    const answer = world.lines.ask("ackReset");
    await world.timers.pass(999);
    expect(world.transcript).toEqual(["> ackReset"]);
    await world.timers.pass(1);
    expect(await answer).toBe("ack");
  });

  it("that refuses a command ends the program", async () => {
    const world = await startMouse(documentOf(small));
    world.port.refusals.push(refusal("driving-paused", "The owner paused remote driving."));
    world.lines.say("turnLeft");
    await settled();
    expect(world.ends).toEqual(["The owner paused remote driving."]);
  });

  it("that is deleted ends the program", async () => {
    const world = await startMouse(documentOf(small));
    world.port.end(refusal("no-robot", "Robot not found."));
    expect(world.ends).toEqual(["Robot not found."]);
  });

  it("that is noisy is read to the nearest half step", async () => {
    const world = await startMouse(documentOf(small));
    const { newest } = world.port;
    if (newest === null) throw new Error("no snapshot");
    world.port.newest = { ...newest, sensors: { ...newest.sensors, front: 433, left: 62 } };
    const commands = ["wallFront 4", "wallFront 5", "wallLeft", "moveForward 2"];
    expect(await responsesTo(world, commands)).toEqual(["false", "true", "true", "ack"]);
  });
});

describe("any commands", () => {
  const steps = fc.oneof(
    { weight: 3, arbitrary: fc.constant("") },
    { weight: 3, arbitrary: fc.integer({ min: -1, max: 8 }).map(String) },
    { weight: 1, arbitrary: fc.constantFrom("x", "1.5", "+2", "0x1") },
  );
  const withSteps = fc.tuple(
    fc.constantFrom(
      ...["Front", "Right", "Back", "Left", "FrontRight", "BackRight", "BackLeft", "FrontLeft"].map(
        (each) => `wall${each}`,
      ),
      ...Array.from({ length: 4 }, () => "moveForward"),
      ...Array.from({ length: 2 }, () => "moveForwardHalf"),
    ),
    steps,
  );
  const stats = ["distance", "turns", "effective-distance"].flatMap((each) =>
    ["total", "best-run", "current-run"].map((of) => `${of}-${each}`),
  );
  const command = fc.oneof(
    { weight: 6, arbitrary: withSteps.map(([name, number]) => `${name} ${number}`.trim()) },
    { weight: 4, arbitrary: fc.constantFrom("turnRight", "turnLeft", "turnLeft90") },
    { weight: 1, arbitrary: fc.constantFrom("turnRight45", "turnLeft45") },
    { weight: 1, arbitrary: fc.constantFrom("mazeWidth", "mazeHeight", "wasReset", "ackReset") },
    { weight: 2, arbitrary: fc.constantFrom(...stats, "score").map((name) => `getStat ${name}`) },
    { weight: 1, arbitrary: fc.constantFrom("fly", "getStat x", "turnLeft 1", "") },
  );
  const commands = fc.array(command, { minLength: 1, maxLength: 40 });

  async function expectSame(maze: MazeDocument, grid: GridWorld, lines: string[]): Promise<void> {
    const world = await startMouse(maze);
    const expected = lines.flatMap((line) => grid.answer(line) ?? []);
    await world.session.receive(lines.map((line) => `${line}\n`).join(""));
    for (let turn = 0; turn < 40; turn += 1) await settled();
    expect(world.transcript).toEqual(expected.map((line) => `< ${line}`));
    expect(world.port.simulation.bumps).toBe(0);
    world.session.close();
  }

  it("have the responses of a grid without a robot, between posts", async () => {
    await fc.assert(
      fc.asyncProperty(commands, (lines) =>
        expectSame(documentOf(small), gridOfDrawing(small.drawing), lines),
      ),
      { numRuns: 60 },
    );
  });

  it("have the responses of a grid without a robot, between blocks", async () => {
    await fc.assert(
      fc.asyncProperty(commands, (lines) => expectSame(rooms, gridOfBlocks(rooms), lines)),
      { numRuns: 60 },
    );
  });
});
