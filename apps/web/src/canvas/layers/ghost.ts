/** What a press would do, shown before it happens. */
import type { Cell, Start } from "@corridor/maze";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import type { Viewport } from "../viewport.ts";
import { cellBox, drawGoal, drawStart, type PlaceWords } from "./places.ts";

/** The result of the tool at hand on the square under the pointer. */
export type Ghost =
  | { kind: "block" | "open" | "goal" | "no-goal" | "refused"; cell: Cell }
  | { kind: "start"; start: Start };

/** Draws the ghost over the maze, half transparent. */
export function drawGhost(
  context: Brush,
  viewport: Viewport,
  palette: Palette,
  ghost: Ghost,
  words: PlaceWords,
  dirt: Dirt,
): void {
  const box = cellBox(viewport, ghost.kind === "start" ? ghost.start : ghost.cell);
  dirt.add(box.x, box.y, box.width, box.height);
  context.save();
  context.globalAlpha = 0.6;
  switch (ghost.kind) {
    case "block":
      context.fillStyle = palette.wall;
      context.fillRect(box.x, box.y, box.width, box.height);
      break;
    case "open":
    case "no-goal":
      context.fillStyle = palette.floor;
      context.fillRect(box.x, box.y, box.width, box.height);
      break;
    case "goal":
      drawGoal(context, box, palette, words.goalWord);
      break;
    case "start":
      drawStart(context, box, palette, ghost.start, words.startWord);
      break;
    case "refused":
      break;
  }
  context.globalAlpha = 1;
  context.strokeStyle = palette.ink3;
  context.lineWidth = 1.5;
  context.setLineDash([4, 3]);
  context.strokeRect(box.x + 1, box.y + 1, box.width - 2, box.height - 2);
  context.setLineDash([]);
  if (ghost.kind === "refused") {
    const inset = box.width * 0.35;
    context.beginPath();
    context.moveTo(box.x + inset, box.y + inset);
    context.lineTo(box.x + box.width - inset, box.y + box.height - inset);
    context.moveTo(box.x + box.width - inset, box.y + inset);
    context.lineTo(box.x + inset, box.y + box.height - inset);
    context.stroke();
  }
  context.restore();
}
