/**
 * Clients ignore unknown fields, so later versions of the relay may add some. The schemas that only
 * responses use therefore allow them. Requests with unknown fields are rejected.
 */
import type { oas31 } from "zod-openapi";

const COMPONENT = "#/components/schemas/";

/** Allows further fields in all named schemas that no request uses. */
export function withOpenResponses(document: oas31.OpenAPIObject): oas31.OpenAPIObject {
  const schemas = document.components?.schemas ?? {};
  const requests = Object.values(document.paths ?? {}).flatMap((item) =>
    [item.get, item.post, item.put, item.delete].map((operation) => operation?.requestBody),
  );
  const inRequests = usedBy(requests, schemas);
  for (const [name, schema] of Object.entries(schemas)) {
    if (inRequests.has(name)) continue;
    for (const node of nodes(schema)) {
      if (node["additionalProperties"] === false) delete node["additionalProperties"];
    }
  }
  return document;
}

/** Names of all schemas that a part of the document references, directly or not. */
function usedBy(part: unknown, schemas: Readonly<Record<string, unknown>>): Set<string> {
  const names = new Set<string>();
  const open = [part];
  for (let value = open.pop(); value !== undefined; value = open.pop()) {
    for (const { $ref } of nodes(value)) {
      const name = typeof $ref === "string" ? $ref.replace(COMPONENT, "") : "";
      if (name === "" || names.has(name)) continue;
      names.add(name);
      open.push(schemas[name]);
    }
  }
  return names;
}

/** All objects in a value, recursively. */
function* nodes(value: unknown): Generator<Record<string, unknown>> {
  if (typeof value !== "object" || value === null) return;
  yield value as Record<string, unknown>;
  for (const child of Object.values(value)) yield* nodes(child);
}
