/** The HTTP calls of short links. */
import { shortLinkIdSchema, shortLinkSchema } from "@corridor/protocol";
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentSchema } from "../documents/document-schema.ts";
import { answer, location, parameters, refusals } from "./parts.ts";

const shortLink = parameters("path", z.object({ id: shortLinkIdSchema }));

export const documentCalls: ZodOpenApiPathsObject = {
  "/api/v1/mazes": {
    post: {
      operationId: "storeDocument",
      summary: "Make a short link for a maze, program or challenge",
      description:
        "The shortest free code of 4 to 6 letters. " +
        "The same document gets the same link, and each time a key of its own that deletes it. It is " +
        "kept until nobody has used it for 180 days.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: documentSchema } } },
      responses: {
        201: answer("The link and the key that deletes the document.", shortLinkSchema, location),
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
      description: "It is gone when all who stored the same document have deleted it.",
      security: [{ deleteKey: [] }],
      responses: {
        204: { description: "What was stored with this key is deleted." },
        ...refusals("bad-request", "not-authorised", "no-document", "too-fast", "storage-full"),
      },
    },
  },
};
