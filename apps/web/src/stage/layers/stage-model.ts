/**
 * The stage model: everything that the stage shows besides the run. Plain data, sent to the worker.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { EditPreview } from "./edit-preview.ts";
import type { Measured } from "./measure.ts";
import type { PlaceWords } from "./places.ts";
import type { Palette } from "../drawing/palette.ts";
import type { Layout, Scroll } from "../drawing/viewport.ts";

/**
 * Everything that is drawn besides the robot. It is compared field by field, so an unchanged field
 * must stay the same object.
 */
export interface StageModel extends PlaceWords {
  layout: Layout;
  /** always belongs to this layout: one message changes both */
  scroll: Scroll;
  /** number of scroll requests from the painter that the page has handled */
  answers: number;
  /** device pixels per CSS pixel */
  pixelRatio: number;
  palette: Palette;
  maze: MazeDocument;
  program: ProgramDocument;
  showBeams: boolean;
  showTrail: boolean;
  showRulers: boolean;
  preview: EditPreview | null;
  measured: Measured | null;
  /** whether the user prefers reduced motion: no recoil, no hop */
  isCalm: boolean;
}

/** The fields that differ; null if none does. Without a previous model, the whole model. */
export function modelChanges(
  before: StageModel | null,
  model: StageModel,
): Partial<StageModel> | null {
  if (before === null) return model;
  const fields = (Object.keys(model) as (keyof StageModel)[]).filter(
    (field) => before[field] !== model[field],
  );
  if (fields.length === 0) return null;
  return Object.fromEntries(fields.map((field) => [field, model[field]]));
}
