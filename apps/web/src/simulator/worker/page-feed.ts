/**
 * Sends the page what has changed in the run: truncations and events at once, and frames for its
 * panels at a low rate.
 */
import type { MazeDocument } from "@corridor/maze";
import type { FromWorker } from "../protocol/worker-messages.ts";
import type { Frame } from "../../stage/drawing/frame.ts";
import { FrameThrottle } from "./frame-throttle.ts";
import type { RunUpdate, RunUpdates } from "./run-updates.ts";

export interface PageFeedPorts {
  post: (message: FromWorker) => void;
  /** draws a frame on the stage */
  draw: (frame: Frame) => void;
  /** monotonic milliseconds */
  now: () => number;
}

export class PageFeed {
  readonly #ports: PageFeedPorts;
  readonly #throttle: FrameThrottle;
  /** the maze that the page displays; null: the newest one */
  #pastMaze: MazeDocument | null = null;

  constructor(ports: PageFeedPorts) {
    this.#ports = ports;
    this.#throttle = new FrameThrottle(ports.now);
  }

  /** @param update the newest update; null if the run has not changed since the last call */
  send(updates: RunUpdates, update: RunUpdate | null): void {
    const { post, draw } = this.#ports;
    if (update !== null) {
      const { frame, truncatedAfter } = update;
      if (truncatedAfter !== null) post({ type: "truncated", after: truncatedAfter });
      draw(frame);
      this.#throttle.add(frame);
    }
    const frame = this.#throttle.take();
    if (frame !== null) this.#sendFrame(updates, frame);
    for (const event of update?.events ?? []) post({ type: "event", event });
  }

  #sendFrame(updates: RunUpdates, frame: Frame): void {
    const { post } = this.#ports;
    const { pastMaze } = updates;
    if (pastMaze !== this.#pastMaze) post({ type: "past-maze", maze: pastMaze });
    this.#pastMaze = pastMaze;
    const corners = Float64Array.from(frame.corners);
    post({ type: "frame", frame: { ...frame, corners }, timeline: updates.takeTimeline() });
  }
}
