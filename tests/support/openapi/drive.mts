/**
 * A client of openapi-typescript and openapi-fetch. Drives forward until a wall is near, and sends
 * the command again, as after a lost answer. Prints what it received as JSON.
 */
import createClient from "openapi-fetch";
import type { components, paths } from "./corridor.ts";

type ForwardOrder = components["schemas"]["ForwardOrder"];

const [origin = "", id = "", key = ""] = process.argv.slice(2);
const client = createClient<paths>({
  baseUrl: origin,
  headers: { Authorization: `Bearer ${key}` },
});

const send = (body: ForwardOrder) =>
  client.POST("/api/v1/robots/{id}/commands", {
    params: { path: { id }, header: { "Idempotency-Key": "typescript-1" } },
    body,
  });

const near: ForwardOrder = {
  action: "forward",
  until: [{ sensor: "front", is: "<", than: 60 }],
};
const first = await send(near);
if (first.data === undefined) throw new Error(first.error.detail);
const again = await send(near);
const other = await send({ action: "forward", until: [{ goal: true }] });
const end = await client.GET("/api/v1/robots/{id}/commands/{seq}", {
  params: { path: { id, seq: first.data.seq }, query: { wait: 25 } },
});
process.stdout.write(
  JSON.stringify({
    first: first.data.seq,
    again: again.data?.seq,
    duplicate: again.data?.duplicate,
    conflict: [other.error?.status, other.error?.type],
    end: [end.data?.state, end.data?.distance],
  }),
);
