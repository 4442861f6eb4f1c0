/** Descriptions without writing them twice: what a schema says that it expected also tells what to send. */
import type { z } from "zod";
import type { ZodOpenApiOverride } from "zod-openapi";

/** Describes a schema by its own error text, such as "degrees clockwise from north". */
export const describeByExpectation: ZodOpenApiOverride = ({ zodSchema, jsonSchema }) => {
  // The error texts of this project are constants: which issue is shown to them makes no difference.
  const expect = zodSchema._zod.def.error as z.core.$ZodErrorMap | undefined;
  const expectation = expect?.({ code: "custom", input: undefined });
  const text = typeof expectation === "string" ? expectation : expectation?.message;
  if (text !== undefined) jsonSchema.description ??= text;
};
