import type { Tile } from "@corridor/protocol";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { readPalette } from "../../stage/drawing/palette.ts";
import type { PictureBox } from "../protocol/classroom-messages.ts";
import { CardPainter } from "./card-painter.ts";
import { lesson } from "../testing/straight-lesson.ts";

/** Counts how often a canvas was drawn on at each place, and where its robots are. */
class FakeCanvas {
  static created = 0;
  /** number of drawings, by left edge */
  readonly drawn = new Map<number, number>();
  /** positions of robots, by left edge of the picture */
  readonly robots = new Map<number, number>();
  /** left edges of erased boxes */
  erased: number[] = [];

  width = 1;
  height = 1;

  constructor() {
    FakeCanvas.created += 1;
  }

  getContext(): unknown {
    let left = Number.NaN;
    const calls: Record<string, (x: number, y: number) => void> = {
      clearRect: (x) => void this.erased.push((left = x)),
      translate: (x) => void this.robots.set(left, x),
    };
    const drawImage = (_image: unknown, x: number): void =>
      void this.drawn.set(x, (this.drawn.get(x) ?? 0) + 1);
    return new Proxy(
      {},
      {
        get: (_target, name) => (name === "drawImage" ? drawImage : (calls[String(name)] ?? none)),
        set: () => true,
      },
    );
  }
}

function none(): void {
  // The test looks at places only.
}

class FakePath {
  lineTo(): void {
    // The test looks at the robot only.
  }
}

const SIDE = 120;

function boxOf(student: number, x: number): PictureBox {
  return { student, x, y: 0, width: SIDE, height: SIDE, isOld: false };
}

/** Pictures of two students, side by side, whose frames and tiles the test controls. */
function newCards() {
  const frames: (() => void)[] = [];
  let now = 0;
  const tiles = new Map<number, Tile>();
  const painter = new CardPainter({
    tileOf: (student) => tiles.get(student) ?? null,
    requestFrame: (paint) => void frames.push(paint),
    now: () => now,
  });
  painter.setLesson(lesson);
  painter.setPalette(readPalette(() => "black"));
  const canvas = new FakeCanvas();
  painter.place("a", canvas as unknown as OffscreenCanvas);
  /** Puts students side by side. */
  const arrange = (...students: number[]): void =>
    painter.arrange(
      "a",
      SIDE * students.length,
      SIDE,
      students.map((student, at) => boxOf(student, at * SIDE)),
    );
  arrange(1, 2);
  const receive = (student: number, x: number, maze = "g1"): void => {
    tiles.set(student, {
      seq: 1,
      task: 1,
      maze,
      state: "driving",
      pose: [x, 150, 90],
      path: "e1",
      line: 1,
      tick: 1,
      bumps: 0,
      passes: null,
    });
    painter.changed([student]);
  };
  /** Time passes until the next frame. */
  const pass = (ms: number): void => {
    now += ms;
    for (const paint of frames.splice(0)) paint();
  };
  receive(1, 150);
  receive(2, 150);
  pass(0);
  const drawn = (at: number): number => canvas.drawn.get(at * SIDE) ?? 0;
  const robot = (): number => canvas.robots.get(0) ?? Number.NaN;
  return { painter, canvas, arrange, drawn, robot, frames, receive, pass };
}

describe("the pictures of the students", () => {
  beforeEach(() => {
    vi.stubGlobal("OffscreenCanvas", FakeCanvas);
    vi.stubGlobal("Path2D", FakePath);
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  it("move one robot smoothly, and draw no other picture", () => {
    const { drawn, robot, frames, receive, pass } = newCards();
    pass(500);
    const before = drawn(1);
    const start = robot();
    receive(1, 250);
    const positions = Array.from({ length: 12 }, () => {
      pass(100);
      return robot();
    });
    expect(positions).toEqual(positions.toSorted((a, b) => a - b));
    expect(new Set(positions).size).toBeGreaterThan(4);
    expect(positions.at(-1)).toBeGreaterThan(start);
    expect(drawn(1)).toBe(before);
    expect(frames).toEqual([]);
  });

  it("request no frame while no robot moves", () => {
    const { frames, receive, pass } = newCards();
    expect(frames).toEqual([]);
    receive(1, 150);
    pass(500);
    expect(frames).toEqual([]);
  });

  it("jump from tile to tile for teachers who prefer reduced motion", () => {
    const { painter, robot, frames, receive, pass } = newCards();
    painter.setCalm(true);
    receive(1, 250);
    pass(500);
    const jumped = robot();
    painter.setCalm(true);
    pass(2_000);
    expect(robot()).toBe(jumped);
    expect(frames).toEqual([]);
  });

  it("stop when a canvas is removed while a robot moves", () => {
    const { painter, frames, receive, pass } = newCards();
    receive(1, 250);
    pass(100);
    painter.remove("a");
    pass(100);
    expect(frames).toEqual([]);
  });

  it("stop when a student leaves while the robot moves", () => {
    const { arrange, canvas, frames, receive, pass } = newCards();
    receive(1, 250);
    pass(100);
    arrange(2);
    pass(100);
    expect(canvas.width).toBe(SIDE);
    expect(frames).toEqual([]);
  });

  it("draw again only what has another place", () => {
    const { arrange, drawn, pass } = newCards();
    pass(500);
    const before = [drawn(0), drawn(1)];
    arrange(1, 2);
    pass(100);
    expect([drawn(0), drawn(1)]).toEqual(before);
    arrange(2, 1);
    pass(100);
    expect([drawn(0), drawn(1)]).toEqual(before.map((count) => count + 1));
  });

  it("erase a picture that has left", () => {
    const { painter, canvas, pass } = newCards();
    pass(500);
    canvas.erased = [];
    painter.arrange("a", 2 * SIDE, SIDE, [boxOf(1, 0)]);
    pass(100);
    expect(canvas.erased).toEqual([SIDE]);
  });

  it("generate an unseen maze once, however often the robot moves in it", () => {
    const { painter, receive, pass, drawn } = newCards();
    let reads = 0;
    const tasks = lesson.tasks.map((task) => ({
      ...task,
      get unseen() {
        reads += 1;
        return task.unseen;
      },
    }));
    painter.setLesson({ ...lesson, tasks });
    receive(1, 150, "u31");
    pass(500);
    const before = { reads, floors: FakeCanvas.created, drawn: drawn(0) };
    receive(1, 250, "u31");
    for (let frame = 0; frame < 12; frame++) pass(100);
    expect(drawn(0)).toBeGreaterThan(before.drawn + 4);
    expect(reads).toBe(before.reads);
    expect(FakeCanvas.created).toBe(before.floors);
  });

  it("show no maze that the lesson does not have", () => {
    const { receive, pass, drawn } = newCards();
    pass(100);
    const before = drawn(0);
    receive(1, 150, "u51");
    pass(100);
    expect(drawn(0)).toBe(before);
  });
});
