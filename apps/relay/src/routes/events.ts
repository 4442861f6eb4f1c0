/** Server-sent events: snapshots and command states for clients that cannot open a WebSocket. */
import { Router } from "express";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { readBearer, readClient } from "./reading.ts";

export function eventRoutes(hub: SessionHub, clock: Clock): Router {
  const router = Router();
  router
    .route("/robots/:id/events")
    .get(async (request, response) => {
      const { session, key } = await hub.authorise(request.params.id, readBearer(request), [
        "drive",
      ]);
      session.heard(readClient(request));
      const send = (event: string, data: unknown): void => {
        response.write(`event: ${event}\ndata: ${JSON.stringify(data)}\n\n`);
      };
      const leave = session.join(key, {
        snapshot: (snapshot) => send("snapshot", snapshot),
        state: (record) => send("state", record),
        over: () => response.end(),
        waitingBytes: () => response.writableLength,
      });
      response.writeHead(200, {
        "Content-Type": "text/event-stream",
        "Cache-Control": "no-store",
        // nginx would keep events back to fill its buffer
        "X-Accel-Buffering": "no",
      });
      if (session.newest === null) response.write(": waiting for the robot\n\n");
      else send("snapshot", session.newest);
      let cancelTimer: () => void;
      const beat = (): void => {
        response.write(": still here\n\n");
        cancelTimer = clock.after(limits.heartbeatMs, beat);
      };
      cancelTimer = clock.after(limits.heartbeatMs, beat);
      response.once("close", () => {
        cancelTimer();
        leave();
      });
    })
    .all(methodNotAllowed("GET"));
  return router;
}
