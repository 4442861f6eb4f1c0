/** A maze for paper: dark lines on white in every theme, one unit of the drawing for each square. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { blocksPath, edgesPath } from "../maze-outline.ts";

const angles = { north: 0, east: 90, south: 180, west: 270 } as const;

/** Radius of the robot in squares: 25 of 100 cm. */
const ROBOT = 0.25;

interface PaperMazeProps {
  maze: MazeDocument;
  /** width of its lines, in squares */
  line: number;
}

export function PaperMaze({ maze, line }: PaperMazeProps) {
  const { columns, rows } = sizeOf(maze);
  const { column, row, heading } = maze.start;
  let squares = "";
  for (let x = 1; x < columns; x++) squares += `M${x} 0v${rows}`;
  for (let y = 1; y < rows; y++) squares += `M0 ${y}h${columns}`;
  return (
    <g fill="none" stroke="#111" strokeWidth={line} strokeLinecap="square">
      <path d={blocksPath(maze)} fill="#c4cbd3" stroke="none" />
      <path d={squares} stroke="#9aa3ad" strokeWidth={line / 3} />
      <path d={edgesPath(maze)} />
      <rect width={columns} height={rows} />
      {maze.goals.map((goal) => (
        // A flag: printers may have no colours.
        <path
          key={`${goal.column},${goal.row}`}
          transform={`translate(${goal.column} ${goal.row})`}
          d="M.35 .8v-.6l.4 .17l-.4 .17"
          fill="#111"
          strokeLinejoin="round"
        />
      ))}
      <g transform={`translate(${column + 0.5} ${row + 0.5}) rotate(${angles[heading]})`}>
        <circle r={ROBOT} fill="#fff" />
        <path d="M0 .12v-.24m-.09 .09l.09 -.09l.09 .09" />
      </g>
    </g>
  );
}
