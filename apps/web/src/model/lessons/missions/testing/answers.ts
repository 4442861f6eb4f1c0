/**
 * For each mission, a solution that passes and the typical wrong answer with the result of its
 * check. They are separate from the missions, so that the page ships no solution.
 */
import type { Attempt, Failure } from "@corridor/challenge";
import type { Condition, Rule } from "@corridor/program";
import type { PlainAction, TimedCommand } from "@corridor/protocol";
import { lines, type MissionId } from "../mission.ts";

/** The result of a check, with numbers rounded to integers. */
export type Feedback = Pick<Failure, "code" | "maze" | "line" | "needed" | "found" | "tick"> & {
  /** the line's action and the front reading in cm when it decided; bumps only */
  decided?: { action: PlainAction; front: number };
};

export interface MissionAnswers {
  solution: Attempt;
  wrong: {
    why: string;
    attempt: Attempt;
    feedback: Feedback;
    /** the text that the student reads; programs only */
    reads?: string;
  };
}

const front = (is: "<" | ">", than: number): Condition => ({ sensor: "front", is, than });
const right = (is: "<" | ">", than: number): Condition => ({ sensor: "right", is, than });
const left = (is: "<" | ">", than: number): Condition => ({ sensor: "left", is, than });
const back = (is: "<" | ">", than: number): Condition => ({ sensor: "back", is, than });
const leftMoreThanRight: Condition = { sensor: "left", is: ">", than: "right", plus: 1 };
const line = (when: Condition, action: PlainAction): Rule => ({ when, do: action });

/** Holds the forward key for `ticks` ticks. */
const hold = (ticks: number): TimedCommand[] => [
  { tick: 0, command: { action: "forward" } },
  { tick: ticks, command: { action: "stop" } },
];

