import { closeReasons } from "@corridor/protocol";
import type { ClassEnding } from "./class-messages.ts";

/** @param code a close code without retry */
export function endingOf(code: number): ClassEnding {
  if (code === closeReasons.replaced.code) return "replaced";
  return code === closeReasons.over.code ? "over" : "removed";
}
