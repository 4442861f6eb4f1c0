/** Draws what is open as an SVG picture. */
import type { Services } from "../../model/services.ts";
import { faceOf } from "../../stage/layers/robot.ts";
import { mazeSvg, type PictureScene } from "../../stage/svg/maze-svg.ts";
import { lightPalette, type Picture } from "../../stage/svg/picture.ts";

export interface PictureChoice {
  withRun: boolean;
  hasRulers: boolean;
}

/** Draws the maze of the displayed tick. */
export function drawPicture(
  { workspace, run, runTrace }: Pick<Services, "workspace" | "run" | "runTrace">,
  words: Pick<PictureScene, "startWord" | "goalWord">,
  { withRun, hasRulers }: PictureChoice,
): Picture {
  const shown = withRun ? runTrace.take() : null;
  const { text, width, height } = mazeSvg({
    ...words,
    maze: run.getState().pastMaze ?? workspace.getState().maze,
    palette: lightPalette(),
    hasRulers,
    run:
      shown === null ? null : { ...shown, pose: shown.snapshot.pose, face: faceOf(shown.snapshot) },
  });
  return { svg: text, width, height };
}
