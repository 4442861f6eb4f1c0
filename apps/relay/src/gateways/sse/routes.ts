/**
 * Snapshots and command states for clients without WebSockets: as server-sent events, or by long
 * polling. Both resume after the last received event.
 */
import { sinceOf } from "@corridor/protocol";
import { Router, type Response } from "express";
import type { Clock } from "../../platform/time/clock.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { OverReason, ReaderSink } from "../../robots/readers/feed.ts";
import type { RobotRegistry } from "../../robots/registry.ts";
import type { JoinedReader } from "../../robots/readers/readers.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { onClose } from "../../platform/http/on-close.ts";
import { authoriseScript, callerWaitOf, readEvents } from "../requests/script-requests.ts";

const HEADERS = {
  "Content-Type": "text/event-stream",
  "Cache-Control": "no-store",
  // nginx would otherwise buffer events
  "X-Accel-Buffering": "no",
};

export function eventRoutes(registry: RobotRegistry, clock: Clock): Router {
  const router = Router();
  router
    .route("/robots/:id/events")
    .get(async (request, response) => {
      const { robot, caller, markAnswered } = await authoriseScript(
        registry,
        request,
        response,
        "read",
      );
      const { since, after, wait } = readEvents(request);
      if (wait !== undefined) {
        const page = await robot.readers.nextEvents(
          { since, after },
          callerWaitOf(response, wait, caller),
        );
        return void response.json(page);
      }
      // A script that only reads does not count as active while its stream is open.
      markAnswered();
      streamTo(response, clock, (sink) => robot.readers.join(caller, sink, since ?? null));
    })
    .all(methodNotAllowed("GET"));
  return router;
}

/** @param join subscribes the stream to the robot */
function streamTo(
  response: Response,
  clock: Clock,
  join: (sink: ReaderSink) => JoinedReader,
): void {
  let cancelTimer = (): void => undefined;
  const destroy = (): void => void response.destroy();
  const over = (reason: OverReason): void => {
    cancelTimer();
    if (reason === "tooSlow") return destroy();
    response.end();
    // A client that does not read never receives the end.
    cancelTimer = clock.after(limits.closingMs, destroy);
  };
  let sentBytes = 0;
  const write = (text: string): void => {
    if (response.writableEnded || response.destroyed) return;
    if (!response.headersSent) response.writeHead(200, HEADERS);
    sentBytes += text.length;
    response.write(text);
  };
  /** @param id resume position, if it has changed */
  const send = (event: string, data: unknown, id?: string): void =>
    write(
      `${id === undefined ? "" : `id: ${id}\n`}event: ${event}\ndata: ${JSON.stringify(data)}\n\n`,
    );
  let stream = "";
  const reader = join({
    transport: "events",
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
  // A connection error also emits "close". Without this handler it would end the process.
  response.on("error", destroy);
  const sendHeartbeat = (): void => {
    if (response.writableLength > limits.stuckReaderBytes) return over("tooSlow");
    write(": still here\n\n");
    cancelTimer = clock.after(limits.heartbeatMs, sendHeartbeat);
  };
  cancelTimer = clock.after(limits.heartbeatMs, sendHeartbeat);
  onClose(response, () => {
    cancelTimer();
    reader.leave();
  });
}
