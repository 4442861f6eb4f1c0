/**
 * The picture of a student who finished all missions: the robot's trail, the date and the counts.
 * It contains no name.
 */
import type { PlaceWords } from "../../stage/layers/places.ts";
import type { Palette } from "../../stage/drawing/palette.ts";
import type { SolvedTrail } from "../../simulator/protocol/bonus-request.ts";
import { mazeSvg } from "../../stage/svg/maze-svg.ts";
import type { Picture } from "../../stage/svg/picture.ts";
import { escapeText, SvgPen } from "../../stage/svg/svg-pen.ts";

export interface FinishScene extends PlaceWords {
  trail: SolvedTrail;
  palette: Palette;
  /** text direction of the student's language */
  dir: "ltr" | "rtl";
  title: string;
  date: string;
  counts: string;
  /** text alternative of the whole picture */
  description: string;
}

const WIDTH = 800;
const PADDING = 40;
const MAZE_HEIGHT = 400;
const FONT = "Inter, system-ui, sans-serif";

export function finishPicture(scene: FinishScene): Picture {
  const { trail, palette, dir, title, date, counts, description } = scene;
  const drawn = mazeSvg({
    ...scene,
    maze: trail.maze,
    run: { pose: trail.pose, face: "solved", points: trail.points, bumps: [] },
    hasRulers: false,
  });
  const scale = Math.min((WIDTH - 2 * PADDING) / drawn.width, MAZE_HEIGHT / drawn.height);
  const width = drawn.width * scale;
  const mazeHeight = drawn.height * scale;
  const mazeTop = 140;
  const height = Math.round(mazeTop + mazeHeight + 90);

  const pen = new SvgPen();
  pen.fillStyle = palette.surface;
  pen.fillRect(0, 0, WIDTH, height);
  pen.strokeStyle = palette.wallEdge;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.roundRect(12, 12, WIDTH - 24, height - 24, 16);
  pen.stroke();
  pen.textAlign = "center";
  pen.fillStyle = palette.ink;
  const room = WIDTH - 2 * PADDING;
  pen.font = `600 40px ${FONT}`;
  pen.fillText(title, WIDTH / 2, 78, room);
  pen.font = `450 24px ${FONT}`;
  pen.fillText(date, WIDTH / 2, 116, room);
  pen.fillText(counts, WIDTH / 2, height - 48, room);

  const maze = drawn.text
    .replace(/<title>.*?<\/title>\n/s, "")
    .replace(
      /^<svg [^>]*>/,
      `<svg x="${Math.round((WIDTH - width) / 2)}" y="${mazeTop}" width="${Math.round(width)}" ` +
        `height="${Math.round(mazeHeight)}" viewBox="0 0 ${drawn.width} ${drawn.height}">`,
    );
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${height}" ` +
    `viewBox="0 0 ${WIDTH} ${height}" role="img" aria-label="${escapeText(description)}">\n` +
    `<title>${escapeText(title)}</title>\n<desc>${escapeText(description)}</desc>\n` +
    `<g direction="${dir}">\n${pen.elements()}\n</g>\n${maze}</svg>\n`;
  return { svg, width: WIDTH, height };
}
