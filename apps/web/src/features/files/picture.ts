/** Draws what is open as an SVG picture, and converts it to a PNG. */
import { faceOf } from "../../stage/layers/robot.ts";
import { readPalette, type Palette } from "../../stage/drawing/palette.ts";
import type { Services } from "../../shell/services.ts";
import { mazeSvg, type PictureScene } from "../../stage/svg/maze-svg.ts";

/** PNG pixels for one pixel of the picture, and the longest side that every browser can draw. */
const PNG_SCALE = 2;
const MAX_PNG_SIDE = 4096;

export interface Picture {
  svg: string;
  width: number;
  height: number;
}

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

/**
 * Converts the picture to a PNG at twice its size, or less if a side would exceed `MAX_PNG_SIDE`.
 * @throws Error if the browser cannot draw it
 */
export async function pngOf({ svg, width, height }: Picture): Promise<Blob> {
  const scale = Math.min(PNG_SCALE, MAX_PNG_SIDE / Math.max(width, height));
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image(Math.round(width * scale), Math.round(height * scale));
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
    if (blob === null) throw new Error("the canvas gave no picture");
    return blob;
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** The colours of the light theme, whatever the theme of the page: pictures are for paper. */
export function lightPalette(): Palette {
  const probe = document.createElement("div");
  probe.dataset["theme"] = "light";
  probe.hidden = true;
  document.body.append(probe);
  const style = getComputedStyle(probe);
  const palette = readPalette((property) => style.getPropertyValue(property));
  probe.remove();
  return palette;
}
