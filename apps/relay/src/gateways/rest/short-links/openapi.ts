/** Operations for short links. */
import { shortLinkIdSchema, shortLinkSchema } from "@corridor/protocol";
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentSchema } from "../../../short-links/document-schema.ts";
import { answer, location, parameters, refusals } from "../../../platform/openapi/parts.ts";

const shortLink = parameters("path", z.object({ id: shortLinkIdSchema }));

export const documentCalls: ZodOpenApiPathsObject = {
  "/api/v1/mazes": {
    post: {
      operationId: "storeDocument",
      summary: "Create a short link for a maze, program, maze with program, or lesson",
      description:
        "The link has the shortest free code of 4 to 6 letters. " +
        "Equal documents share one link. Each request returns a new key that permits deleting the document. " +
        "A document is deleted after 180 days without use.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: documentSchema } } },
      responses: {
        201: answer("The link, and the key to delete the document.", shortLinkSchema, location),
        ...refusals("bad-request", "too-large", "not-json", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/mazes/{id}": {
    parameters: shortLink,
    get: {
      operationId: "readDocument",
      summary: "Read the document behind a short link",
      security: [],
      responses: {
        200: answer("The document.", documentSchema),
        ...refusals("bad-request", "no-document", "too-fast"),
      },
    },
    delete: {
      operationId: "deleteDocument",
      summary: "Delete the document behind a short link",
      description: "The document is deleted once everyone who stored it has deleted it.",
      security: [{ deleteKey: [] }],
      responses: {
        204: { description: "The document of this key is deleted." },
        ...refusals("bad-request", "not-authorised", "no-document", "too-fast", "storage-full"),
      },
    },
  },
};
