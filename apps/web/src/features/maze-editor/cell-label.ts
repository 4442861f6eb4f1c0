/** The label of a square for screen readers: "row 3, column 7, open, robot here, facing up". */
import { isBlock, type Cell, type HeadingName, type MazeDocument } from "@corridor/maze";
import type { TFunction } from "i18next";
import { joinList } from "../../text/joined.ts";
import type { Facing } from "../../stage/page/robot-place.ts";

const startFacing: Record<HeadingName, Facing> = {
  north: "up",
  east: "right",
  south: "down",
  west: "left",
};

/** @param robotFacing the direction that the robot faces if it stands on this square, else null */
export function cellLabel(
  t: TFunction,
  maze: MazeDocument,
  { column, row }: Cell,
  robotFacing: Facing | null,
): string {
  const { start, goals } = maze;
  const isHere = (other: Cell): boolean => other.column === column && other.row === row;
  const parts = [
    t("stage.cell.at", { row: row + 1, column: column + 1 }),
    isBlock(maze, column, row) ? t("stage.cell.block") : t("stage.cell.open"),
  ];
  if (isHere(start)) {
    parts.push(t("stage.cell.start", { facing: t(`stage.facing.${startFacing[start.heading]}`) }));
  }
  if (goals.some(isHere)) parts.push(t("stage.cell.goal"));
  if (robotFacing !== null) {
    parts.push(t("stage.cell.robot", { facing: t(`stage.facing.${robotFacing}`) }));
  }
  return joinList(t, parts);
}
