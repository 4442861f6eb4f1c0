/** Commands of scripts: send one, follow it, read the log, stop everything. */
import { termsOf, type CommandRecord } from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import type { Clock } from "../clock.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import type { CommandLog } from "./answers.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { hearScript } from "./hear-script.ts";
import {
  jsonText,
  patienceOf,
  readAfter,
  readCommandRequest,
  readIdempotencyKey,
  readSeq,
  readWait,
} from "./reading.ts";

export function commandRoutes(hub: SessionHub, clock: Clock): Router {
  const router = Router();
  /** when a command came, though its robot had to be found and its body read first */
  const arrivals = new WeakMap<Request, number>();

  router
    .route("/robots/:id/commands")
    .post(
      // Who may not is told so before the body is read.
      async (request, response, next) => {
        arrivals.set(request, clock.now());
        await hearScript(hub, request, response, "command");
        next();
      },
      jsonText(),
      async (request, response) => {
        const { session, key } = await hearScript(hub, request, response, "command");
        const command = readCommandRequest(request);
        const now = clock.now();
        const age = command.age + now - (arrivals.get(request) ?? now);
        const wish = { ...command, age };
        await session.submit(key, wish, (record) => accepted(response, session.id, record));
      },
    )
    .get(async (request, response) => {
      const { session } = await hearScript(hub, request, response, "log");
      const { after } = readAfter(request);
      const log: CommandLog = { commands: await session.commandsAfter(after) };
      response.json(log);
    })
    .delete(async (request, response) => {
      const { session, key } = await hearScript(hub, request, response, "command");
      const stop = { key: readIdempotencyKey(request), ...termsOf({ action: "stop" }) };
      await session.submit(key, stop, (record) => accepted(response, session.id, record));
    })
    .all(methodNotAllowed("POST, GET, DELETE"));

  router
    .route("/robots/:id/commands/:seq")
    .get(async (request, response) => {
      const { session, key } = await hearScript(hub, request, response, "log");
      const { wait } = readWait(request);
      const seq = readSeq(request.params.seq);
      response.json(await session.endOf(seq, patienceOf(response, wait, key)));
    })
    .delete(async (request, response) => {
      const { session, key } = await hearScript(hub, request, response, "command");
      const seq = readSeq(request.params.seq);
      accepted(response, session.id, await session.cancel(key, seq));
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}

function accepted(response: Response, id: string, record: CommandRecord): void {
  response.status(202).location(`/api/v1/robots/${id}/commands/${record.seq}`).json(record);
}
