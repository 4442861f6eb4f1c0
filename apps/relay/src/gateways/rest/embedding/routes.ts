/** Describes how other sites embed a short link. */
import { Router } from "express";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { read } from "../../../platform/http/reading.ts";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import { Refusal } from "../../../platform/errors/problems.ts";
import type { DocumentService } from "../../../short-links/document-service.ts";
import type { SharedDocument } from "../../../short-links/document-schema.ts";
import { describeFrame, oembedQuery, readEmbeddedLink } from "./oembed.ts";

export function oembedRoutes(documents: DocumentService, guard: RequestGuard): Router {
  const router = Router();
  router
    .route("/oembed")
    .get(async (request, response) => {
      const query = read(oembedQuery, request.query, "Invalid query.");
      const origin = guard.originOf(request);
      const link = readEmbeddedLink(query.url, origin);
      if (link === null) {
        throw new Refusal(
          "no-document",
          `Only short links of this service can be embedded: ${origin}/m/ID`,
        );
      }
      const text = await documents.read(link.id, guard.addressOf(request));
      // The relay validated the document before it stored it.
      const document = JSON.parse(text) as SharedDocument;
      response.json(describeFrame(link, document, origin, query));
    })
    .all(methodNotAllowed("GET"));
  return router;
}
