import { RefusedError } from "@corridor/protocol";
import { decode } from "fast-png";
import { describe, expect, it, vi } from "vitest";
import { instructions, watchInstructions } from "./instructions.ts";
import { agentFor, corridor } from "./testing/agent-client.ts";
import { refusal } from "./testing/maze-port.ts";

const FRONT_NEAR = { sensor: "front", is: "<=", than: 50 };

describe("an agent that connects", () => {
  it("learns the units, the actions and one solved corridor", async () => {
    const { client } = await agentFor();
    expect(client.getInstructions()).toBe(instructions);
    expect(instructions.split("\n").length).toBeLessThanOrEqual(40);
    for (const part of ["cm", "degrees", "move", "until", "key", "Goal reached: yes"]) {
      expect(instructions).toContain(part);
    }
  });

  it("solves the corridor of the instructions with its calls", async () => {
    const { call, robot } = await agentFor();
    const calls = [...instructions.matchAll(/act (\{.*?"step-\d+"\})/g)].map(
      ([, json = ""]) => JSON.parse(json) as Record<string, unknown>,
    );
    expect(calls).toHaveLength(3);
    expect((await call("sense")).text).toContain("front 350, right 50, back 50, left 50");
    const texts: string[] = [];
    for (const each of calls) texts.push((await call("act", each)).text);
    expect(texts[0]).toContain("front 50, right 250, back 350, left 50");
    expect(texts[1]).toContain("front 250");
    expect(texts[2]).toContain("Goal reached: yes");
    expect(robot.snapshot()).toMatchObject({ goalReached: true, bumps: 0 });
  });

  it("with a watch key learns and lists only what reads", async () => {
    const { client } = await agentFor({ capability: "watch" });
    expect(client.getInstructions()).toBe(watchInstructions);
    const { tools } = await client.listTools();
    expect(tools.map(({ name }) => name)).toEqual(["sense", "look", "wait"]);
    expect(tools.every(({ annotations }) => annotations?.readOnlyHint)).toBe(true);
  });

  it("learns the names of the tools if it calls another one", async () => {
    const { call } = await agentFor();
    await expect(call("fly")).rejects.toThrow("sense, look, wait, act, stop, reset");
  });
});

describe("sense", () => {
  it("returns the snapshot in words and in numbers", async () => {
    const { call } = await agentFor();
    const { text, structured } = await call("sense");
    expect(text).toBe(
      [
        "Free distance in cm: front 350, right 50, back 50, left 50.",
        "Position: x 150, y 150, heading 90 (east).",
        "Motion: stop. Bumps: 0. Goal reached: no. Time: 1 s.",
      ].join("\n"),
    );
    expect(structured).toMatchObject({ snapshot: { pose: { x: 150, y: 150, heading: 90 } } });
  });

  it("rounds numbers in the text only", async () => {
    const { call, port } = await agentFor();
    port.report({ pose: { x: 150.123456, y: 150, heading: 92.5 }, bumping: true, bumps: 1 });
    const { text, structured } = await call("sense");
    expect(text).toContain("x 150.1, y 150, heading 92.5 (about east)");
    expect(text).toContain("Bumps: 1, touching a wall now.");
    expect(structured).toMatchObject({ snapshot: { pose: { x: 150.123456 } } });
  });

  it.each([
    { change: { state: "gone" }, hint: "The robot's page is closed" },
    { change: { state: "paused" }, hint: "The robot is paused" },
    { change: { driver: "program" }, hint: "its owner must choose Remote" },
  ] as const)("explains why commands would not run: $change", async ({ change, hint }) => {
    const { call, port } = await agentFor();
    port.report(change);
    expect((await call("sense")).text).toContain(hint);
  });

  it("says that the robot has not reported yet", async () => {
    const { call, port } = await agentFor();
    port.newest = null;
    const { isError, text } = await call("sense");
    expect(isError).toBe(true);
    expect(text).toContain("The robot has not reported yet.");
  });

  it("says why a connection that lasted may no longer read", async () => {
    const { call, port } = await agentFor();
    port.newest = null;
    port.refusal = new RefusedError({
      type: "/problems/not-authorised",
      title: "Missing or invalid key",
      status: 401,
      detail: "The key was revoked.",
      errors: [],
    });
    expect(await call("sense")).toMatchObject({ isError: true, text: "The key was revoked." });
  });
});

