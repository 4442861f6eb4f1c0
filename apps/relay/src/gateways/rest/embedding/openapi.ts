/** The operation that describes a short link to a site that embeds it. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { oembedQuery, oembedSchema } from "./oembed.ts";

export const oembedCalls: ZodOpenApiPathsObject = {
  "/api/v1/oembed": {
    get: {
      operationId: "describeEmbedding",
      summary: "Describe how to embed a short link (oEmbed 1.0)",
      description:
        "`html` is a frame with the maze or lesson of the short link. The page of a short link names this " +
        "address in its header `Link`. Only JSON is supported.",
      security: [],
      parameters: parameters("query", oembedQuery),
      responses: {
        200: answer("The frame.", oembedSchema),
        ...refusals("bad-request", "no-document", "too-fast"),
      },
    },
  },
};