export const answers: Readonly<Record<MissionId, MissionAnswers>> = {
  "make-it-move": {
    solution: hold(240),
    wrong: {
      why: "presses the key instead of holding it",
      attempt: hold(6),
      feedback: { code: "not-reached", maze: 0, line: null, tick: 3600, needed: 7, found: 1 },
    },
  },
  "how-far": {
    solution: hold(300),
    wrong: {
      why: "counts one and a half blocks of free floor from the robot's edge, not from its centre",
      attempt: hold(285),
      feedback: { code: "not-stopped", maze: 0, line: null, tick: 7200, needed: 170, found: 175 },
    },
  },
  "one-line": {
    solution: lines("forward", line(front("<", 50), "turn 180")),
    wrong: {
      why: "reverse backs off until the line is false, and forward comes back",
      attempt: lines("forward", line(front("<", 50), "reverse")),
      reads:
        "The goal was not reached in 20 s. Line 1 drives back and “otherwise” drives forward, again and again. Each undoes the other. Try a turn.",
      feedback: { code: "not-reached", maze: 0, line: "default", tick: 1200, needed: 5, found: 3 },
    },
  },
  "first-true-line": {
    solution: lines("forward", line(front("<", 50), "right 90"), line(front("<", 50), "left 90")),
    wrong: {
      why: "believes that the second line is read too",
      attempt: lines("forward", line(front("<", 50), "left 90"), line(front("<", 50), "right 90")),
      reads:
        "The goal was not reached in 30 s. Line 2 was true at 4.0 s (front: 49.99 cm), but line 1 above it decided. The first true line wins.",
      feedback: {
        code: "not-reached",
        maze: 0,
        line: "default",
        tick: 1800,
        needed: 14,
        found: 12,
      },
    },
  },
  centimetres: {
    solution: lines("forward", line(back(">", 450), "left 90")),
    wrong: {
      why: "counts blocks instead of cm",
      attempt: lines("forward", line(back(">", 4), "left 90")),
      reads:
        "The goal was not reached in 30 s. Line 1 is always true. No sensor reads less than 25 cm. One block is 100 cm.",
      feedback: { code: "not-reached", maze: 0, line: 0, tick: 1800, needed: 9, found: 1 },
    },
  },
  "own-line": {
    solution: lines("forward", line(front("<", 50), "right 90")),
    wrong: {
      why: "takes the wrong sign, as in Figure 24",
      attempt: lines("forward", line(front(">", 50), "right 90")),
      reads:
        "Bump at 0.8 s. Line 1 was true at 0.0 s (front: 450 cm). Its sign, “>”, points the wrong way.",
      feedback: {
        code: "bump",
        maze: 0,
        line: "default",
        tick: 52,
        needed: 0,
        found: 1,
        decided: { action: "forward", front: 25 },
      },
    },
  },
  "side-opening": {
    solution: lines("forward", line(right(">", 60), "delayed right 90")),
    wrong: {
      why: "leaves out “delayed”, as in Figure 26",
      attempt: lines("forward", line(right(">", 60), "right 90")),
      reads:
        "Bump at 4.5 s. Line 1 chose “right 90” at 1.5 s, at the edge of the opening (right: 250 cm). A delayed turn drives on for 50 cm first.",
      feedback: {
        code: "bump",
        maze: 0,
        line: "default",
        tick: 270,
        needed: 0,
        found: 1,
        decided: { action: "forward", front: 25 },
      },
    },
  },
  "no-room": {
    solution: lines("forward", line(front("<", 50), "left 90")),
    wrong: {
      why: "delays a turn at a wall, as in Figure 25",
      attempt: lines("forward", line(front("<", 50), "delayed left 90")),
      reads:
        "Bump at 4.2 s. Line 1 chose “delayed left 90” at 4.0 s with 49.99 cm in front. It drives on first and needs 75 cm.",
      feedback: {
        code: "bump",
        maze: 0,
        line: 0,
        tick: 255,
        needed: 0,
        found: 1,
        decided: { action: "delayed left 90", front: 50 },
      },
    },
  },
  "order-of-lines": {
    solution: lines(
      "left 90",
      line(right(">", 60), "delayed right 90"),
      line(front(">", 50), "forward"),
    ),
    wrong: {
      why: "leaves the line that is nearly always true at the top",
      attempt: lines(
        "left 90",
        line(front(">", 50), "forward"),
        line(right(">", 60), "delayed right 90"),
      ),
      reads:
        "The goal was not reached in 30 s. Line 2 was true at 2.5 s (right: 250 cm), but line 1 above it decided. The first true line wins.",
      feedback: { code: "not-reached", maze: 0, line: 0, tick: 1800, needed: 9, found: 7 },
    },
  },
  "faulty-line": {
    solution: lines(
      "forward",
      line(right(">", 60), "delayed right 90"),
      line(left(">", 60), "delayed left 90"),
      line(front("<", 50), "turn 180"),
    ),
    wrong: {
      why: "fixes a line that was right",
      attempt: lines(
        "forward",
        line(right(">", 60), "right 90"),
        line(left(">", 60), "delayed left 90"),
        line(front("<", 50), "delayed left 90"),
      ),
      reads:
        "Bump at 3.0 s. Line 1 chose “right 90” at 0.5 s, at the edge of the opening (right: 250 cm). A delayed turn drives on for 50 cm first.",
      feedback: {
        code: "bump",
        maze: 0,
        line: 1,
        tick: 184,
        needed: 0,
        found: 1,
        decided: { action: "delayed left 90", front: 200 },
      },
    },
  },
  "right-wall": {
    solution: lines(
      "forward",
      line(right(">", 60), "delayed right 90"),
      line(front("<", 50), "left 90"),
    ),
    wrong: {
      why: "Figure 25: delayed where there is no room",
      attempt: lines(
        "forward",
        line(right(">", 60), "delayed right 90"),
        line(front("<", 50), "delayed left 90"),
      ),
      reads:
        "Bump at 7.5 s. Line 2 chose “delayed left 90” at 7.2 s with 49.99 cm in front. It drives on first and needs 75 cm.",
      feedback: {
        code: "bump",
        maze: 0,
        line: 1,
        tick: 451,
        needed: 0,
        found: 1,
        decided: { action: "delayed left 90", front: 50 },
      },
    },
  },
  "every-maze": {
    solution: lines(
      "forward",
      line(right(">", 60), "delayed right 90"),
      line(front("<", 50), "left 90"),
    ),
    wrong: {
      why: "believes that what passes the first maze is right",
      attempt: lines("forward", line(front("<", 50), "left 90")),
      reads:
        "Maze 2: The goal was not reached in 40 s. At 3.5 s, right was 250 cm, and no line turns right.",
      feedback: { code: "not-reached", maze: 1, line: "default", tick: 2400, needed: 7, found: 5 },
    },
  },
  "left-or-right": {
    solution: lines(
      "right 90",
      line(front(">", 50), "forward"),
      line(leftMoreThanRight, "left 90"),
    ),
    wrong: {
      why: "always turns left, which is right in the first maze",
      attempt: lines(
        "left 90",
        line(front(">", 50), "forward"),
        line(leftMoreThanRight, "left 90"),
      ),
      reads:
        "Maze 2: The goal was not reached in 8 s. “otherwise” chose “left 90” at 4.0 s (front: 50 cm, left: 150 cm, right: 250 cm). It needs another action.",
      feedback: { code: "not-reached", maze: 1, line: 0, tick: 480, needed: 8, found: 6 },
    },
  },
  "farthest-distance": {
    solution: lines(
      "forward",
      line(front(">", 50), "forward"),
      line(leftMoreThanRight, "left 90"),
      line({ sensor: "left", is: "<", than: "right", plus: 1 }, "right 90"),
    ),
    wrong: {
      why: "omits the case that right is farther",
      attempt: lines(
        "forward",
        line(front(">", 50), "forward"),
        line(leftMoreThanRight, "left 90"),
      ),
      reads:
        "Maze 1: Bump at 6.8 s. At 6.6 s, the wall was 50 cm ahead, and “otherwise” chose “forward”. A line for this place is missing.",
      feedback: {
        code: "bump",
        maze: 0,
        line: "default",
        tick: 411,
        needed: 0,
        found: 1,
        decided: { action: "forward", front: 27 },
      },
    },
  },
};
