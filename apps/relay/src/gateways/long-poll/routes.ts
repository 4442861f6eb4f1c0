/** Long-poll connections: the messages of the WebSocket over plain HTTPS requests. */
import { sentMessagesSchema } from "@corridor/protocol";
import { Router } from "express";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import type { LongPollConnections } from "./long-poll-connections.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { bodyReader, readBearer, readClient, waitLimitOf } from "../../platform/http/reading.ts";
import { readFetch } from "../requests/script-requests.ts";

export function longPollRoutes<H extends { role: string; key: string }>(
  connections: LongPollConnections<H>,
  guard: RequestGuard,
): Router {
  const router = Router();
  const { name, helloSchema, maxMessageBytes } = connections.endpoint;
  const readHello = bodyReader(helloSchema, "Invalid hello.");
  const readMessages = bodyReader(sentMessagesSchema, "Invalid messages.", {
    limit: maxMessageBytes,
  });
  const path: `/${string}/:id/long-poll` = `/${name}/:id/long-poll`;

  router
    .route(path)
    .post(async (request, response) => {
      const hello = await readHello(request, response);
      const from = guard.addressOf(request);
      const opened = await connections.open(request.params.id, hello, from, readClient(request));
      response.status(201).set("Cache-Control", "no-store").json(opened);
    })
    .delete((request, response) => {
      connections.find(request.params.id, readBearer(request)).leave();
      response.status(204).end();
    })
    .all(methodNotAllowed("POST, DELETE"));

  router
    .route(`${path}/messages` as const)
    .post(async (request, response) => {
      // Before the body is read, so that no stranger can make the relay read one.
      const connection = connections.find(request.params.id, readBearer(request));
      response.json(connection.receive(await readMessages(request, response)));
    })
    .get(async (request, response) => {
      const { after, wait } = readFetch(request);
      const waitLimit = waitLimitOf(response, wait);
      const connection = connections.find(request.params.id, readBearer(request));
      response.json(await connection.fetch(after, waitLimit));
    })
    .all(methodNotAllowed("POST, GET"));

  return router;
}
