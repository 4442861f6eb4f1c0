/**
 * What a robot's host cannot do. A simulated robot offers everything; a physical one may have no way
 * to measure its pose. Safety (stop, leases, time to live, one ending) can never be missing.
 */
import { z } from "zod";

/** What a host may do without. */
export const hostFeatures = [
  "pose",
  "speed",
  "bumps",
  "goal",
  "maze",
  "websocket",
  "long-poll",
] as const;
export type HostFeature = (typeof hostFeatures)[number];

export const featureListSchema = z.strictObject({
  notOffered: z
    .array(
      z.strictObject({
        feature: z.enum(hostFeatures, { error: `one of ${hostFeatures.join(", ")}` }),
        /** why, as a sentence */
        reason: z.string().min(1).max(200),
      }),
    )
    .max(hostFeatures.length),
});
export type FeatureList = z.infer<typeof featureListSchema>;
