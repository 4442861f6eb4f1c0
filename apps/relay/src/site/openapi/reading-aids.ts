/**
 * Groups and examples for readers of the description. Groups are in the order in which the author
 * of a script needs them, and examples are valid requests.
 */
import type { CommandRecord, Order, Snapshot } from "@corridor/protocol";
import type { oas31 } from "zod-openapi";

interface Group {
  name: string;
  description: string;
  /** path prefixes of the group's operations */
  paths: readonly string[];
}

/** An operation belongs to the first group with a matching path. */
export const groups: readonly Group[] = [
  {
    name: "Driving",
    description: "For scripts: commands and their states, sensor readings, events, and the maze.",
    paths: ["commands", "sensors", "events", "maze"].map((part) => `/api/v1/robots/{id}/${part}`),
  },
  {
    name: "Pairing",
    description: "Exchange a typed code for a robot's address.",
    paths: ["/api/v1/pairing"],
  },
  {
    name: "Long-poll connection",
    description: "The messages of the WebSocket, for networks that block WebSockets.",
    paths: ["/api/v1/robots/{id}/long-poll"],
  },
  {
    name: "Robot management",
    description: "For a robot's page: registration, keys, scripts, pauses, and deletion.",
    paths: ["/api/v1/robots"],
  },
  {
    name: "Short links",
    description: "Links to mazes, programs and lessons.",
    paths: ["/api/v1/mazes", "/api/v1/oembed"],
  },
  {
    name: "Classes",
    description: "A teacher's live lesson, which students join with a code.",
    paths: ["/api/v1/classes", "/api/v1/joins"],
  },
  {
    name: "Service",
    description: "For operators of the service.",
    paths: ["/healthz", "/readyz"],
  },
];

export const orderExample: Order = { action: "move", distance: 100 };

export const snapshotExample: Snapshot = {
  seq: 1234,
  tick: 5678,
  state: "running",
  driver: "remote",
  sensors: { front: 250.5, right: 50, back: 49.5, left: 50 },
  pose: { x: 150, y: 150, heading: 90 },
  motion: "move",
  bumps: 0,
  bumping: false,
  goalReached: false,
  line: null,
  command: 12,
};

export const recordExample: CommandRecord = {
  seq: 12,
  key: "b1946ac92492d234",
  action: "move",
  command: { action: "move", distance: 100 },
  state: "accepted",
  reason: null,
  acceptedAt: "2026-01-01T12:00:00.000Z",
  pose: null,
  distance: null,
  duplicate: false,
};

/** Examples by the schema that a body references. */
const examples: Readonly<Record<string, unknown>> = {
  "#/components/schemas/Order": orderExample,
  "#/components/schemas/Snapshot": snapshotExample,
  "#/components/schemas/CommandRecord": recordExample,
};

/** Adds groups and examples to the document. */
export function withReadingAids(document: oas31.OpenAPIObject): oas31.OpenAPIObject {
  for (const [path, item] of Object.entries(document.paths ?? {})) {
    const group = groups.find(({ paths }) =>
      paths.some((prefix) => path === prefix || path.startsWith(`${prefix}/`)),
    );
    for (const method of ["get", "post", "put", "delete"] as const) {
      const operation = item[method];
      if (operation === undefined) continue;
      if (group !== undefined) operation.tags = [group.name];
      for (const body of bodiesOf(operation)) addExample(body);
    }
  }
  const tags = groups.map(({ name, description }) => ({ name, description }));
  return { ...document, tags };
}

function bodiesOf({ requestBody, responses }: oas31.OperationObject): oas31.MediaTypeObject[] {
  const holders = [requestBody, ...Object.values(responses ?? {})] as (
    | oas31.ResponseObject
    | undefined
  )[];
  return holders.flatMap((holder) => Object.values(holder?.content ?? {}));
}

function addExample(body: oas31.MediaTypeObject): void {
  const { schema } = body;
  if (schema === undefined || !("$ref" in schema) || typeof schema.$ref !== "string") return;
  const example = examples[schema.$ref];
  if (example !== undefined) body.example = example;
}
