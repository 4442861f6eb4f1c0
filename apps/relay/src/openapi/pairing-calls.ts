/** The HTTP calls of pairing: a code in the robot's page, a script that asks by it, the owner's answer. */
import {
  pairingAnswerSchema,
  pairingAskedSchema,
  pairingMadeSchema,
  pairingReplySchema,
  pairingSchema,
  pairingWishSchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { nameHeader, waitQuery } from "../routes/reading.ts";
import { answer, keyed, location, owner, parameters, refusals, robot } from "./parts.ts";

export const pairingCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/pairing": {
    parameters: robot,
    post: {
      operationId: "makePairingCode",
      summary: "Make a pairing code, to be typed in place of a long address",
      description:
        "It counts for 10 minutes and for one script. An earlier one of the robot counts no more. The code is " +
        "shown here and never again.",
      security: owner,
      responses: {
        201: answer("The code.", pairingMadeSchema),
        ...refusals(...keyed, "storage-full"),
      },
    },
    get: {
      operationId: "showPairing",
      summary: "Show how it stands with the pairing code, or wait until a script asks by it",
      security: owner,
      parameters: parameters("query", waitQuery),
      responses: {
        200: answer("How it stands, with the script that asks.", pairingSchema),
        ...refusals(...keyed, "too-many-readers"),
      },
    },
    put: {
      operationId: "answerPairing",
      summary: "Answer the script that asks: yes or no",
      description: "By a yes the script gets a key of its own, which is listed and can be revoked.",
      security: owner,
      requestBody: {
        required: true,
        content: { "application/json": { schema: pairingReplySchema } },
      },
      responses: {
        204: { description: "It is answered." },
        ...refusals(...keyed, "no-question", "too-many-keys", "too-large", "not-json"),
        ...refusals("storage-full"),
      },
    },
    delete: {
      operationId: "takeBackPairingCode",
      summary: "Take the pairing code back",
      security: owner,
      responses: { 204: { description: "No code counts." }, ...refusals(...keyed, "storage-full") },
    },
  },
  "/api/v1/pairing": {
    post: {
      operationId: "askToPair",
      summary: "Ask the owner of a robot by the code that its page shows",
      description:
        "The answer comes by `GET` with the key that is given here. The codes of one network are checked in order " +
        "of arrival, at most 5 a second after wrong ones. 429: 50 codes wait already; this one was not checked.",
      security: [],
      parameters: parameters("header", nameHeader),
      requestBody: {
        required: true,
        content: { "application/json": { schema: pairingWishSchema } },
      },
      responses: {
        202: answer("The owner is asked.", pairingAskedSchema, location),
        ...refusals("bad-request", "no-pairing", "code-used", "too-large", "not-json", "too-fast"),
        ...refusals("storage-full"),
      },
    },
    get: {
      operationId: "awaitPairing",
      summary: "Wait until the owner has said yes or no",
      security: [{ pairingKey: [] }],
      parameters: parameters("query", waitQuery),
      responses: {
        200: answer("The robot's address, once the owner said yes.", pairingAnswerSchema),
        ...refusals("bad-request", "not-authorised", "pairing-refused", "no-pairing"),
        ...refusals("too-many-readers"),
      },
    },
  },
};
