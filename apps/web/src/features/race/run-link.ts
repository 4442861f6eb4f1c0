/** Decodes the run from a link that a student pastes. */
import { decodeLink } from "@corridor/link";
import type { RunDocument } from "@corridor/recording";
import { missionOfHash } from "../../model/address/mission-address.ts";

export type RunLink =
  | { ok: true; run: RunDocument }
  /** `not-a-run`: the address of something else; `broken`: a part is missing or changed */
  | { ok: false; refusal: "not-a-run" | "broken" };

/** @param text a whole link, or the part after its "#" */
export function readRunLink(text: string): RunLink {
  const link = text.trim();
  const at = link.indexOf("#");
  // The addresses of the page, of a short link and of a mission contain no run.
  const isPlain = at === -1 && /^https?:/i.test(link);
  if (isPlain || (at !== -1 && missionOfHash(link.slice(at)) !== null)) return refused("not-a-run");
  const read = decodeLink(link.slice(at + 1));
  if (!read.ok) return refused("broken");
  const { run } = read.value;
  return run === undefined ? refused("not-a-run") : { ok: true, run };
}

function refused(refusal: "not-a-run" | "broken"): RunLink {
  return { ok: false, refusal };
}
