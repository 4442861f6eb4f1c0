/** Commands of scripts: send a command, read its record, read the log, stop everything. */
import { termsOf, type CommandRecord } from "@corridor/protocol";
import { Router, type Response } from "express";
import type { RobotRegistry } from "../../../robots/registry.ts";
import type { CommandLog } from "./openapi.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import {
  authoriseScript,
  callerWaitOf,
  readAfter,
  readCommandRequest,
  readFor,
  readIdempotencyKey,
  readSeq,
  readWait,
} from "../../requests/script-requests.ts";

export function commandRoutes(registry: RobotRegistry): Router {
  const router = Router();

  router
    .route("/robots/:id/commands")
    .post(async (request, response) => {
      const script = await authoriseScript(registry, request, response, "command");
      // The key may be revoked meanwhile, so the step that stores the command checks it again.
      const { robot, caller } = script;
      const command = await readFor(script, () => readCommandRequest(request, response));
      const order = { ...command, age: command.age + script.ageMs() };
      await robot.submit(caller, order, (record) => accepted(response, robot.id, record));
    })
    .get(async (request, response) => {
      const { robot } = await authoriseScript(registry, request, response, "log");
      const { after } = readAfter(request);
      const log: CommandLog = { commands: await robot.commandsAfter(after) };
      response.json(log);
    })
    .delete(async (request, response) => {
      const script = await authoriseScript(registry, request, response, "command");
      const { robot, caller } = script;
      const key = await readFor(script, () => readIdempotencyKey(request));
      const stop = { key, ...termsOf({ action: "stop" }), age: script.ageMs() };
      await robot.submit(caller, stop, (record) => accepted(response, robot.id, record));
    })
    .all(methodNotAllowed("POST, GET, DELETE"));

  router
    .route("/robots/:id/commands/:seq")
    .get(async (request, response) => {
      const { robot, caller } = await authoriseScript(registry, request, response, "log");
      const { wait } = readWait(request);
      const seq = readSeq(request.params.seq);
      response.json(await robot.endOf(seq, callerWaitOf(response, wait, caller)));
    })
    .delete(async (request, response) => {
      const { robot, caller } = await authoriseScript(registry, request, response, "command");
      const seq = readSeq(request.params.seq);
      accepted(response, robot.id, await robot.cancel(caller, seq));
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}

function accepted(response: Response, id: string, record: CommandRecord): void {
  response.status(202).location(`/api/v1/robots/${id}/commands/${record.seq}`).json(record);
}
