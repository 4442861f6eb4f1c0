/** Parts that the described calls share: parameters, answers and refusals. */
import { problemSchema, robotIdSchema } from "@corridor/protocol";
import { z } from "zod";
import {
  createSchema,
  type oas31,
  type ZodOpenApiResponseObject,
  type ZodOpenApiResponsesObject,
} from "zod-openapi";
import { problemKinds, type ProblemKind } from "../problem-kinds.ts";
import { describeByExpectation } from "./describe-by-expectation.ts";

const retryAfter: oas31.HeadersObject = {
  "Retry-After": {
    required: true,
    description: "seconds after which another try may succeed",
    schema: { type: "integer", minimum: 1 },
  },
};

/** What every call with a key may meet. */
export const keyed = ["bad-request", "not-authorised", "forbidden", "no-robot"] as const;
/** The same for a call that scripts make. */
export const asScript = [...keyed, "sent-away"] as const;
/** The key of a call that only the robot's owner makes. */
export const owner = [{ ownerKey: [] }];

const headersByStatus: Partial<Record<number, oas31.HeadersObject>> = {
  401: { "WWW-Authenticate": { required: true, schema: { type: "string", const: "Bearer" } } },
  429: retryAfter,
  503: retryAfter,
  507: retryAfter,
};

/** Where the record of a command can be followed. */
export const location: oas31.HeadersObject = {
  Location: {
    required: true,
    description: "path of what was made",
    schema: { type: "string", format: "uri-reference" },
  },
};

/** By what a document is told from another one. */
export const entityTag: oas31.HeadersObject = {
  ETag: {
    required: true,
    description: "the version of what is answered, in quotation marks",
    schema: { type: "string" },
  },
};

/**
 * The parameters that a schema reads. In a path or query all is text: each is described as the value
 * that its text stands for.
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

/** Which robot is meant. */
export const robot = parameters("path", z.object({ id: robotIdSchema }));

/** An answer in JSON. */
export function answer(
  description: string,
  schema: z.ZodType,
  headers: oas31.HeadersObject = {},
): ZodOpenApiResponseObject {
  return { description, headers, content: { "application/json": { schema } } };
}

/** Every refusal that a call knows, by status, and the one for all that any call may meet. */
export function refusals(...kinds: ProblemKind[]): ZodOpenApiResponsesObject {
  const responses: ZodOpenApiResponsesObject = {
    default: refusal(
      "Any other refusal: 405 with `Allow` for an unknown method, 408 and 431 for a request that takes " +
        "too long or whose headers are too large, 421 for a name that is not this service's, 500 for a " +
        "mistake, 503 with `Retry-After` while the relay restarts.",
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
