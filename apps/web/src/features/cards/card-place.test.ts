import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { Box } from "../../stage/drawing/viewport.ts";
import * as cardPlace from "./card-place.ts";

const area: Box = { x: 0, y: 0, width: 960, height: 600 };
const card = { width: 360, height: 260 };

type Place = (
  areas: readonly Box[],
  robot: Box,
  shape: { width: number; height: number },
  keepClear: readonly Box[],
) => cardPlace.CardPlace;

const placeCard: Place = (areas, robot, shape, keepClear) =>
  placed(cardPlace.placeCard(areas, robot, [shape], keepClear));
const placeCardAway: Place = (areas, robot, shape, keepClear) =>
  placed(cardPlace.placeCardAway(areas, robot, [shape], keepClear));

function placed<Found>(place: Found | null): Found {
  if (place === null) throw new Error("a card has no place");
  return place;
}

function robotAt(x: number, y: number): Box {
  return { x: x - 20, y: y - 20, width: 40, height: 40 };
}

function touches(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

describe("placeCard", () => {
  it.each([
    { name: "right of a robot on the left", x: 200, y: 300, tail: "left" },
    { name: "left of a robot on the right", x: 800, y: 300, tail: "right" },
  ])("stands $name, 16 px away, its tail at the robot", ({ x, y, tail }) => {
    const robot = robotAt(x, y);
    const place = placeCard([area], robot, card, []);
    expect(place.tail).toBe(tail);
    expect(tail === "left" ? place.x - (x + 20) : x - 20 - (place.x + card.width)).toBe(16);
    expect(place.y + place.tailAt).toBe(y);
  });

  it("goes to the other side of a robot whose goal is where it would stand", () => {
    const goal = { x: 640, y: 260, width: 80, height: 80 };
    const place = placeCard([area], robotAt(470, 300), card, [goal]);
    expect(touches({ ...place, ...card }, goal)).toBe(false);
    expect(place.tail).toBe("right");
  });

  it("stands beyond the block that the robot hit, with its tail still at the robot", () => {
    const robot = robotAt(200, 500);
    const hit = { x: 220, y: 460, width: 80, height: 80 };
    const place = placeCard([area], robot, card, [hit]);
    expect(touches({ ...place, ...card }, hit)).toBe(false);
    expect(place).toMatchObject({ x: 316, tail: "left" });
    expect(place.y + place.tailAt).toBe(500);
  });

  it("moves along the robot where a goal would be below it, with its tail", () => {
    const goal = { x: 300, y: 380, width: 80, height: 80 };
    const place = placeCard([area], robotAt(100, 300), card, [goal]);
    expect(place).toMatchObject({ x: 136, y: 104, tail: "left", covered: 0 });
    expect(place.y + place.tailAt).toBe(300);
  });

  it("finds the one place between robot, block and goal", () => {
    const hit = { x: 180, y: 260, width: 80, height: 80 };
    const goals = [
      { x: 0, y: 500, width: 80, height: 80 },
      { x: 560, y: 20, width: 80, height: 80 },
      { x: 860, y: 100, width: 80, height: 80 },
    ];
    const place = placeCard([area], robotAt(150, 300), card, [hit, ...goals]);
    for (const each of [hit, ...goals]) expect(touches({ ...place, ...card }, each)).toBe(false);
    expect(place.covered).toBe(0);
  });

  it("covers as little as possible if it must cover something, and returns how much", () => {
    const low = { x: 0, y: 0, width: 500, height: 280 };
    const goal = { x: 380, y: 100, width: 80, height: 80 };
    const place = placeCard([low], robotAt(60, 140), card, [goal]);
    expect(touches({ ...place, ...card }, robotAt(60, 140))).toBe(false);
    expect(place.covered).toBeGreaterThan(0);
  });

  it("is wide and low only if a tall card would cover the goal", () => {
    const wide = { width: 440, height: 180 };
    const goal = { x: 300, y: 340, width: 80, height: 80 };
    const low = { x: 0, y: 0, width: 600, height: 600 };
    const place = (goals: Box[]) =>
      placed(cardPlace.placeCard([low], robotAt(100, 200), [card, wide], goals));
    expect(place([goal])).toMatchObject({ shape: card, tail: "left", covered: 0 });
    expect(place([goal, { ...goal, y: 0 }])).toMatchObject({ shape: wide, covered: 0 });
  });

  it("covers the legend only if it would cover something else otherwise", () => {
    const low = { x: 0, y: 0, width: 640, height: 400 };
    const withLegend = { ...low, height: 448 };
    const goal = { x: 300, y: 20, width: 80, height: 80 };
    const place = placeCard([low, withLegend], robotAt(100, 380), card, [goal]);
    expect(place.y + card.height).toBeLessThanOrEqual(392);
  });

  it("finds its place in a maze that is full of goals", () => {
    const goals = Array.from({ length: 256 }, (_, at) => ({
      x: 60 * (at % 16),
      y: 37 * Math.floor(at / 16),
      width: 30,
      height: 30,
    }));
    const robot = robotAt(470, 300);
    expect(touches({ ...placeCard([area], robot, card, goals), ...card }, robot)).toBe(false);
  });

  it("never covers the robot and stays in the stage wherever there is room", () => {
    fc.assert(
      fc.property(fc.integer({ min: 30, max: 930 }), fc.integer({ min: 30, max: 570 }), (x, y) => {
        const robot = robotAt(x, y);
        const place = placeCard([area], robot, card, []);
        expect(touches({ ...place, ...card }, robot)).toBe(false);
        expect(place.x).toBeGreaterThanOrEqual(8);
        expect(place.y).toBeGreaterThanOrEqual(8);
        expect(place.x + card.width).toBeLessThanOrEqual(952);
        expect(place.y + card.height).toBeLessThanOrEqual(592);
      }),
    );
  });

  it("has no tail where the card had to be pushed away from the robot on all sides", () => {
    expect(placeCard([area], robotAt(20, 20), card, []).tail).toBeNull();
  });

  it("is below a robot at the top if it would have no tail beside it", () => {
    expect(placeCard([area], robotAt(200, 20), card, [])).toMatchObject({ y: 56, tail: "top" });
  });

  it("starts at the edge of a stage that is smaller than the card, which is cut off there", () => {
    const small = { x: 0, y: 0, width: 300, height: 200 };
    const cut = { x: 8, y: 8, isCut: true };
    expect(placeCard([small], robotAt(150, 100), card, [])).toMatchObject(cut);
    expect(placeCard([small, area], robotAt(150, 100), card, []).isCut).toBe(false);
  });
});

describe("placeCardAway", () => {
  it.each([
    { name: "left of a robot on the right", x: 900, y: 60, at: { x: 8, y: 8 } },
    { name: "right of a robot on the left", x: 60, y: 60, at: { x: 592, y: 8 } },
  ])("stands high up, $name, without a tail", ({ x, y, at }) => {
    expect(placeCardAway([area], robotAt(x, y), card, [])).toMatchObject({ ...at, tail: null });
  });

  it("goes below where a goal is high up", () => {
    const goal = { x: 40, y: 40, width: 80, height: 80 };
    expect(placeCardAway([area], robotAt(900, 60), card, [goal])).toMatchObject({
      x: 8,
      y: 332,
    });
  });

  it("extends beyond a maze that is too small for it if the stage has space", () => {
    const maze = { x: 200, y: 30, width: 400, height: 300 };
    const goal = { x: 400, y: 110, width: 80, height: 80 };
    const place = placeCardAway([maze, area], robotAt(440, 150), card, [goal]);
    expect(touches({ ...place, ...card }, goal)).toBe(false);
  });

  it("covers the legend if a robot in a low stage would be hidden otherwise", () => {
    const low = { x: 0, y: 0, width: 640, height: 470 };
    const withLegend = { ...low, height: 518 };
    const robot = robotAt(300, 228);
    const place = placeCardAway([low, withLegend], robot, card, []);
    expect(touches({ ...place, ...card }, robot)).toBe(false);
  });

  it("shows its close button in a stage that is narrower than its lower shape", () => {
    const stage = { x: 0, y: 0, width: 652, height: 480 };
    const maze = { x: 70, y: 56, width: 548, height: 392 };
    const shapes = [
      { width: 476, height: 262 },
      { width: 608, height: 218 },
    ];
    const robot = { x: 324, y: 289, width: 44, height: 44 };
    const goal = { x: 307, y: 293, width: 78, height: 78 };
    const place = placed(cardPlace.placeCardAway([maze, stage], robot, shapes, [goal]));
    expect(place.x + place.shape.width).toBeLessThanOrEqual(stage.width);
    expect(place.covered).toBe(0);
  });

  it("is lower if it would cover the robot otherwise", () => {
    const low = { x: 0, y: 0, width: 640, height: 470 };
    const tall = { width: 476, height: 230 };
    const wide = { width: 600, height: 180 };
    const robot = robotAt(320, 235);
    const place = cardPlace.placeCardAway([low], robot, [tall, wide], []);
    expect(place).toMatchObject({ shape: wide, covered: 0 });
  });
});
