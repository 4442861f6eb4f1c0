/**
 * Entry of a viewer's worker: the connection to the relay and the drawing of the stage, so that the
 * page is idle while the robot moves. A thin shell; the displayed state is in `watch-mirror.ts`.
 */
import { WatchConnection } from "@corridor/client/watch";
import { readMaze } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import type { Frame } from "../../stage/drawing/frame.ts";
import { StagePainter } from "../../stage/stage-painter.ts";
import type { FromWatcher, ToWatcher, WatchedRobot } from "../protocol/watch-messages.ts";
import { MarkedCells } from "../marks/marked-cells.ts";
import { WatchMirror } from "./watch-mirror.ts";

/** Milliseconds between two updates of the page's numbers. */
const NUMBERS_MS = 250;

/** By then the display has reached the newest snapshot. */
const REST_MS = 500;

const worker = self as unknown as DedicatedWorkerGlobalScope;
const post = (message: FromWatcher): void => worker.postMessage(message);
const now = (): number => performance.now();

let connection: WatchConnection | null = null;
let sent: Snapshot | null = null;
let sentAt = Number.NEGATIVE_INFINITY;
let sending: ReturnType<typeof setTimeout> | undefined;
let resting: ReturnType<typeof setTimeout> | undefined;

const mirror = new WatchMirror(now);
const marks = new MarkedCells(() => {
  if (newest !== null) paint({ ...newest, corners: [], bumps: [], trailReset: false });
});
let newest: Frame | null = null;
let hasMarks = false;
const painter = new StagePainter({
  post: (message) => {
    if (message.type === "picture" || message.type === "stage-scroll-to") post(message);
  },
  requestFrame: (paint) => requestAnimationFrame(paint),
  cancelFrame: (request) => cancelAnimationFrame(request),
  catchUp: draw,
  loadFont: async (name, address) => {
    const font = new FontFace(name, `url("${address}")`, { weight: "100 900" });
    worker.fonts.add(await font.load());
  },
});

worker.onmessage = ({ data }: MessageEvent<ToWatcher>) => {
  if (data.type === "watch") return watch(data.robot);
  if (data.type === "watch-again") return connection?.open();
  if (data.type === "hide-marks") return marks.hide(data.isHidden);
  return painter.handle(data);
};

function watch(robot: WatchedRobot | null): void {
  connection?.close();
  connection = null;
  marks.clear();
  hasMarks = false;
  if (robot === null) return;
  const { id, key } = robot;
  connection = new WatchConnection({
    origin: worker.location.origin,
    id,
    key,
    onSnapshot: (snapshot) => {
      mirror.add(snapshot);
      draw();
      // If the page draws by itself, no frame requests the next one: the last step is made here.
      clearTimeout(resting);
      resting = setTimeout(draw, REST_MS);
      send(snapshot);
    },
    onMarks: (received) => {
      marks.add(received);
      if (hasMarks || received.cells.length === 0) return;
      hasMarks = true;
      post({ type: "watch-marks" });
    },
    onMaze: (text) => {
      const read = text === null ? null : readMaze(text);
      post({ type: "watch-maze", maze: read?.ok === true ? read.value : null });
    },
    onStatus: (status) => post({ type: "watch-status", status }),
  });
}

/** While the robot moves, each frame requests the next one. */
function draw(): void {
  const frame = mirror.frame();
  if (frame !== null) paint(frame);
}

function paint(frame: Frame): void {
  newest = frame;
  painter.add({ ...frame, marks: marks.shown });
}

function send(snapshot: Snapshot): void {
  clearTimeout(sending);
  const waitMs = sentAt + NUMBERS_MS - now();
  if (sent === null || hasChanged(sent, snapshot) || waitMs <= 0) {
    sent = snapshot;
    sentAt = now();
    return post({ type: "watch-snapshot", snapshot });
  }
  sending = setTimeout(() => send(snapshot), waitMs);
}

function hasChanged(before: Snapshot, after: Snapshot): boolean {
  return (
    before.state !== after.state ||
    before.driver !== after.driver ||
    before.bumps !== after.bumps ||
    before.goalReached !== after.goalReached
  );
}
