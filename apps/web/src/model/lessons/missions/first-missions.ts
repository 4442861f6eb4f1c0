/**
 * Missions 1 to 4: the content of the ten-minute introduction in the study of 2013. They cover the
 * robot and its keys, sensors as distances, one line with "otherwise", and that the first true line
 * wins.
 */
import { eastFrom, lines, programOf, room, type Mission } from "./mission.ts";

const byHand: Mission["challenge"]["allowed"] = {
  drivers: ["me"],
  lines: 0,
  conditions: null,
  actions: null,
  edits: [],
  maze: false,
};

export const firstMissions: readonly Mission[] = [
  {
    id: "make-it-move",
    challenge: {
      mazes: [room(["#########", "#.......#", "#########"], eastFrom(1, 1), { column: 5, row: 1 })],
      program: lines("forward"),
      goal: { kind: "reach" },
      // Run counts too: a student who presses it first has made the robot move.
      allowed: { ...byHand, drivers: ["me", "program"] },
      checks: { bumps: null, seconds: 60 },
      par: { lines: 0, seconds: 4 },
    },
  },
  {
    id: "how-far",
    challenge: {
      mazes: [room(["#########", "#.......#", "#########"], eastFrom(1, 1))],
      program: lines("forward"),
      goal: { kind: "stop", sensor: "front", from: 130, to: 170 },
      allowed: byHand,
      checks: { bumps: 0, seconds: 120 },
      par: { lines: 0, seconds: 6 },
    },
  },
  {
    id: "one-line",
    challenge: {
      mazes: [room(["#######", "#.....#", "#######"], eastFrom(3, 1), { column: 1, row: 1 })],
      program: lines("forward", { when: { sensor: "front", is: "<", than: 50 }, do: "forward" }),
      goal: { kind: "reach" },
      allowed: {
        ...programOf(1, "action"),
        actions: ["forward", "reverse", "left 90", "turn 180"],
      },
      checks: { bumps: 0, seconds: 20 },
      par: { lines: 1, seconds: 8 },
    },
  },
  {
    id: "first-true-line",
    challenge: {
      mazes: [
        room(
          ["#######", "#.....#", "#.###.#", "#.....#", "#####.#", "#####.#", "#######"],
          eastFrom(1, 3),
          { column: 5, row: 5 },
        ),
      ],
      program: lines(
        "forward",
        { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
        { when: { sensor: "front", is: "<", than: 50 }, do: "right 90" },
      ),
      goal: { kind: "reach" },
      allowed: programOf(2, "order"),
      checks: { bumps: 0, seconds: 30 },
      par: { lines: 2, seconds: 8 },
    },
  },
];
