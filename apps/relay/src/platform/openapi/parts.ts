/** Parts of the descriptions of operations: parameters, responses and errors. */
import { problemSchema } from "@corridor/protocol";
import type { z } from "zod";
import {
  createSchema,
  type oas31,
  type ZodOpenApiResponseObject,
  type ZodOpenApiResponsesObject,
} from "zod-openapi";
import { problemKinds, type ProblemKind } from "../errors/problem-kinds.ts";
import { describeByExpectation } from "./describe-by-expectation.ts";

const retryAfter: oas31.HeadersObject = {
  "Retry-After": {
    required: true,
    description: "seconds after which a retry may succeed",
    schema: { type: "integer", minimum: 1 },
  },
};

const headersByStatus: Partial<Record<number, oas31.HeadersObject>> = {
  401: { "WWW-Authenticate": { required: true, schema: { type: "string", const: "Bearer" } } },
  429: retryAfter,
  503: retryAfter,
  507: retryAfter,
};

/** Header with the path of the created resource. */
export const location: oas31.HeadersObject = {
  Location: {
    required: true,
    description: "path of the created resource",
    schema: { type: "string", format: "uri-reference" },
  },
};

/** Header with the version of a document. */
export const entityTag: oas31.HeadersObject = {
  ETag: {
    required: true,
    description: "the version of the document, in quotation marks",
    schema: { type: "string" },
  },
};

/**
 * Describes the parameters of a schema. Paths and queries contain text, so each parameter is
 * described as the value that its text represents.
 */
export function parameters(
  place: "path" | "query" | "header",
  { shape }: z.ZodObject<Record<string, z.ZodType>>,
): oas31.ParameterObject[] {
  return Object.entries(shape).map(([name, type]) => {
    const opts = { override: describeByExpectation };
    const { description, ...schema } = createSchema(type, { io: "output", opts }).schema;
    return {
      name,
      in: place,
      required: place === "path" || !type.isOptional(),
      ...(description !== undefined && { description }),
      schema,
    };
  });
}

/** A JSON response. */
export function answer(
  description: string,
  schema: z.ZodType,
  headers: oas31.HeadersObject = {},
): ZodOpenApiResponseObject {
  return { description, headers, content: { "application/json": { schema } } };
}

/**
 * Error responses of an operation by status, and the default response for errors of any operation.
 */
export function refusals(...kinds: ProblemKind[]): ZodOpenApiResponsesObject {
  const responses: ZodOpenApiResponsesObject = {
    default: refusal(
      "Any other error: 405 with `Allow` for an unsupported method, 408 and 431 for a request that takes " +
        "too long or has too large headers, 421 for another host, 500 for an " +
        "internal error, 503 with `Retry-After` while the relay restarts.",
    ),
  };
  for (const [status, same] of Map.groupBy(kinds, (kind) => problemKinds[kind].status)) {
    const sentences = same.map((kind) => `\`/problems/${kind}\`: ${problemKinds[kind].title}.`);
    responses[`${status}` as const] = refusal(sentences.join(" "), headersByStatus[status]);
  }
  return responses;
}

function refusal(description: string, headers: oas31.HeadersObject = {}): ZodOpenApiResponseObject {
  return {
    description,
    headers,
    content: { "application/problem+json": { schema: problemSchema } },
  };
}
