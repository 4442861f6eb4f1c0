/**
 * Runs of one hour: a program that changes its action rarely, a program that changes it in every
 * tick, and a person who presses keys.
 */
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { Recording } from "@corridor/recording";

export const HOUR_TICKS = 216_000;
const SIDE = 33;
/**
 * Ticks between two key presses: faster than a person, and the maximum that the run file can store.
 */
const PRESS_INTERVAL = 3;

export interface HourRun {
  /** what drives the robot */
  name: string;
  /** Records the first `ticks` ticks of the run. */
  record: (ticks: number) => Recording;
}

/** All runs are in the same maze. */
export function hourRuns(): HourRun[] {
  const rightWall = programPresets.find(({ id }) => id === "right-wall")?.program;
  if (rightWall === undefined) throw new Error("no right-wall program among the presets");
  const alternating: ProgramDocument = {
    ...rightWall,
    rules: [{ when: { sensor: "front", is: "<", than: 120 }, do: "reverse" }],
    default: "forward",
  };
  const tree = generateTree({ columns: SIDE, rows: SIDE, seed: 1, name: "tree" });
  const maze: MazeDocument = { ...tree, goals: [] };
  return [
    { name: "right wall", record: (ticks) => drive(new Recording(maze, rightWall), ticks) },
    {
      name: "forward and back on every tick",
      record: (ticks) => drive(new Recording(maze, alternating), ticks),
    },
    {
      name: "20 keys per second",
      record: (ticks) => pressKeys(new Recording(maze, rightWall), ticks),
    },
  ];
}

function drive(recording: Recording, ticks: number): Recording {
  while (recording.run.tick < ticks) recording.step();
  return recording;
}

function pressKeys(recording: Recording, ticks: number): Recording {
  const keys = ["forward", "left 90", "reverse", "right 90", "forward", "stop"] as const;
  recording.addInput({ do: "driver", driver: "me" });
  for (let at = 0; at * PRESS_INTERVAL < ticks; at++) {
    recording.addInput({ do: "command", command: { action: keys[at % keys.length] ?? "stop" } });
    drive(recording, Math.min(ticks, (at + 1) * PRESS_INTERVAL));
  }
  return recording;
}
