/** What an hour of running can be: by a program that decides now and then, by one that decides on every tick, by a hand. */
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { Recording } from "@corridor/recording";

export const HOUR = 216_000;
const SIDE = 33;
/** Ticks from one press to the next: faster than any hand, and as much as the file of an hour's run may hold. */
const PRESS_EVERY = 3;

export interface Hour {
  /** what drives */
  name: string;
  /** The first so many ticks of it. */
  record: (ticks: number) => Recording;
}

/** All drive in the same maze. */
export function hours(): Hour[] {
  const rightWall = programPresets.find(({ id }) => id === "right-wall")?.program;
  if (rightWall === undefined) throw new Error("no right-wall program among the presets");
  const chattering: ProgramDocument = {
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
      record: (ticks) => drive(new Recording(maze, chattering), ticks),
    },
    { name: "20 keys a second", record: (ticks) => press(new Recording(maze, rightWall), ticks) },
  ];
}

function drive(recording: Recording, ticks: number): Recording {
  while (recording.run.tick < ticks) recording.step();
  return recording;
}

function press(recording: Recording, ticks: number): Recording {
  const keys = ["forward", "left 90", "reverse", "right 90", "forward", "stop"] as const;
  recording.input({ do: "driver", driver: "me" });
  for (let at = 0; at * PRESS_EVERY < ticks; at++) {
    recording.input({ do: "command", command: { action: keys[at % keys.length] ?? "stop" } });
    drive(recording, Math.min(ticks, (at + 1) * PRESS_EVERY));
  }
  return recording;
}
