/** Preview of an edit, drawn before the pointer is pressed. */
import type { Cell, Start } from "@corridor/maze";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import type { Viewport } from "../drawing/viewport.ts";
import { cellBox, drawGoal, drawStart, type PlaceWords } from "./places.ts";

/** Result of the current tool on the cell under the pointer. */
export type EditPreview =
  | { kind: "block" | "open" | "goal" | "no-goal" | "refused"; cell: Cell }
  | { kind: "start"; start: Start };

/** Draws the preview over the maze, half transparent. */
export function drawPreview(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  preview: EditPreview,
  words: PlaceWords,
  dirty: DirtyRects,
): void {
  const box = cellBox(viewport, preview.kind === "start" ? preview.start : preview.cell);
  dirty.add(box.x, box.y, box.width, box.height);
  context.save();
  context.globalAlpha = 0.6;
  switch (preview.kind) {
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
      drawStart(context, box, palette, preview.start, words.startWord);
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
  if (preview.kind === "refused") {
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
