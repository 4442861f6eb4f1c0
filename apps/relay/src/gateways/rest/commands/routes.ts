/** Commands of scripts: send a command, read its record, read the log, stop everything. */
import { termsOf, type CommandRecord } from "@corridor/protocol";
import { Router, type Response } from "express";
import type { RobotRegistry } from "../../../robots/registry.ts";
import type { CommandLog } from "./openapi.ts";
import { Refusal } from "../../../platform/errors/problems.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import {
  authoriseScript,
  callerWaitOf,
  readAfter,
  readCommandRequest,
  readIdempotencyKey,
  readSeq,
  readWait,
} from "../../requests/script-requests.ts";

export function commandRoutes(registry: RobotRegistry): Router {
  const router = Router();

  router
    .route("/robots/:id/commands")
    .post(async (request, response) => {
      const { robot, key, arrivedAt, transitMs } = await authoriseScript(
        registry,
        request,
        response,
        "command",
      );
      // The store checks again whether the key may send commands when it stores this one.
      const command = await readCommandRequest(request, response).catch((error: unknown) => {
        if (error instanceof Refusal) robot.refused(key, error.problem.detail);
        throw error;
      });
      const age = command.age + transitMs + registry.clock.now() - arrivedAt;
      const order = { ...command, age };
      await robot.submit(key, order, (record) => accepted(response, robot.id, record));
    })
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
