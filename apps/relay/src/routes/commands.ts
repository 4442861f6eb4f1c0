/** Commands of scripts: send one, follow it, read the log, stop everything. */
import { termsOf, type CommandRecord } from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import type { SessionHub } from "../sessions/session-hub.ts";
import type { CommandLog } from "./answers.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { hearScript, type Heard } from "./hear-script.ts";
import {
  jsonText,
  patienceOf,
  readAfter,
  readCommandRequest,
  readIdempotencyKey,
  readSeq,
  readWait,
} from "./reading.ts";

export function commandRoutes(hub: SessionHub): Router {
  const router = Router();
  /** when a command came, though its robot had to be found and its body read first */
  const arrivals = new WeakMap<Request, Heard>();

  router
    .route("/robots/:id/commands")
    .post(
      // Who may not is told so before the body is read.
      async (request, response, next) => {
        arrivals.set(request, await hearScript(hub, request, response, "command"));
        next();
      },
      jsonText(),
      async (request, response) => {
        const heard = await hearScript(hub, request, response, "command");
        const { session, key } = heard;
        const command = readCommandRequest(request);
        const { cameAt, transitMs } = arrivals.get(request) ?? heard;
        const age = command.age + transitMs + hub.clock.now() - cameAt;
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
      const { session, key, transitMs } = await hearScript(hub, request, response, "command");
      const terms = { ...termsOf({ action: "stop" }), age: transitMs };
      const stop = { key: readIdempotencyKey(request), ...terms };
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
