import { describe, expect, it } from "vitest";
import { startMouse } from "./testing/mouse-world.ts";
import { documentOf, mouseMazes, turnedClockwise } from "./testing/mouse-mazes.ts";

function drawn() {
  const [maze] = mouseMazes;
  if (maze === undefined) throw new Error("no maze");
  return documentOf(maze);
}

describe("display commands", () => {
  it("change texts, colours and walls, and never drive the robot", async () => {
    const { port, marks, timers, lines } = await startMouse(drawn());
    const orders = port.orders.length;
    lines.say("setColor 0 0 g");
    lines.say("setText 0 0 a much longer text");
    lines.say("setText 1 0 é\t!");
    lines.say("setWall 0 0 e");
    lines.say("setWall 0 0 w");
    lines.say("setColor 9 9 g");
    await timers.pass(0);
    const blank = { text: "", color: null, walls: "" };
    expect(marks).toEqual([
      {
        fresh: false,
        pitch: 2,
        cells: [
          { ...blank, column: 1, row: 11, color: "green", text: "a much lon", walls: "ew" },
          { ...blank, column: 3, row: 11, text: "??!", walls: "w" },
        ],
      },
    ]);
    for (const line of ["clearAllText", "clearAllColor", "clearWall 1 0 w"]) lines.say(line);
    await timers.pass(100);
    expect(marks[1]?.cells).toEqual([
      { ...blank, column: 1, row: 11, walls: "w" },
      { ...blank, column: 3, row: 11 },
    ]);
    for (const line of ["setText 2 2 a", "setColor 2 2 r", "clearText 2 2", "clearColor 2 2"]) {
      lines.say(line);
    }
    await timers.pass(100);
    expect(marks[2]?.cells).toEqual([{ ...blank, column: 5, row: 7 }]);
    expect(port.orders).toHaveLength(orders);
  });

  it("are where the robot is, in a maze that starts in another corner", async () => {
    const { marks, timers, lines } = await startMouse(turnedClockwise(drawn()));
    lines.say("setWall 0 0 n");
    await timers.pass(0);
    expect(marks[0]?.cells).toEqual([
      { column: 1, row: 1, text: "", color: null, walls: "e" },
      { column: 3, row: 1, text: "", color: null, walls: "w" },
    ]);
  });

  it("are published at most ten times a second, and only the newest marks", async () => {
    const { marks, timers, lines } = await startMouse(drawn());
    for (let ms = 0; ms < 990; ms += 5) {
      lines.say(`setText 1 1 ${ms}`);
      await timers.pass(5);
    }
    expect(marks).toHaveLength(10);
    await timers.pass(900);
    expect(marks).toHaveLength(11);
    expect(marks.at(-1)?.cells).toMatchObject([{ text: "985" }]);
  });

  it("of more than 128 cells are sent in parts, and end with the session", async () => {
    const blocks = Array.from({ length: 20 }, () => ".".repeat(20));
    const start = { column: 0, row: 19, heading: "north" } as const;
    const { marks, timers, lines, session } = await startMouse({ ...drawn(), blocks, start });
    for (let cell = 0; cell < 200; cell += 1) {
      lines.say(`setText ${cell % 20} ${Math.floor(cell / 20)} x`);
    }
    await timers.pass(0);
    expect(marks.map(({ cells }) => cells.length)).toEqual([128]);
    await timers.pass(100);
    expect(marks.map(({ cells }) => cells.length)).toEqual([128, 72]);
    lines.say("clearAllText");
    session.close();
    await timers.pass(10_000);
    expect(marks).toHaveLength(2);
  });

  it("are repeated while others change, for viewers who join in the middle of a run", async () => {
    const { marks, timers, lines } = await startMouse(drawn());
    lines.say("setText 0 0 old");
    await timers.pass(100);
    marks.length = 0;
    for (let ms = 0; ms < 3_000; ms += 50) {
      lines.say(`setText 1 1 ${ms}`);
      await timers.pass(50);
    }
    const repeated = marks.filter(({ cells }) => cells.some(({ text }) => text === "old"));
    expect(repeated).toHaveLength(3);
  });

  it("are repeated once a second while nothing changes, in turn and without empty cells", async () => {
    const blocks = Array.from({ length: 20 }, () => ".".repeat(20));
    const start = { column: 0, row: 19, heading: "north" } as const;
    const { marks, timers, lines } = await startMouse({ ...drawn(), blocks, start });
    for (let cell = 0; cell < 200; cell += 1) {
      lines.say(`setText ${cell % 20} ${Math.floor(cell / 20)} x`);
    }
    await timers.pass(200);
    marks.length = 0;
    lines.say("clearText 0 0");
    await timers.pass(3_100);
    expect(marks.map(({ cells }) => cells.length)).toEqual([1, 128, 128, 128]);
    const repeated = marks.slice(1).flatMap(({ cells }) => cells);
    expect(new Set(repeated.map(({ column, row }) => `${column} ${row}`)).size).toBe(199);
    expect(repeated.every(({ text }) => text === "x")).toBe(true);
    lines.say("clearAllText");
    await timers.pass(300);
    marks.length = 0;
    await timers.pass(5_000);
    expect(marks).toEqual([]);
  });
});
