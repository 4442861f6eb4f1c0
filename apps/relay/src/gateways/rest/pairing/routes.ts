/** Pairing: the owner's code and answer, and the script's request. */
import { pairingReplySchema, pairingRequestSchema, scriptName } from "@corridor/protocol";
import { Router } from "express";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import { canBeKey } from "../../../platform/keys.ts";
import type { PairingService } from "../../../pairing/pairing-service.ts";
import { notAuthorised } from "../../../platform/errors/problems.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { bodyReader, readBearer, readClient, waitLimitOf } from "../../../platform/http/reading.ts";
import { readIntroduction, readWait } from "../../requests/script-requests.ts";

const readReply = bodyReader(pairingReplySchema, "Invalid answer.");
const readPairingRequest = bodyReader(pairingRequestSchema, "Invalid pairing code.");

export function pairingRoutes(
  registry: RobotRegistry,
  service: PairingService,
  guard: RequestGuard,
): Router {
  const router = Router();

  router
    .route("/robots/:id/pairing")
    .post(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      const made = await service.open(robot.id);
      response.status(201).json(made);
    })
    .get(async (request, response) => {
      const { wait } = readWait(request);
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      response.json(await service.show(robot.id, waitLimitOf(response, wait)));
    })
    .put(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      const { id, accept } = await readReply(request, response);
      await service.reply(robot, id, accept);
      response.status(204).end();
    })
    .delete(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      await service.remove(robot.id);
      response.status(204).end();
    })
    .all(methodNotAllowed("POST, GET, PUT, DELETE"));

  router
    .route("/pairing")
    .post(async (request, response) => {
      const { code, name } = await readPairingRequest(request, response);
      const asked = await service.ask({
        code,
        name: typeof name === "string" ? scriptName(name) : readIntroduction(request).name,
        client: readClient(request),
        from: guard.addressOf(request),
      });
      response.status(202).location("/api/v1/pairing").json(asked);
    })
    .get(async (request, response) => {
      const { wait } = readWait(request);
      const key = readBearer(request);
      if (!canBeKey(key)) {
        throw notAuthorised(
          "Send the key from the response to POST /pairing, as: Authorization: Bearer KEY",
        );
      }
      const origin = guard.originOf(request);
      const answer = await service.answerFor(key, origin, waitLimitOf(response, wait));
      response.json(answer);
    })
    .all(methodNotAllowed("POST, GET"));

  return router;
}
