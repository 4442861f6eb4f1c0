/** Commands of scripts: send a command, read its record, read the log, stop everything. */
import { termsOf, type CommandRecord } from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import type { RobotRegistry } from "../../../robots/registry.ts";
import type { CommandLog } from "./openapi.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { authoriseScript, type AuthorisedRequest } from "../../requests/authorise-script.ts";
import { jsonText } from "../../../platform/http/reading.ts";
import {
  callerWaitOf,
  readAfter,
  readCommandRequest,
  readIdempotencyKey,
  readSeq,
  readWait,
} from "../../requests/reading.ts";

export function commandRoutes(registry: RobotRegistry): Router {
  const router = Router();
  /** arrival times, taken before the robot lookup and the read of the body */
  const arrivals = new WeakMap<Request, AuthorisedRequest>();

  router
    .route("/robots/:id/commands")
    .post(
      // Rejects unauthorised requests before it reads the body.
      async (request, response, next) => {
        arrivals.set(request, await authoriseScript(registry, request, response, "command"));
        next();
      },
      jsonText(),
      async (request, response) => {
        const received = await authoriseScript(registry, request, response, "command");
        const { robot, key } = received;
        const command = readCommandRequest(request);
        const { arrivedAt, transitMs } = arrivals.get(request) ?? received;
        const age = command.age + transitMs + registry.clock.now() - arrivedAt;
        const order = { ...command, age };
        await robot.submit(key, order, (record) => accepted(response, robot.id, record));
      },
    )
    .get(async (request, response) => {
      const { robot } = await authoriseScript(registry, request, response, "log");
      const { after } = readAfter(request);
      const log: CommandLog = { commands: await robot.commandsAfter(after) };
      response.json(log);
    })
    .delete(async (request, response) => {
      const { robot, key, transitMs } = await authoriseScript(
        registry,
        request,
        response,
        "command",
      );
      const terms = { ...termsOf({ action: "stop" }), age: transitMs };
      const stop = { key: readIdempotencyKey(request), ...terms };
      await robot.submit(key, stop, (record) => accepted(response, robot.id, record));
    })
    .all(methodNotAllowed("POST, GET, DELETE"));

  router
    .route("/robots/:id/commands/:seq")
    .get(async (request, response) => {
      const { robot, key } = await authoriseScript(registry, request, response, "log");
      const { wait } = readWait(request);
      const seq = readSeq(request.params.seq);
      response.json(await robot.endOf(seq, callerWaitOf(response, wait, key)));
    })
    .delete(async (request, response) => {
      const { robot, key } = await authoriseScript(registry, request, response, "command");
      const seq = readSeq(request.params.seq);
      accepted(response, robot.id, await robot.cancel(key, seq));
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}

function accepted(response: Response, id: string, record: CommandRecord): void {
  response.status(202).location(`/api/v1/robots/${id}/commands/${record.seq}`).json(record);
}
