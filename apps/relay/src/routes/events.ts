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
      let cancelTimer = (): void => undefined;
      const cut = (): void => void response.destroy();
      const over = (reason: "over" | "restart" | "tooSlow"): void => {
        cancelTimer();
        if (reason === "tooSlow") return cut();
        response.end();
        // Who does not read never gets to the end.
        cancelTimer = clock.after(limits.goodbyeMs, cut);
      };
      const write = (text: string): void => {
        if (!response.writableEnded && !response.destroyed) response.write(text);
      };
      const send = (event: string, data: unknown): void =>
        write(`event: ${event}\ndata: ${JSON.stringify(data)}\n\n`);
      const leave = session.join(key, {
        door: "events",
        snapshot: (snapshot) => send("snapshot", snapshot),
        state: (record) => send("state", record),
        over,
        waitingBytes: () => response.writableLength,
      });
      // A line that breaks is told by "close" as well; unheard, the error would end the process.
      response.on("error", cut);
      response.once("close", () => {
        cancelTimer();
        leave();
      });
      response.writeHead(200, {
        "Content-Type": "text/event-stream",
        "Cache-Control": "no-store",
        // nginx would keep events back to fill its buffer
        "X-Accel-Buffering": "no",
      });
      if (session.newest === null) write(": waiting for the robot\n\n");
      else send("snapshot", session.newest);
      const beat = (): void => {
        if (response.writableLength > limits.stuckReaderBytes) return over("tooSlow");
        write(": still here\n\n");
        cancelTimer = clock.after(limits.heartbeatMs, beat);
      };
      cancelTimer = clock.after(limits.heartbeatMs, beat);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
