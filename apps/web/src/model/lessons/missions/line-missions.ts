/**
 * Missions 5 to 10, with one idea each: numbers as centimetres, the first line of one's own,
 * delayed turns, the order of lines, and the search for a wrong line. Delayed turns appear where
 * they are needed and where they are not.
 */
import { allEdits, eastFrom, lines, programOf, room, type Mission } from "./mission.ts";

export const lineMissions: readonly Mission[] = [
  {
    id: "centimetres",
    challenge: {
      mazes: [
        room(["#########", "#####.###", "#####.###", "#.......#", "#########"], eastFrom(1, 3), {
          column: 5,
          row: 1,
        }),
      ],
      program: lines("forward", { when: { sensor: "back", is: ">", than: 100 }, do: "left 90" }),
      goal: { kind: "reach" },
      allowed: programOf(1, "number"),
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 1, seconds: 7 },
    },
  },
  {
    id: "own-line",
    challenge: {
      mazes: [
        room(["#######", "#.....#", "#####.#", "#####.#", "#######"], eastFrom(1, 1), {
          column: 5,
          row: 3,
        }),
      ],
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: { ...programOf(1, ...allEdits), conditions: ["front >", "front <"] },
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 1, seconds: 7 },
    },
  },
  {
    id: "side-opening",
    challenge: {
      mazes: [
        room(["#######", "#.....#", "###.###", "###.###", "#######"], eastFrom(1, 1), {
          column: 3,
          row: 3,
        }),
      ],
      program: lines("forward", { when: { sensor: "right", is: ">", than: 60 }, do: "forward" }),
      goal: { kind: "reach" },
      allowed: programOf(1, "action"),
      checks: { bumps: 0, seconds: 20 },
      par: { lines: 1, seconds: 5 },
    },
  },
  {
    id: "no-room",
    challenge: {
      mazes: [
        room(["#######", "#####.#", "#####.#", "#.....#", "#######"], eastFrom(1, 3), {
          column: 5,
          row: 1,
        }),
      ],
      program: lines("forward", { when: { sensor: "front", is: "<", than: 50 }, do: "forward" }),
      goal: { kind: "reach" },
      allowed: programOf(1, "action"),
      checks: { bumps: 0, seconds: 20 },
      par: { lines: 1, seconds: 7 },
    },
  },
  {
    id: "order-of-lines",
    challenge: {
      mazes: [
        room(["#########", "#.......#", "####.####", "####.####", "#########"], eastFrom(1, 1), {
          column: 4,
          row: 3,
        }),
      ],
      program: lines(
        "left 90",
        { when: { sensor: "front", is: ">", than: 50 }, do: "forward" },
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
      ),
      goal: { kind: "reach" },
      allowed: programOf(2, "order"),
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 2, seconds: 6 },
    },
  },
  {
    id: "faulty-line",
    challenge: {
      mazes: [
        room(["#######", "#...###", "###.###", "###...#", "#######"], eastFrom(2, 1), {
          column: 1,
          row: 1,
        }),
      ],
      program: lines(
        "forward",
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
        { when: { sensor: "left", is: ">", than: 60 }, do: "delayed left 90" },
        { when: { sensor: "front", is: "<", than: 50 }, do: "delayed left 90" },
      ),
      goal: { kind: "reach" },
      allowed: programOf(3, "action"),
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 3, seconds: 15 },
    },
  },
];
