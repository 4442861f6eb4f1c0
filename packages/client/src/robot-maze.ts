/** The maze that a robot is in, as its host publishes it. */
import { problemSchema, readJson } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import type { Platform } from "./platform.ts";

/** A square of the maze, 100 cm wide, counted from 0 at the top left. */
export interface MazeCell {
  /** from the left */
  column: number;
  /** from the top */
  row: number;
}

/** The maze of a robot. */
export interface RobotMaze {
  /** its title */
  name: string;
  /** one text for each row, from the top: `#` is a block, `.` is open */
  blocks: readonly string[];
  /** where the robot starts, and where it faces */
  start: MazeCell & { heading: "north" | "east" | "south" | "west" };
  /** the squares that are goals */
  goals: readonly MazeCell[];
}

/** Pause before a maze is requested again that the host could not give. */
const AGAIN_MS = 1_000;
const MAX_PROBLEM = 4_096;

export interface MazeRequest {
  platform: Platform;
  /** where the robot's calls begin */
  api: string;
  key: string;
  /** ms for which the host may be silent */
  answerMs: number;
}

/** @throws ClientError no-maze, no-robot, not-authorised or timeout */
export async function readMaze({ platform, api, key, answerMs }: MazeRequest): Promise<RobotMaze> {
  const { ask, clock } = platform;
  const end = clock.now() + answerMs;
  while (ask !== undefined && clock.now() < end) {
    const asked = ask({ method: "GET", url: `${api}/maze`, key, body: null });
    const cancelTimer = clock.after(end - clock.now(), () => asked.cancel());
    const answer = await asked.answer.catch(() => null);
    cancelTimer();
    if (answer?.status === 200) return mazeOf(answer.body);
    if (answer !== null && answer.status < 500 && answer.status !== 429) throw refusal(answer);
    await new Promise<void>((resolve) => clock.after(AGAIN_MS, resolve));
  }
  const hint = "Check the network, and that the address is where the robot is.";
  throw new ClientError("timeout", "The robot's host does not give the maze", hint);
}

function mazeOf(body: string): RobotMaze {
  try {
    const { name, blocks, start, goals } = JSON.parse(body) as RobotMaze;
    const isMaze = Array.isArray(blocks) && Array.isArray(goals) && Number.isInteger(start.column);
    if (isMaze) return { name, blocks, start, goals };
  } catch {
    // No JSON, or none of a maze.
  }
  const hint = "Copy the whole address again; a network with a sign-in page wants that done first.";
  throw new ClientError("bad-address", "Something else than a robot's host answers", hint);
}

function refusal({ status, body }: { status: number; body: string }): ClientError {
  const problem = readJson(problemSchema, body, MAX_PROBLEM);
  const hint = problem.ok ? problem.value.detail : `It answered with status ${status}.`;
  if (problem.ok && problem.value.type === "/problems/no-maze") {
    return new ClientError("no-maze", "The maze of this robot is not known", hint);
  }
  if (status === 401 || status === 403) {
    return new ClientError("not-authorised", "The robot does not take this key", hint);
  }
  if (status === 404) {
    return new ClientError("no-robot", "There is no robot with this address", hint);
  }
  return new ClientError("refused", "The robot's host does not give the maze", hint);
}
