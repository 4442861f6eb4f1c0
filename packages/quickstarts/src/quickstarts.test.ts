import { describe, expect, it } from "vitest";
import { quickstartIds, quickstarts } from "./quickstarts.ts";

const robot = { origin: "https://host", id: "r1", key: "drv_key", urlKey: "url_key" };
/** Columns of the widest line. */
const MAX_COLUMNS = 126;

describe.each(quickstartIds)("the quickstart %s", (id) => {
  const { text, hasUrlKey, file, command, needs } = quickstarts[id];
  const written = text(robot);

  it("has 25 lines at most, which are not too wide", () => {
    const lines = written.trimEnd().split("\n");
    expect(lines.length).toBeLessThanOrEqual(25);
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(MAX_COLUMNS);
    // A terminal would run a line that the user still has to complete.
    expect(written.endsWith("\n")).toBe(file !== null);
  });

  it("contains the robot and exactly one kind of key, once", () => {
    expect(written).toContain("//host/");
    expect(written).toContain("r1");
    const [used, other] = hasUrlKey ? [robot.urlKey, robot.key] : [robot.key, robot.urlKey];
    expect(written.split(used)).toHaveLength(2);
    expect(written).not.toContain(other);
  });

  it("says how to start its file", () => {
    expect(command === null || (file !== null && command.includes(file))).toBe(true);
    expect(needs ?? "Any 1").toMatch(/ \d+(\.\d+)?$/);
  });
});

it("uses a secure WebSocket only where the page is secure", () => {
  const { text } = quickstarts.rosbridge;
  expect(text(robot)).toBe("wss://host/r/r1/ros/url_key");
  expect(text({ ...robot, origin: "http://localhost:8080" })).toBe(
    "ws://localhost:8080/r/r1/ros/url_key",
  );
});

it("the first script has six lines, in which a reader finds the address", () => {
  const lines = quickstarts.python.text(robot).trimEnd().split("\n");
  expect(lines).toHaveLength(6);
  expect(lines[0]).toBe("from corridor import Robot");
  expect(lines[1]).toContain('"https://host/r/r1#drv_key"');
});
