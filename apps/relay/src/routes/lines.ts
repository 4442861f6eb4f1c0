/** The WebSocket's messages by plain HTTPS: open a line with hello, send, fetch by long poll, leave. */
import { helloSchema, MAX_FRAME_BYTES, sentMessagesSchema } from "@corridor/protocol";
import { Router } from "express";
import type { Entrance } from "../entrance/entrance.ts";
import type { HttpLines } from "../gateways/http-lines.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { jsonText, patienceOf, readBearer, readBody, readClient, readFetch } from "./reading.ts";

export function lineRoutes(lines: HttpLines, entrance: Entrance): Router {
  const router = Router();

  router
    .route("/robots/:id/line")
    .post(jsonText(), async (request, response) => {
      const hello = readBody(request, helloSchema, MAX_FRAME_BYTES, "The hello is wrong.");
      const from = entrance.addressOf(request);
      const opened = await lines.open(request.params.id, hello, from, readClient(request));
      response.status(201).set("Cache-Control", "no-store").json(opened);
    })
    .delete((request, response) => {
      lines.leave(request.params.id, readBearer(request));
      response.status(204).end();
    })
    .all(methodNotAllowed("POST, DELETE"));

  router
    .route("/robots/:id/line/messages")
    .post(
      // Who may not is told so before the body is read.
      (request, _response, next) => {
        lines.require(request.params.id, readBearer(request));
        next();
      },
      jsonText(),
      (request, response) => {
        const sent = readBody(
          request,
          sentMessagesSchema,
          MAX_FRAME_BYTES,
          "The messages are wrong.",
        );
        response.json(lines.take(request.params.id, readBearer(request), sent));
      },
    )
    .get(async (request, response) => {
      const { after, wait } = readFetch(request);
      const patience = patienceOf(response, wait);
      const key = readBearer(request);
      response.json(await lines.fetch(request.params.id, key, after, patience));
    })
    .all(methodNotAllowed("POST, GET"));

  return router;
}
