/** Problem documents (RFC 9457), the format of all errors of the service. */
import { z } from "zod";

export const fieldProblemSchema = z.strictObject({
  path: z.string(),
  found: z.string(),
  expected: z.string(),
});

export const problemSchema = z.strictObject({
  /** a URL path that names the kind of problem, such as /problems/bad-request */
  type: z.string(),
  title: z.string(),
  status: z.int().min(400).max(599),
  /** what happened and how to fix it, in one or two sentences */
  detail: z.string(),
  errors: z.array(fieldProblemSchema),
});
export type ProblemDocument = z.infer<typeof problemSchema>;
