/** `maze`: checks a contest maze, or converts a maze to another format. */
import { parseArgs } from "node:util";
import {
  checkContest,
  contestFormats,
  contestMazeOf,
  writeContestMaze,
  writeTextMaze,
  type ContestFormat,
  type ContestRefusal,
  type MazeDocument,
} from "@corridor/maze";
import { describeProblem } from "@corridor/protocol";
import { exitCodes, type Command } from "./command.ts";
import { InputError } from "./input-error.ts";
import { readFiles } from "./read-files.ts";

const formats = ["json", "text", ...contestFormats] as const;
type Format = (typeof formats)[number];

const HELP = `Usage: corridor maze FILE [--to json|text|map|num|maz]

Checks a maze of posts and walls, as contests of micromouse robots have them, and prints one line of
JSON. With --to, prints the maze in another format instead.

FILE is a maze in any format, which its content shows: a document or a drawing of the page, a drawing
with posts and walls (.map, .txt), a list of cells (.num) or a binary file (.maz). A contest maze
without a start starts at the bottom left, facing north. Without a goal, its goal is the centre.

Options:
  --to json  a document of Corridor
  --to text  a drawing with one character per cell
  --to map   a drawing with posts and walls
  --to num   a list of cells; the maze has the start and the goal of a contest
  --to maz   a binary file of 16 x 16 cells, as --to num
  --help     print this text

Result:
  columns, rows  size in cells between posts and walls
  start, goals   cells, from 0 0 at the bottom left
  solvable       whether a path leads from the start to a goal
  shortestPath   cells from the start to the nearest goal; null if no path leads to one
  wallFollower   whether a robot that follows a wall reaches a goal
  brokenRules    rules of contests that the maze breaks, with the number of cells, posts, walls or
                 entrances that break them, or null:
    outer-wall         the outer wall has a gap
    missing-posts      posts inside of the maze are missing
    unreachable-cells  no path leads to some cells
    start-walls        the start has this number of walls instead of three
    goal-entrances     the goal has this number of entrances instead of one
    centre-post        a wall touches the post in the middle of four goal cells
    bare-posts         no wall touches some other posts
    wall-follower      a robot that follows a wall reaches the goal

${exitCodes("success, even if the maze breaks rules", null)}`;

export const command: Command = {
  help: HELP,
  run: (args, { print, write }) => {
    const { file, to } = readArguments(args);
    for (const maze of readFiles({ mazes: [file], programs: [] }).mazes) {
      if (to === null) print([checkLine(maze, file)]);
      else write(converted(maze, to, file));
    }
    return 0;
  },
};

function readArguments(args: readonly string[]): { file: string; to: Format | null } {
  const { values, positionals } = parse(args);
  const [file] = positionals;
  const to = formats.find((format) => format === values.to) ?? null;
  const problems: string[] = [];
  if (positionals.length !== 1) {
    const found = positionals.length === 0 ? "nothing" : `${positionals.length} files`;
    problems.push(`FILE: found ${found}, expected one maze file`);
  }
  if (values.to !== undefined && to === null) {
    const found = JSON.stringify(values.to);
    problems.push(`--to: found ${found}, expected one of ${formats.join(", ")}`);
  }
  if (problems.length > 0 || file === undefined) throw new InputError(problems);
  return { file, to };
}

function parse(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      options: { to: { type: "string" } },
      allowPositionals: true,
      strict: true,
    });
  } catch (error) {
    const found = error instanceof Error ? error.message : "Invalid options";
    throw new InputError([`${found.replace(/\.?$/, ".")} The options are --to.`]);
  }
}

function checkLine(maze: MazeDocument, file: string): string {
  const contest = contestMazeOf(maze);
  if (!contest.ok) throw refused(contest.refusal, file);
  const { columns, rows, start, goals } = contest.value;
  const { shortestPath, broken, isFollowed } = checkContest(contest.value);
  return JSON.stringify({
    columns,
    rows,
    start: { ...start, heading: maze.start.heading },
    goals,
    solvable: shortestPath !== null,
    shortestPath,
    wallFollower: isFollowed,
    brokenRules: broken,
  });
}

function converted(maze: MazeDocument, to: Format, file: string): string | Uint8Array {
  if (to === "json") return `${JSON.stringify(maze, null, 2)}\n`;
  return to === "text" ? writeTextMaze(maze) : contestFile(maze, to, file);
}

function contestFile(maze: MazeDocument, to: ContestFormat, file: string): string | Uint8Array {
  const written = writeContestMaze(maze, to);
  if (!written.ok) throw refused(written.refusal, file);
  return written.value;
}

function refused({ problem }: ContestRefusal, file: string): InputError {
  return new InputError([`${file}: ${describeProblem(problem)}`]);
}
