/**
 * Follow the right-hand wall through a maze.
 *
 * Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
 * copy the address, use a pairing code: see the README of the examples.
 *
 *     npx node examples/javascript/right-wall.ts "http://localhost:8080/r/ID#KEY"
 *
 * The robot follows the wall on its right: it turns right at an opening, else drives straight ahead,
 * else turns left.
 */
import { parseArgs } from "node:util";
import { RobotClient } from "@corridor/client";

/** One cell of the maze is 100 cm wide. */
const CELL = 100;
/** A larger distance in cm means that the next cell is open. */
const OPEN = 60;

/** Drives until the goal is reached, or until `untilCells` different cells are visited. */
async function followRightWall(
  robot: RobotClient,
  untilCells: number | null,
  maxMoves: number,
): Promise<void> {
  const visited = new Set<string>();
  for (let moves = 0; moves <= maxMoves;) {
    const { pose, sensors, goalReached } = await robot.snapshot();
    visited.add(`${Math.floor(pose.x / CELL)},${Math.floor(pose.y / CELL)}`);
    if (untilCells === null && goalReached) {
      return console.log(`Goal reached after ${moves} moves.`);
    }
    if (untilCells !== null && visited.size >= untilCells) {
      return console.log(`${visited.size} cells visited after ${moves} moves.`);
    }

    if (sensors.right > OPEN) {
      console.log(`${Math.round(sensors.right)} cm on the right: turn right and drive`);
      await robot.right90();
      await robot.move(CELL);
      moves += 1;
    } else if (sensors.front > OPEN) {
      console.log(`${Math.round(sensors.front)} cm ahead: drive on`);
      await robot.move(CELL);
      moves += 1;
    } else {
      console.log("Wall ahead and on the right: turn left");
      await robot.left90();
    }
  }
  throw new Error(`Goal not reached after ${maxMoves} moves; ${visited.size} cells visited.`);
}

/** Parses the value of an option. @returns null if the option is missing */
function positiveInteger(text: string | undefined): number | null {
  if (text === undefined) return null;
  const number = Number(text);
  if (!Number.isSafeInteger(number) || number < 1) {
    throw new Error(`Expected a whole number of at least 1, found ${text}.`);
  }
  return number;
}

try {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { "until-cells": { type: "string" }, moves: { type: "string" } },
  });
  const robot = await RobotClient.connect(positionals[0] ?? "", { name: "Right wall" });
  try {
    const untilCells = positiveInteger(values["until-cells"]);
    await followRightWall(robot, untilCells, positiveInteger(values.moves) ?? 2000);
  } finally {
    robot.close();
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
