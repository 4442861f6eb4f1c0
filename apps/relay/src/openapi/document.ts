/**
 * The OpenAPI 3.1 description of the HTTP calls, generated from the schemas that check the traffic.
 * What a field must be is said by its schema alone; here are only the calls and what they are for.
 */
import { PROTOCOL_VERSION } from "@corridor/protocol";
import { createDocument, type oas31 } from "zod-openapi";
import { calls } from "./calls.ts";
import { describeByExpectation } from "./describe-by-expectation.ts";
import { withReadingAids } from "./reading-aids.ts";
import { describeCondition, schemas } from "./schemas.ts";

const DESCRIPTION = `A robot lives in a page. The page registers it, and gets an address
\`https://HOST/r/ID#KEY\`, which is all that a script needs: send the key after the # as a bearer key.

Lengths are in cm, angles in degrees clockwise from north, x to the right and y downward. A tick is 1/60 s.

The same events and commands go over a WebSocket at \`/api/v1/robots/{id}/socket\`: \`/asyncapi.json\` describes its
messages. \`/docs\` shows these calls, with the life of a command and the WebSocket in words.`;

/** The whole document, as plain data. */
export function describeApi(): oas31.OpenAPIObject {
  const document = createDocument(
    {
      openapi: "3.1.0",
      info: {
        title: "Corridor",
        // Three numbers: what is generated is a package of npm or PyPI.
        version: `${PROTOCOL_VERSION}.0.0`,
        description: DESCRIPTION,
        license: { name: "MIT", identifier: "MIT" },
      },
      servers: [{ url: "/", description: "the service that this document comes from" }],
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
            description: "The key that came with a short link: deletes what it leads to.",
          },
          lineKey: {
            type: "http",
            scheme: "bearer",
            description: "The key of one line, which came with it.",
          },
          ownerKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key of the robot's own page: shows and deletes what is held, makes keys.",
          },
          pairingKey: {
            type: "http",
            scheme: "bearer",
            description: "The key that came with the question; a yes makes it a driver key.",
          },
          watchKey: {
            type: "http",
            scheme: "bearer",
            description: "A key that its owner made for watching: reads only.",
          },
        },
      },
    },
    {
      override: (context) => {
        describeByExpectation(context);
        describeCondition(context);
      },
      // Shapes of requests alone: what is read from them has no description.
      allowEmptySchema: { pipe: { output: true }, transform: { output: true } },
    },
  );
  return withReadingAids(document);
}
