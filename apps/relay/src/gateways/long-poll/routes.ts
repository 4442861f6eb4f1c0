/** Long-poll connections: the messages of the WebSocket over plain HTTPS requests. */
import { helloSchema, sentMessagesSchema } from "@corridor/protocol";
import { Router } from "express";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import type { LongPollConnections } from "./long-poll-connections.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { bodyReader, readBearer, readClient, waitLimitOf } from "../../platform/http/reading.ts";
import { readFetch } from "../requests/reading.ts";

const readHello = bodyReader(helloSchema, "Invalid hello.");
const readMessages = bodyReader(sentMessagesSchema, "Invalid messages.");

export function longPollRoutes(connections: LongPollConnections, guard: RequestGuard): Router {
  const router = Router();

  router
    .route("/robots/:id/long-poll")
    .post(async (request, response) => {
      const hello = await readHello(request, response);
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
    .post(async (request, response) => {
      const { id } = request.params;
      const key = readBearer(request);
      connections.require(id, key);
      const sent = await readMessages(request, response);
      // The connection may have closed meanwhile.
      response.json(connections.receive(id, key, sent));
    })
    .get(async (request, response) => {
      const { after, wait } = readFetch(request);
      const waitLimit = waitLimitOf(response, wait);
      const key = readBearer(request);
      response.json(await connections.fetch(request.params.id, key, after, waitLimit));
    })
    .all(methodNotAllowed("POST, GET"));

  return router;
}
