/** The two parties of a pairing: a robot's owner, and scripts that have only a code. */
import {
  pairingAnswerSchema,
  requestedPairingSchema,
  createdPairingSchema,
  pairingSchema,
  problemSchema,
  type Pairing,
  type Registration,
} from "@corridor/protocol";
import type { z } from "zod";
import type { Requests } from "./test-relay.ts";

/** Outcome of a request: the body on success, or the kind of problem. */
interface Outcome<T> {
  status: number;
  body: T | null;
  kind: string;
  retryAfter: number;
}

async function outcomeOf<T>(schema: z.ZodType<T>, answer: Response): Promise<Outcome<T>> {
  const json: unknown = await answer.json();
  return {
    status: answer.status,
    body: answer.ok ? schema.parse(json) : null,
    kind: answer.ok ? "" : problemSchema.parse(json).type.replace("/problems/", ""),
    retryAfter: Number(answer.headers.get("retry-after")),
  };
}

export function ownerOf(relay: Requests, robot: Registration) {
  const ask = async (method: string, query = "", body?: unknown) =>
    relay.ask(robot, `/pairing${query}`, { method, key: robot.ownerKey, body });
  return {
    code: async (): Promise<string> =>
      createdPairingSchema.parse(await (await ask("POST")).json()).code,
    show: async (wait = 0): Promise<Pairing> =>
      pairingSchema.parse(await (await ask("GET", `?wait=${wait}`)).json()),
    withdraw: async (): Promise<number> => (await ask("DELETE")).status,
    /** Waits for the question and answers it. @returns the kind of problem, or nothing */
    say: async (accept: boolean): Promise<string> => {
      const shown = pairingSchema.parse(await (await ask("GET", "?wait=5")).json());
      const answer = await ask("PUT", "", { id: shown.question?.id ?? "______", accept });
      return answer.ok ? "" : problemSchema.parse(await answer.json()).type.slice(10);
    },
  };
}

export function scriptAt({ origin }: Requests) {
  const url = `${origin}/api/v1/pairing`;
  return {
    ask: async (body: unknown, headers: Record<string, string> = {}) =>
      outcomeOf(
        requestedPairingSchema,
        await fetch(url, {
          method: "POST",
          headers: { "Content-Type": "application/json", ...headers },
          body: JSON.stringify(body),
        }),
      ),
    receive: async (key: string, wait = 0) =>
      outcomeOf(
        pairingAnswerSchema,
        await fetch(`${url}?wait=${wait}`, { headers: { Authorization: `Bearer ${key}` } }),
      ),
  };
}
