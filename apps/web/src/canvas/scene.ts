/** What the stage shows besides the run: plain data, which crosses to the worker as it is. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Ghost } from "./layers/ghost.ts";
import type { Measured } from "./layers/measure.ts";
import type { PlaceWords } from "./layers/places.ts";
import type { Palette } from "./palette.ts";
import type { Layout, Scroll } from "./viewport.ts";

/** All that is drawn besides the robot; compared field by field, so an unchanged field stays the same object. */
export interface Scene extends PlaceWords {
  layout: Layout;
  /** always one of this layout: both change in one message, so neither is drawn with another's */
  scroll: Scroll;
  /** how many of the painter's requests to scroll the page has handled so far */
  answers: number;
  /** device pixels per CSS pixel */
  pixelRatio: number;
  palette: Palette;
  maze: MazeDocument;
  program: ProgramDocument;
  showBeams: boolean;
  showTrail: boolean;
  showRulers: boolean;
  ghost: Ghost | null;
  measured: Measured | null;
  /** whether the reader asked for less motion: no recoil, no hop */
  isCalm: boolean;
}

/** The fields that differ; null when none does. The whole scene where there was none before. */
export function sceneChanges(before: Scene | null, scene: Scene): Partial<Scene> | null {
  if (before === null) return scene;
  const fields = (Object.keys(scene) as (keyof Scene)[]).filter(
    (field) => before[field] !== scene[field],
  );
  if (fields.length === 0) return null;
  return Object.fromEntries(fields.map((field) => [field, scene[field]]));
}
