/**
 * Derives descriptions from schemas: the error text of a schema also describes the expected value.
 */
import type { z } from "zod";
import type { ZodOpenApiOverride } from "zod-openapi";

/** Describes a schema by its own error text, such as "degrees clockwise from north". */
export const describeByExpectation: ZodOpenApiOverride = ({ zodSchema, jsonSchema }) => {
  // Error texts of this project are constants, so any issue yields the same text.
  const expect = zodSchema._zod.def.error as z.core.$ZodErrorMap | undefined;
  const expectation = expect?.({ code: "custom", input: undefined });
  const text = typeof expectation === "string" ? expectation : expectation?.message;
  if (text !== undefined) jsonSchema.description ??= text;
};
