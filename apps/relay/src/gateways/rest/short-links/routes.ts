/** Short links: store, read and delete a document. */
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";
import { Router } from "express";
import { documentSchema } from "../../../short-links/document-schema.ts";
import type { DocumentService } from "../../../short-links/document-service.ts";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { bodyReader, readBearer } from "../../../platform/http/reading.ts";

const readDocument = bodyReader(documentSchema, "Invalid document.", { limit: MAX_DOCUMENT_BYTES });

export function documentRoutes(service: DocumentService, guard: RequestGuard): Router {
  const router = Router();

  router
    .route("/mazes")
    .post(async (request, response) => {
      const document = await readDocument(request, response);
      const from = guard.addressOf(request);
      const link = await service.add(document, from, guard.originOf(request));
      response.status(201).location(`/api/v1/mazes/${link.id}`).json(link);
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/mazes/:id")
    .get(async (request, response) => {
      const text = await service.read(request.params.id, guard.addressOf(request));
      response.type("json").send(text);
    })
    .delete(async (request, response) => {
      await service.remove(request.params.id, readBearer(request), guard.addressOf(request));
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}
