import { problemSchema, readJson } from "@corridor/protocol";
import { requestApi, type ApiOptions } from "./api-request.ts";
import { ClientError } from "./client-error.ts";

/** A square of the maze, 100 cm wide. */
export interface MazeCell {
  /** from the left, from 0 */
  column: number;
  /** from the top, from 0 */
  row: number;
}

/** The maze of a robot. */
export interface RobotMaze {
  /** its title */
  name: string;
  /** one string per row, from the top: `#` is a block, `.` is open */
  blocks: readonly string[];
  /** where the robot starts, and its direction */
  start: MazeCell & { heading: "north" | "east" | "south" | "west" };
  /** the squares that are goals */
  goals: readonly MazeCell[];
}

const MAX_PROBLEM = 4_096;

/**
 * Requests the maze of a robot.
 * @throws ClientError no-maze, no-robot, not-authorised or timeout
 */
export async function readMaze(options: ApiOptions): Promise<RobotMaze> {
  const response = await requestApi(options, "GET", "/maze").response;
  if (response?.status === 200) return mazeOf(response.body);
  if (response !== null) throw errorOf(response);
  const hint = "Check the network and the robot's address.";
  throw new ClientError("timeout", "The robot's host did not send the maze", hint);
}

function mazeOf(body: string): RobotMaze {
  try {
    const { name, blocks, start, goals } = JSON.parse(body) as RobotMaze;
    const isMaze = Array.isArray(blocks) && Array.isArray(goals) && Number.isInteger(start.column);
    if (isMaze) return { name, blocks, start, goals };
  } catch {
    // Not JSON, or not a maze.
  }
  const hint = "Copy the whole address again. If the network has a sign-in page, sign in first.";
  throw new ClientError("bad-address", "The response does not come from a robot's host", hint);
}

function errorOf({ status, body }: { status: number; body: string }): ClientError {
  const problem = readJson(problemSchema, body, MAX_PROBLEM);
  const hint = problem.ok ? problem.value.detail : `The response has the status ${status}.`;
  if (problem.ok && problem.value.type === "/problems/no-maze") {
    return new ClientError("no-maze", "The maze of this robot is unknown", hint);
  }
  if (status === 401 || status === 403) {
    return new ClientError("not-authorised", "The robot rejects this key", hint);
  }
  if (status === 404) {
    return new ClientError("no-robot", "The robot was not found", hint);
  }
  return new ClientError("refused", "The robot's host refused to send the maze", hint);
}
