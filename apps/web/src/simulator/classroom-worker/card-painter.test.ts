import type { Tile } from "@corridor/protocol";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { readPalette } from "../../stage/drawing/palette.ts";
import { CardPainter } from "./card-painter.ts";
import { lesson } from "../testing/straight-lesson.ts";

/** Counts how often a card was drawn, and where its robot is. */
class FakeCanvas {
  static created = 0;
  drawn = 0;
  x = Number.NaN;
  readonly width = 120;
  readonly height = 120;

  constructor() {
    FakeCanvas.created += 1;
  }

  getContext(): unknown {
    return new Proxy(
      {},
      {
        get: (_target, name) => (x: number) => {
          if (name === "drawImage") this.drawn += 1;
          if (name === "translate") this.x = x;
        },
        set: () => true,
      },
    );
  }
}

class FakePath {
  lineTo(): void {
    // The test looks at the robot only.
  }
}

/** Cards of two students, whose frames and tiles the test controls. */
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
  const [moving, still] = [new FakeCanvas(), new FakeCanvas()];
  painter.place("a", 1, moving as unknown as OffscreenCanvas);
  painter.place("b", 2, still as unknown as OffscreenCanvas);
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
  return { painter, moving, still, frames, receive, pass };
}

describe("the pictures of the students", () => {
  beforeEach(() => {
    vi.stubGlobal("OffscreenCanvas", FakeCanvas);
    vi.stubGlobal("Path2D", FakePath);
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  it("move one robot smoothly, and draw no other card", () => {
    const { moving, still, frames, receive, pass } = newCards();
    pass(500);
    const before = still.drawn;
    const start = moving.x;
    receive(1, 250);
    const positions = Array.from({ length: 12 }, () => {
      pass(100);
      return moving.x;
    });
    expect(positions).toEqual(positions.toSorted((a, b) => a - b));
    expect(new Set(positions).size).toBeGreaterThan(4);
    expect(positions.at(-1)).toBeGreaterThan(start);
    expect(still.drawn).toBe(before);
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
    const { painter, moving, frames, receive, pass } = newCards();
    painter.setCalm(true);
    receive(1, 250);
    pass(500);
    const jumped = moving.x;
    painter.setCalm(true);
    pass(2_000);
    expect(moving.x).toBe(jumped);
    expect(frames).toEqual([]);
  });

  it("stop when a card is removed while its robot moves", () => {
    const { painter, frames, receive, pass } = newCards();
    receive(1, 250);
    pass(100);
    painter.remove("a");
    pass(100);
    expect(frames).toEqual([]);
  });

  it("generate an unseen maze once, however often the robot moves in it", () => {
    const { painter, receive, pass, moving } = newCards();
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
    const before = { reads, floors: FakeCanvas.created, drawn: moving.drawn };
    receive(1, 250, "u31");
    for (let frame = 0; frame < 12; frame++) pass(100);
    expect(moving.drawn).toBeGreaterThan(before.drawn + 4);
    expect(reads).toBe(before.reads);
    expect(FakeCanvas.created).toBe(before.floors);
  });

  it("show no maze that the lesson does not have", () => {
    const { receive, pass, moving } = newCards();
    pass(100);
    const { drawn } = moving;
    receive(1, 150, "u51");
    pass(100);
    expect(moving.drawn).toBe(drawn);
  });
});
