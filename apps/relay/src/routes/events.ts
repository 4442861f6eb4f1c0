/**
 * Snapshots and command states for clients that cannot open a WebSocket: as server-sent events, or one
 * answer at a time for whoever says how long it waits. Both go on where an earlier one ended.
 */
import { sinceOf } from "@corridor/protocol";
import { Router, type Response } from "express";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import type { OverReason, ReaderSink } from "../sessions/reader-feed.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import type { JoinedReader } from "../sessions/readers.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { hearScript } from "./hear-script.ts";
import { patienceOf, readEvents } from "./reading.ts";

const HEADERS = {
  "Content-Type": "text/event-stream",
  "Cache-Control": "no-store",
  // nginx would keep events back to fill its buffer
  "X-Accel-Buffering": "no",
};

export function eventRoutes(hub: SessionHub, clock: Clock): Router {
  const router = Router();
  router
    .route("/robots/:id/events")
    .get(async (request, response) => {
      const { session, key, answered } = await hearScript(hub, request, response, "read");
      const { since, after, wait } = readEvents(request);
      if (wait !== undefined) {
        const page = await session.readers.nextEvents(
          { since, after },
          patienceOf(response, wait, key),
        );
        return void response.json(page);
      }
      // Who only listens holds no motion, for as long as the stream may be open.
      answered();
      streamTo(response, clock, (sink) => session.readers.join(key, sink, since ?? null));
    })
    .all(methodNotAllowed("GET"));
  return router;
}

/** @param join lets the stream follow the robot */
function streamTo(
  response: Response,
  clock: Clock,
  join: (sink: ReaderSink) => JoinedReader,
): void {
  let cancelTimer = (): void => undefined;
  const cut = (): void => void response.destroy();
  const over = (reason: OverReason): void => {
    cancelTimer();
    if (reason === "tooSlow") return cut();
    response.end();
    // Who does not read never gets to the end.
    cancelTimer = clock.after(limits.goodbyeMs, cut);
  };
  let sentBytes = 0;
  const write = (text: string): void => {
    if (response.writableEnded || response.destroyed) return;
    if (!response.headersSent) response.writeHead(200, HEADERS);
    sentBytes += text.length;
    response.write(text);
  };
  /** @param id what a reader comes back with, if that has changed */
  const send = (event: string, data: unknown, id?: string): void =>
    write(
      `${id === undefined ? "" : `id: ${id}\n`}event: ${event}\ndata: ${JSON.stringify(data)}\n\n`,
    );
  let stream = "";
  const reader = join({
    door: "events",
    flow: {
      get sentBytes() {
        return sentBytes;
      },
      get takenBytes() {
        return sentBytes - response.writableLength;
      },
      isProof: false,
      ask: () => undefined,
    },
    began: (start) => {
      stream = start.stream;
      write(start.n === null ? ": hello\n\n" : `id: ${sinceOf(stream, start.n)}\n\n`);
      if (start.snapshot === null) write(": waiting for the robot\n\n");
      else send("snapshot", start.snapshot.value);
    },
    snapshot: ({ value }) => send("snapshot", value),
    state: (event) => send("state", event.record, sinceOf(stream, event.n)),
    gap: (gap) => send("gap", gap, sinceOf(stream, gap.n)),
    maze: (version) => send("maze", { version }),
    over,
  });
  // A line that breaks is told by "close" as well; unheard, the error would end the process.
  response.on("error", cut);
  response.once("close", () => {
    cancelTimer();
    reader.leave();
  });
  const beat = (): void => {
    if (response.writableLength > limits.stuckReaderBytes) return over("tooSlow");
    write(": still here\n\n");
    cancelTimer = clock.after(limits.heartbeatMs, beat);
  };
  cancelTimer = clock.after(limits.heartbeatMs, beat);
}
