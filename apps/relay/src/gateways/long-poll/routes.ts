/** Long-poll connections: the messages of the WebSocket over plain HTTPS requests. */
import { helloSchema, MAX_FRAME_BYTES, sentMessagesSchema } from "@corridor/protocol";
import { Router } from "express";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import type { LongPollConnections } from "./long-poll-connections.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import {
  jsonText,
  readBearer,
  readBody,
  readClient,
  waitLimitOf,
} from "../../platform/http/reading.ts";
import { readFetch } from "../requests/reading.ts";

export function longPollRoutes(connections: LongPollConnections, guard: RequestGuard): Router {
  const router = Router();

  router
    .route("/robots/:id/long-poll")
    .post(jsonText(), async (request, response) => {
      const hello = readBody(request, helloSchema, MAX_FRAME_BYTES, "Invalid hello.");
      const from = guard.addressOf(request);
      const opened = await connections.open(request.params.id, hello, from, readClient(request));
      response.status(201).set("Cache-Control", "no-store").json(opened);
    })
    .delete((request, response) => {
      connections.leave(request.params.id, readBearer(request));
      response.status(204).end();
    })
    .all(methodNotAllowed("POST, DELETE"));

  router
    .route("/robots/:id/long-poll/messages")
    .post(
      // Rejects unauthorised requests before it reads the body.
      (request, _response, next) => {
        connections.require(request.params.id, readBearer(request));
        next();
      },
      jsonText(),
      (request, response) => {
        const sent = readBody(request, sentMessagesSchema, MAX_FRAME_BYTES, "Invalid messages.");
        response.json(connections.receive(request.params.id, readBearer(request), sent));
      },
    )
    .get(async (request, response) => {
      const { after, wait } = readFetch(request);
      const waitLimit = waitLimitOf(response, wait);
      const key = readBearer(request);
      response.json(await connections.fetch(request.params.id, key, after, waitLimit));
    })
    .all(methodNotAllowed("POST, GET"));

  return router;
}
