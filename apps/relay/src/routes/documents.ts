/** Short links: storing a document, giving it back, deleting it. */
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";
import { Router } from "express";
import { documentSchema } from "../documents/document-schema.ts";
import type { DocumentShelf } from "../documents/document-shelf.ts";
import type { Entrance } from "../entrance/entrance.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { jsonText, readBearer, readBody } from "./reading.ts";

export function documentRoutes(shelf: DocumentShelf, entrance: Entrance): Router {
  const router = Router();

  router
    .route("/mazes")
    .post(jsonText(MAX_DOCUMENT_BYTES), async (request, response) => {
      const document = readBody(
        request,
        documentSchema,
        MAX_DOCUMENT_BYTES,
        "The document is wrong.",
      );
      const from = entrance.addressOf(request);
      const link = await shelf.add(document, from, entrance.originOf(request));
      response.status(201).location(`/api/v1/mazes/${link.id}`).json(link);
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/mazes/:id")
    .get(async (request, response) => {
      const text = await shelf.read(request.params.id, entrance.addressOf(request));
      response.type("json").send(text);
    })
    .delete(async (request, response) => {
      await shelf.remove(request.params.id, readBearer(request), entrance.addressOf(request));
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}
