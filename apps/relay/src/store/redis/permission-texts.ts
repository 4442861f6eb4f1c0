/** The keys and the blocked scripts of a robot, as JSON in its hash. */
import { z } from "zod";
import { keyKinds } from "../../commands/robot-step.ts";

const keyText = z.object({
  kind: z.enum(keyKinds),
  hash: z.string(),
  use: z.literal("url").exactOptional(),
});

export const keysText = z
  .string()
  .transform((text): unknown => JSON.parse(text))
  .pipe(z.array(keyText));
export const blockedText = z
  .string()
  .transform((text): unknown => JSON.parse(text))
  .pipe(
    z.array(
      z.object({
        id: z.string(),
        driver: z.string(),
        name: z.string().nullable(),
        client: z.string(),
      }),
    ),
  );