describe("look", () => {
  it("draws the maze with the robot, the goal and a legend", async () => {
    const { call } = await agentFor();
    await call("act", { action: "move", distance: 100 });
    const { text, structured, pictures } = await call("look");
    expect(text.split("\n").slice(0, 5)).toEqual([
      "######",
      "#S>..#",
      "####.#",
      "####G#",
      "######",
    ]);
    expect(text).toContain("G goal");
    expect(text).toContain("Robot: cell (2, 1), heading 90.");
    expect(text).toContain("Goals: (4, 3).");
    expect(structured).toEqual({
      name: "Corridor",
      columns: 6,
      rows: 5,
      blocks: corridor.blocks,
      start: corridor.start,
      goals: corridor.goals,
      robot: { column: 2, row: 1, heading: 90 },
    });
    expect(pictures).toEqual([]);
  });

  it("shows the maze before the robot reports", async () => {
    const { call, port } = await agentFor();
    port.newest = null;
    const { text, structured } = await call("look", { picture: true });
    expect(text).toContain("#S...#");
    expect(structured).toMatchObject({ robot: null });
  });

  it("returns a PNG on request, with the robot where it stands", async () => {
    const { call } = await agentFor();
    const { pictures } = await call("look", { picture: true });
    expect(pictures).toHaveLength(1);
    const [{ data, mimeType } = { data: "", mimeType: "" }] = pictures;
    expect(mimeType).toBe("image/png");
    const image = decode(Buffer.from(data, "base64"));
    expect([image.width, image.height]).toEqual([144, 120]);
    const at = (x: number, y: number) => image.palette?.[image.data[y * 144 + x] ?? 0];
    const [block, open, robot, goal] = [at(2, 2), at(60, 36), at(33, 36), at(108, 84)];
    expect(new Set([block, open, robot, goal]).size).toBe(4);
    // The front of the robot faces east.
    expect(at(40, 36)).not.toEqual(robot);
  });

  it("paints the largest maze in at most 512 pixels", async () => {
    const side = 256;
    const blocks = Array.from({ length: side }, () => ".".repeat(side));
    const { call } = await agentFor({ maze: { ...corridor, blocks, goals: [] } });
    const { pictures, text } = await call("look", { picture: true });
    const image = decode(Buffer.from(pictures[0]?.data ?? "", "base64"));
    expect([image.width, image.height]).toEqual([512, 512]);
    expect(text).toContain("The maze has no goal.");
  });

  it("says that a physical robot has no maze", async () => {
    const { call, port } = await agentFor();
    port.refusal = refusal("no-maze", 404, "The relay has no maze of this robot.");
    const { isError, text } = await call("look");
    expect({ isError, text }).toEqual({
      isError: true,
      text: "The relay has no maze of this robot.",
    });
  });
});

describe("wait", () => {
  it("returns at once if a condition is true already", async () => {
    const { call, port } = await agentFor();
    const { text, structured } = await call("wait", {
      until: [FRONT_NEAR, { sensor: "right", is: ">=", than: 50 }],
    });
    expect(text).toContain("Condition 1 is true: right >= 50.");
    expect(structured).toMatchObject({ condition: 1, snapshot: { sensors: { right: 50 } } });
    expect(port.subscriptions).toBe(0);
  });

  it("returns when a report makes a condition true", async () => {
    const { call, port, clock } = await agentFor();
    const waiting = call("wait", { until: [{ goal: true }] });
    await vi.waitFor(() => expect(port.subscriptions).toBe(1));
    port.report();
    port.report({ goalReached: true });
    const { text, structured } = await waiting;
    expect(text).toContain("Condition 0 is true: a goal is reached.");
    expect(structured).toMatchObject({ condition: 0, snapshot: { goalReached: true } });
    expect([port.subscriptions, clock.waiting]).toEqual([0, 0]);
  });

  it("waits for the seconds only", async () => {
    const { call, port, clock } = await agentFor();
    const waiting = call("wait", { seconds: 2, until: [FRONT_NEAR] });
    await vi.waitFor(() => expect(port.subscriptions).toBe(1));
    clock.pass(2000);
    const { text, structured } = await waiting;
    expect(text).toContain("Waited 2 s. None of the conditions is true.");
    expect(structured).toMatchObject({ condition: null });
    expect(port.subscriptions).toBe(0);
  });

  it("ends when the key is revoked", async () => {
    const { call, port, clock } = await agentFor();
    const waiting = call("wait");
    await vi.waitFor(() => expect(port.subscriptions).toBe(1));
    port.end(refusal("not-authorised", 401, "The owner has revoked the key."));
    expect(await waiting).toMatchObject({ isError: true, text: "The owner has revoked the key." });
    expect([port.subscriptions, clock.waiting]).toEqual([0, 0]);
  });

  it("ends when the client disconnects", async () => {
    const { call, port, clock, agent } = await agentFor();
    const waiting = call("wait");
    await vi.waitFor(() => expect(port.subscriptions).toBe(1));
    agent.close();
    await waiting;
    expect([port.subscriptions, clock.waiting, port.isClosed]).toEqual([0, 0, true]);
  });
});

