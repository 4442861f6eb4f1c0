/** Tool `look`: the maze as text with the robot, and as a picture on request. */
import { readMaze, type MazeDocument } from "@corridor/maze";
import { RefusedError, type RobotPort } from "@corridor/protocol";
import { lookArguments, lookResult } from "./arguments.ts";
import { base64Of } from "./base64.ts";
import { cellOf, drawMaze, LEGEND, type RobotCell } from "./maze-drawing.ts";
import { paintMaze } from "./maze-picture.ts";
import { readArguments, textResult, type Tool } from "./tool.ts";

export const lookTool: Tool = {
  name: "look",
  description:
    "Shows the maze from above, one character a cell, with the robot, the start and the goals. With picture: also as a PNG.",
  input: lookArguments,
  output: lookResult,
  drives: false,
  async run({ port }, args) {
    const { picture = false } = readArguments(lookArguments, args);
    const maze = await mazeOf(port);
    const robot = port.newest === null ? null : cellOf(port.newest.pose);
    const result = textResult(describe(maze, robot), structureOf(maze, robot));
    if (picture) {
      const data = base64Of(paintMaze(maze, port.newest?.pose ?? null));
      result.content.push({ type: "image", data, mimeType: "image/png" });
    }
    return result;
  },
};

/** @throws RefusedError as `readMaze` of the port, or no-maze if the robot's maze is unknown */
async function mazeOf(port: RobotPort): Promise<MazeDocument> {
  const { text } = await port.readMaze();
  const maze = readMaze(text);
  if (maze.ok) return maze.value;
  throw new RefusedError({
    type: "/problems/no-maze",
    title: "Maze not found",
    status: 404,
    detail: "The maze of this robot has a format that this version does not read. Use sense.",
    errors: maze.problems,
  });
}

function describe(maze: MazeDocument, robot: RobotCell | null): string {
  const { start, goals } = maze;
  const goalCells = goals.map(({ column, row }) => `(${column}, ${row})`).join(", ");
  return [
    drawMaze(maze, robot),
    LEGEND,
    "Cells are (column, row) from (0, 0) at the top left; a cell is 100 x 100 cm.",
    robot === null
      ? "The robot has not reported yet."
      : `Robot: cell (${robot.column}, ${robot.row}), heading ${Math.round(robot.heading)}.`,
    `Start: cell (${start.column}, ${start.row}), heading ${start.heading}.`,
    goals.length === 0 ? "The maze has no goal." : `Goals: ${goalCells}.`,
  ].join("\n");
}

function structureOf(maze: MazeDocument, robot: RobotCell | null): Record<string, unknown> {
  const { name, blocks, start, goals } = maze;
  return {
    name,
    columns: blocks[0]?.length ?? 0,
    rows: blocks.length,
    blocks,
    start,
    goals,
    robot,
  };
}
