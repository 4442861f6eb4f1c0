/**
 * The messages between the page in a frame and the site around it. Messages of both sides contain
 * `corridor: 1`. docs/lms.md describes them for authors of sites.
 */
import { z } from "zod";
import { MAX_LINK_LENGTH } from "./link-length.ts";
import { shortLinkIdSchema } from "./short-link.ts";

const corridor = z.literal(1);

/** What the site may ask for. */
const frameRequestSchema = z.union([
  z.object({
    corridor,
    type: z.literal("open"),
    /** the part of a link after its `#` */
    link: z.string().min(1).max(MAX_LINK_LENGTH),
  }),
  z.object({
    corridor,
    type: z.literal("open"),
    /** the id of a short link */
    id: shortLinkIdSchema,
  }),
  z.object({ corridor, type: z.enum(["run", "stop", "reset"]) }),
]);
export type FrameRequest = z.infer<typeof frameRequestSchema>;

/** @returns null for anything that is not a request */
export function readFrameRequest(data: unknown): FrameRequest | null {
  // Most messages of a site are for others.
  if (typeof data !== "object" || data === null || !("corridor" in data)) return null;
  const result = frameRequestSchema.safeParse(data);
  return result.success ? result.data : null;
}

/** Why a link did not open. */
export type FrameProblem = "none" | "broken" | "newer" | "gone" | "wait" | "offline";

/** What the page reports. Times are simulated seconds, tasks and lines count from 1. */
export type FrameReport =
  | { type: "ready" }
  /** of the page's content, in CSS pixels */
  | { type: "size"; width: number; height: number }
  | { type: "opened"; ok: true; name: string; tasks: number }
  | { type: "opened"; ok: false; problem: FrameProblem }
  /** a run has begun at the start; `attempts` counts them */
  | { type: "run"; attempts: number }
  /** `line`: the one that drove; null for the action "otherwise" or a drive by hand */
  | { type: "bump"; seconds: number; bumps: number; line: number | null }
  | { type: "failed"; task: number; code: string; seconds: number; attempts: number }
  | {
      type: "met";
      task: number;
      lines: number;
      seconds: number;
      bumps: number;
      attempts: number;
      /** completion code; null for a maze without a lesson, or if it would be too long */
      code: string | null;
    };