describe("act", () => {
  it("returns the record and the snapshot after the command", async () => {
    const { call } = await agentFor();
    const { text, structured } = await call("act", { action: "move", distance: 100 });
    expect(text).toMatch(/^Command 1 \(move\): completed, 100 cm driven\.\nFree distance in cm: /);
    expect(structured).toMatchObject({
      record: { seq: 1, action: "move", state: "completed", distance: 100 },
      snapshot: { pose: { x: 250 } },
    });
  });

  it("says that the robot touched a wall, which is no error", async () => {
    const { call } = await agentFor();
    const { isError, text } = await call("act", { action: "move", distance: 900 });
    expect(isError).toBe(false);
    expect(text).toContain("collided, 325 cm driven. The robot touched a wall and stands still.");
  });

  it("moves the robot once for the same key", async () => {
    const { call, robot } = await agentFor();
    const act = { action: "move", distance: 100, key: "step-0001" };
    await call("act", act);
    const again = await call("act", act);
    expect(again.text).toContain("This key was sent before, so the robot did not move again.");
    // An agent of a new conversation may repeat the keys of an earlier one.
    expect(again.text).toContain("If this is a new command, send it with another key.");
    expect(again.structured).toMatchObject({ record: { seq: 1, duplicate: true } });
    expect(robot.done).toHaveLength(1);
    expect(await call("act", { ...act, distance: 50 })).toMatchObject({ isError: true });
  });

  it("explains how to follow a command that runs for longer", async () => {
    const { call, port } = await agentFor();
    port.endsCommands = false;
    const { text } = await call("act", { action: "move", distance: 100 });
    expect(text).toContain("It has not ended yet: to follow it, call wait or sense.");
    const keyed = await call("act", { action: "move", distance: 100, key: "step-0002" });
    expect(keyed.text).toContain("send the same act with the same key");
  });

  it.each([
    { args: { action: "fly" }, says: "action: found 'fly', expected one of forward, reverse" },
    { args: {}, says: "action: found nothing" },
    { args: { action: "move", distance: "far" }, says: "distance: found 'far'" },
    { args: { action: "left 90", until: [FRONT_NEAR] }, says: "until: found" },
    { args: { action: "forward", until: [] }, says: "until: found" },
    { args: { action: "stop", key: "short" }, says: "key: found 'short'" },
    { args: { action: "stop", key: 12345678 }, says: "key: found 12345678" },
    { args: { action: "stop", speed: 2 }, says: "speed: found 2" },
  ])("refuses $args with a sentence, and the robot stands", async ({ args, says }) => {
    const { call, robot } = await agentFor();
    const { isError, text, structured } = await call("act", args);
    expect(isError).toBe(true);
    expect(text).toContain(says);
    expect(structured).toMatchObject({ problem: { status: 400 } });
    expect(robot.done).toEqual([]);
  });

  it("returns the record of a command that ends before the robot reports", async () => {
    const { call, port } = await agentFor();
    const send = port.send.bind(port);
    port.send = async (...args) => {
      const record = await send(...args);
      port.newest = null;
      return record;
    };
    const { isError, text, structured } = await call("act", { action: "stop" });
    expect(isError).toBe(false);
    expect(text).toMatch(/^Command 1 \(stop\): completed\.\nThe robot has not reported yet\./);
    expect(structured).toMatchObject({ record: { seq: 1 }, snapshot: null });
  });

  it("says that the command was sent if only its end is unknown", async () => {
    const { call, port } = await agentFor();
    port.endOf = () => Promise.reject(refusal("too-many-readers", 429, "Too many wait."));
    expect(await call("act", { action: "stop" })).toMatchObject({
      isError: true,
      text: "Too many wait. Command 1 was sent before.",
    });
  });

  it("is refused for a key that only watches", async () => {
    const { call, robot } = await agentFor({ capability: "watch" });
    for (const [name, args] of [
      ["act", { action: "left 90" }],
      ["stop", {}],
      ["reset", {}],
    ] as const) {
      const { isError, text } = await call(name, args);
      expect(isError).toBe(true);
      expect(text).toContain("A watch key permits only reading.");
    }
    expect(robot.done).toEqual([]);
  });
});

describe("stop and reset", () => {
  it("stop the robot, and put it back at its start", async () => {
    const { call, robot } = await agentFor();
    await call("act", { action: "move", distance: 100 });
    expect((await call("stop")).text).toContain("Command 2 (stop): completed.");
    const { text, structured } = await call("reset", { key: "reset-001" });
    expect(text).toContain("Command 3 (reset): completed.");
    expect(structured).toMatchObject({ snapshot: { pose: { x: 150, y: 150 } } });
    await call("reset", { key: "reset-001" });
    expect(robot.done.map(({ action }) => action)).toEqual(["move", "stop", "reset"]);
  });
});

describe("arguments", () => {
  it.each([
    { name: "sense", args: { fast: true }, says: "fast: found true, expected no field" },
    {
      name: "look",
      args: { picture: "yes" },
      says: "picture: found 'yes', expected true or false",
    },
    {
      name: "wait",
      args: { seconds: 26 },
      says: "seconds: found 26, expected seconds from 0 to 25",
    },
    { name: "wait", args: { until: [{ sensor: "up" }] }, says: "until[0].sensor: found 'up'" },
    { name: "stop", args: { now: 1 }, says: "now: found 1" },
    { name: "reset", args: { key: "x" }, says: "key: found 'x'" },
  ])("that are wrong are refused with the field: $name $args", async ({ name, args, says }) => {
    const { call } = await agentFor();
    const { isError, text } = await call(name, args);
    expect(isError).toBe(true);
    expect(text).toContain(says);
  });
});
