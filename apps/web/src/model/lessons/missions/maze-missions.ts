/**
 * Missions 11 to 14: whole programs. They cover the two algorithms of the study of 2013, and
 * programs that must pass in several mazes. A program that works once is easily believed to be
 * correct.
 */
import { allEdits, eastFrom, lines, programOf, room, type Mission } from "./mission.ts";

export const mazeMissions: readonly Mission[] = [
  {
    id: "right-wall",
    challenge: {
      mazes: [
        room(
          ["#######", "#...#.#", "###.#.#", "#...#.#", "#.###.#", "#.....#", "#######"],
          eastFrom(1, 1),
          { column: 5, row: 1 },
        ),
      ],
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: programOf(3, ...allEdits),
      checks: { bumps: 0, seconds: 60 },
      par: { lines: 2, seconds: 20 },
    },
  },
  {
    id: "every-maze",
    challenge: {
      mazes: [
        room(["#######", "#####.#", "#####.#", "#.....#", "#######"], eastFrom(1, 3), {
          column: 5,
          row: 1,
        }),
        room(["#######", "#.....#", "#####.#", "#####.#", "#######"], eastFrom(1, 1), {
          column: 5,
          row: 3,
        }),
        room(["#########", "#.......#", "###.#####", "###...###", "#########"], eastFrom(1, 1), {
          column: 5,
          row: 3,
        }),
      ],
      program: lines("forward", { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" }),
      goal: { kind: "reach" },
      allowed: programOf(3, ...allEdits),
      checks: { bumps: 0, seconds: 40 },
      par: { lines: 2, seconds: 12 },
    },
  },
  {
    id: "left-or-right",
    challenge: {
      mazes: [
        room(["#######", "#####.#", "#####.#", "#.....#", "#####.#", "#######"], eastFrom(1, 3), {
          column: 5,
          row: 1,
        }),
        room(["#######", "#####.#", "#.....#", "#####.#", "#####.#", "#######"], eastFrom(1, 2), {
          column: 5,
          row: 4,
        }),
      ],
      program: lines(
        "forward",
        { when: { sensor: "front", is: ">", than: 50 }, do: "forward" },
        { when: { sensor: "left", is: ">", than: "right", plus: 1 }, do: "forward" },
      ),
      goal: { kind: "reach" },
      allowed: programOf(2, "action", "otherwise"),
      checks: { bumps: 0, seconds: 8 },
      par: { lines: 2, seconds: 7 },
    },
  },
  {
    id: "farthest-distance",
    challenge: {
      mazes: [
        room(
          ["#########", "#####...#", "#####.###", "#.....###", "#####.###", "#########"],
          eastFrom(1, 3),
          { column: 7, row: 1 },
        ),
        room(
          ["#########", "#.....###", "###.#.###", "#####...#", "#######.#", "#########"],
          eastFrom(1, 1),
          { column: 7, row: 4 },
        ),
      ],
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: {
        ...programOf(3, ...allEdits),
        conditions: ["front >", "front <", "left < right", "left > right"],
      },
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 2, seconds: 12 },
    },
  },
];
