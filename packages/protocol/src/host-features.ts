/**
 * Optional features of a robot's host. A simulated robot offers all; a physical robot may be unable
 * to measure its pose. Safety features (stop, leases, time to live, one ending) are not optional.
 */
import { z } from "zod";

/** Features that a host may lack. */
export const hostFeatures = [
  "pose",
  "speed",
  "bumps",
  "goal",
  "maze",
  "reset",
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
