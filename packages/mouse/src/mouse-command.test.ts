import { describe, expect, it } from "vitest";
import { readMouseCommand } from "./mouse-command.ts";

describe("a line", () => {
  it.each([
    ["mazeWidth", { do: "width" }],
    ["mazeHeight", { do: "height" }],
    ["wallFront", { do: "wall", eighths: 0, halfSteps: 1 }],
    ["wallRight 3", { do: "wall", eighths: 2, halfSteps: 3 }],
    ["wallBack 0", { do: "wall", eighths: 4, halfSteps: 1 }],
    ["wallLeft -2", { do: "wall", eighths: 6, halfSteps: 1 }],
    ["wallFrontRight x", { do: "wall", eighths: 1, halfSteps: 1 }],
    ["wallBackRight", { do: "wall", eighths: 3, halfSteps: 1 }],
    ["wallBackLeft", { do: "wall", eighths: 5, halfSteps: 1 }],
    ["wallFrontLeft", { do: "wall", eighths: 7, halfSteps: 1 }],
    ["moveForward", { do: "move", halfSteps: 2 }],
    ["  moveForward   3 ", { do: "move", halfSteps: 6 }],
    ["moveForward 1.5", { do: "move", halfSteps: 0 }],
    ["moveForward 99999999999", { do: "move", halfSteps: 0 }],
    ["moveForwardHalf 3", { do: "move", halfSteps: 3 }],
    ["turnRight", { do: "turn", eighths: 2 }],
    ["turnRight90", { do: "turn", eighths: 2 }],
    ["turnLeft", { do: "turn", eighths: -2 }],
    ["turnLeft90", { do: "turn", eighths: -2 }],
    ["turnRight45", { do: "turn", eighths: 1 }],
    ["turnLeft45", { do: "turn", eighths: -1 }],
    ["wasReset", { do: "was-reset" }],
    ["ackReset", { do: "acknowledge-reset" }],
    ["getStat best-run-effective-distance", { do: "stat", name: "best-run-effective-distance" }],
  ])("%j has a response", (line, command) => {
    expect(readMouseCommand(line)).toEqual({ kind: "robot", command });
  });

  it.each([
    ["setWall 1 2 n", { do: "set-wall", x: 1, y: 2, side: "n" }],
    ["clearWall 1 2 w", { do: "clear-wall", x: 1, y: 2, side: "w" }],
    ["setColor 0 0 G", { do: "set-color", x: 0, y: 0, color: "G" }],
    ["clearColor -1 300", { do: "clear-color", x: -1, y: 300 }],
    ["clearAllColor", { do: "clear-all-color" }],
    ["setText 1 2 a b  c", { do: "set-text", x: 1, y: 2, text: "a b  c" }],
    ["setText 1 2 ", { do: "set-text", x: 1, y: 2, text: "" }],
    ["setText 1 2", { do: "set-text", x: 1, y: 2, text: "" }],
    ["clearText 1 2", { do: "clear-text", x: 1, y: 2 }],
    ["clearAllText", { do: "clear-all-text" }],
  ])("%j has none", (line, command) => {
    expect(readMouseCommand(line)).toEqual({ kind: "display", command });
  });

  it.each([
    "",
    "fly",
    "MazeWidth",
    "mazeWidth 1",
    "turnRight 90",
    "turnRight45 1",
    "moveForward 1 2",
    "wallFront 1 2",
    "getStat",
    "getStat total",
    "getStat constructor",
    "wasReset now",
    "setWall 1 2 N",
    "setWall 1 2",
    "setWall a 2 n",
    "setWalls 1 2 n",
    "setColor 1 2 green",
    "setColor 1 2 q",
    "setColor 1 2 __proto__",
    "clearColor 1",
    "clearAllColor 1",
    "setText a 2 b",
    "setText 1",
    "clearText 1 2 3",
    "toString",
  ])("%j is no command", (line) => {
    expect(readMouseCommand(line)).toBeNull();
  });
});
