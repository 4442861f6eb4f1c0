/**
 * Follow the right-hand wall through a maze.
 *
 * Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
 * be copied, a code gets one: see the README of the examples):
 *
 *     npx node examples/javascript/right-wall.ts "http://localhost:8080/r/ID#KEY"
 *
 * The robot keeps its right hand on the wall: where there is an opening on the right it goes in,
 * else straight on, else it turns left.
 */
import { parseArgs } from "node:util";
import { RobotClient } from "@corridor/client";

/** One cell of the maze is 100 cm wide. */
const CELL = 100;
/** Farther than this, and there is no wall in the next cell. */
const OPEN = 60;

/** Goes on until the goal is reached, or so many different cells are visited. */
async function followRightWall(
  robot: RobotClient,
  untilCells: number | null,
  mostMoves: number,
): Promise<void> {
  const visited = new Set<string>();
  for (let moves = 0; moves <= mostMoves;) {
    const { pose, sensors, goalReached } = await robot.snapshot();
    visited.add(`${Math.floor(pose.x / CELL)},${Math.floor(pose.y / CELL)}`);
    if (untilCells === null && goalReached) {
      return console.log(`Goal reached after ${moves} moves.`);
    }
    if (untilCells !== null && visited.size >= untilCells) {
      return console.log(`${visited.size} cells visited after ${moves} moves.`);
    }

    if (sensors.right > OPEN) {
      console.log(`${Math.round(sensors.right)} cm on the right: turn right and go`);
      await robot.right90();
      await robot.move(CELL);
      moves += 1;
    } else if (sensors.front > OPEN) {
      console.log(`${Math.round(sensors.front)} cm ahead: go on`);
      await robot.move(CELL);
      moves += 1;
    } else {
      console.log("Wall ahead and on the right: turn left");
      await robot.left90();
    }
  }
  throw new Error(`Not there after ${mostMoves} moves; ${visited.size} cells visited.`);
}

/** A whole number of an option; null when it was not given. */
function wholeNumber(text: string | undefined): number | null {
  if (text === undefined) return null;
  const number = Number(text);
  if (!Number.isSafeInteger(number) || number < 1) throw new Error(`${text} is no whole number.`);
  return number;
}

try {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { "until-cells": { type: "string" }, moves: { type: "string" } },
  });
  const robot = await RobotClient.connect(positionals[0] ?? "", { name: "Right wall" });
  try {
    const untilCells = wholeNumber(values["until-cells"]);
    await followRightWall(robot, untilCells, wholeNumber(values.moves) ?? 2000);
  } finally {
    robot.close();
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
