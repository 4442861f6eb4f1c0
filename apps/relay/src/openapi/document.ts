/**
 * The OpenAPI 3.1 description of the HTTP API, generated from the schemas that validate the
 * traffic. The schemas describe the fields. This module adds the operations.
 */
import { PROTOCOL_VERSION } from "@corridor/protocol";
import { createDocument, type oas31 } from "zod-openapi";
import { calls } from "./calls.ts";
import { describeByExpectation } from "./describe-by-expectation.ts";
import { withReadingAids } from "./reading-aids.ts";
import { describeCondition, schemas } from "./schemas.ts";

const DESCRIPTION = `A robot runs in a page. The page registers it, and receives the address
\`https://HOST/r/ID#KEY\`. A script needs only this address: send the key after the # as a bearer key.

Lengths are in cm, angles in degrees clockwise from north, x to the right and y downward. A tick is 1/60 s.

The same events and commands are available over a WebSocket at \`/api/v1/robots/{id}/socket\`. \`/asyncapi.json\` describes
its messages. \`/docs\` explains these operations, the life of a command and the WebSocket.`;

/** Builds the document as plain data. */
export function describeApi(): oas31.OpenAPIObject {
  const document = createDocument(
    {
      openapi: "3.1.0",
      info: {
        title: "Corridor",
        // Three numbers, because generators use it as the version of an npm or PyPI package.
        version: `${PROTOCOL_VERSION}.0.0`,
        description: DESCRIPTION,
        license: { name: "MIT", identifier: "MIT" },
      },
      servers: [{ url: "/", description: "the service that serves this document" }],
      paths: calls,
      components: {
        schemas,
        securitySchemes: {
          driverKey: {
            type: "http",
            scheme: "bearer",
            description: "The key in the robot's address, after the #: commands and reads.",
          },
          deleteKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key in the response to the creation of a short link: deletes its document.",
          },
          connectionKey: {
            type: "http",
            scheme: "bearer",
            description: "The key of one long-poll connection, from the response that opened it.",
          },
          ownerKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key of the robot's page: shows and deletes stored data, creates keys.",
          },
          pairingKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key in the response to a pairing request; it becomes a driver key when the owner accepts.",
          },
          watchKey: {
            type: "http",
            scheme: "bearer",
            description: "A read-only key that the owner created for watchers.",
          },
        },
      },
    },
    {
      override: (context) => {
        describeByExpectation(context);
        describeCondition(context);
      },
      // Only for request schemas, whose output has no description.
      allowEmptySchema: { pipe: { output: true }, transform: { output: true } },
    },
  );
  return withReadingAids(document);
}
