/**
 * The OpenAPI 3.1 description of the HTTP API, generated from the schemas that validate the
 * traffic. The schemas describe the fields. This module adds the operations.
 */
import { PROTOCOL_VERSION } from "@corridor/protocol";
import { createDocument, type oas31 } from "zod-openapi";
import { gatewayCalls } from "../../gateways/openapi.ts";
import { healthCalls, healthSchemas } from "../../ops/health-openapi.ts";
import { describeByExpectation } from "../../platform/openapi/describe-by-expectation.ts";
import { withOpenResponses } from "./open-responses.ts";
import { withReadingAids } from "./reading-aids.ts";
import {
  describeCondition,
  describeVersions,
  schemas,
  withConditionKinds,
} from "../../gateways/openapi-schemas.ts";

const DESCRIPTION = `Each robot has an address, \`https://HOST/r/ID#KEY\`. A script needs only this address:
send the part after # in the header \`Authorization: Bearer KEY\`. The robot's page registers the robot.

Lengths are in cm, angles in degrees clockwise from north, x to the right and y downward. A tick is 1/60 s.

The same events and commands are available over a WebSocket at \`/api/v1/robots/{id}/socket\`. \`/asyncapi.json\` describes
its messages. \`/docs\` contains guides: commands and their life cycle, reading, transports, keys and limits.`;

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
      servers: [{ url: "/", description: "the service that serves this description" }],
      paths: { ...gatewayCalls, ...healthCalls },
      components: {
        schemas: { ...schemas, ...healthSchemas },
        securitySchemes: {
          driverKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key in the robot's address, after #. It permits commands and reading.",
          },
          deleteKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key from the response that created a short link. It permits deleting the document.",
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
              "The key of the robot's page. It permits managing the robot, its data, keys and scripts.",
          },
          pairingKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key from the response to a pairing request. It becomes a driver key when the owner accepts.",
          },
          teacherKey: {
            type: "http",
            scheme: "bearer",
            description:
              "The key of a class's teacher, from the response that created the class. It permits everything in the class.",
          },
          screenKey: {
            type: "http",
            scheme: "bearer",
            description: "The key of a class's big screen. It permits reading the lesson.",
          },
          studentKey: {
            type: "http",
            scheme: "bearer",
            description: "The key of one student of a class, from the response to a join request.",
          },
          watchKey: {
            type: "http",
            scheme: "bearer",
            description: "A read-only key that the owner created for viewers.",
          },
        },
      },
    },
    {
      override: (context) => {
        describeByExpectation(context);
        describeCondition(context);
        describeVersions(context);
      },
      // Only for request schemas, whose output has no description.
      allowEmptySchema: { pipe: { output: true }, transform: { output: true } },
    },
  );
  return withReadingAids(withOpenResponses(withConditionKinds(document)));
}
