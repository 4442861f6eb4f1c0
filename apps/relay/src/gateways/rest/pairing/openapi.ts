/** Operations for pairing: a code on the robot's page, a script's request, the owner's answer. */
import {
  pairingAnswerSchema,
  requestedPairingSchema,
  createdPairingSchema,
  pairingReplySchema,
  pairingSchema,
  pairingRequestSchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { nameHeader, waitQuery } from "../../requests/script-requests.ts";
import { answer, location, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { keyed, owner, robot } from "../../requests/openapi-parts.ts";

export const pairingCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/pairing": {
    parameters: robot,
    post: {
      operationId: "createPairingCode",
      summary: "Create a pairing code, to type instead of the address",
      description:
        "The code is valid for 10 minutes and one script. An earlier code of the robot becomes invalid. The code is " +
        "returned only once.",
      security: owner,
      responses: {
        201: answer("The code.", createdPairingSchema),
        ...refusals(...keyed, "storage-full"),
      },
    },
    get: {
      operationId: "readPairing",
      summary: "Read the state of the pairing code, or wait until a script uses it",
      security: owner,
      parameters: parameters("query", waitQuery),
      responses: {
        200: answer("The state, with the script that requests access.", pairingSchema),
        ...refusals(...keyed, "too-many-readers"),
      },
    },
    put: {
      operationId: "answerPairing",
      summary: "Accept or decline the request of a script",
      description: "An accepted script receives its own key, which is listed and can be revoked.",
      security: owner,
      requestBody: {
        required: true,
        content: { "application/json": { schema: pairingReplySchema } },
      },
      responses: {
        204: { description: "The answer is stored." },
        ...refusals(...keyed, "no-question", "too-many-keys", "too-large", "not-json"),
        ...refusals("storage-full"),
      },
    },
    delete: {
      operationId: "revokePairingCode",
      summary: "Revoke the pairing code",
      security: owner,
      responses: {
        204: { description: "The robot has no valid code." },
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
  "/api/v1/pairing": {
    post: {
      operationId: "requestPairing",
      summary: "Request access to a robot with the code that its page displays",
      description:
        "Poll for the answer with `GET` and the returned key. The relay checks the codes of one network in order " +
        "of arrival, at most 5 a second after wrong codes. 429: 50 codes of the network wait, so this one was not checked.",
      security: [],
      parameters: parameters("header", nameHeader),
      requestBody: {
        required: true,
        content: { "application/json": { schema: pairingRequestSchema } },
      },
      responses: {
        202: answer(
          "The key with which to wait for the answer. The page shows the request to the owner.",
          requestedPairingSchema,
          location,
        ),
        ...refusals("bad-request", "no-pairing", "code-used", "too-large", "not-json", "too-fast"),
        ...refusals("storage-full"),
      },
    },
    get: {
      operationId: "awaitPairing",
      summary: "Wait for the owner's answer",
      security: [{ pairingKey: [] }],
      parameters: parameters("query", waitQuery),
      responses: {
        200: answer("The robot's address, once the owner has accepted.", pairingAnswerSchema),
        ...refusals("bad-request", "not-authorised", "pairing-refused", "no-pairing"),
        ...refusals("too-many-readers"),
      },
    },
  },
};
