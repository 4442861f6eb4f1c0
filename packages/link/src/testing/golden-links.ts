/** Published links with their content. They must stay readable: add links, never change one. */
import { readFileSync } from "node:fs";
import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import type { LinkContent } from "../link-body.ts";

export interface GoldenLink {
  name: string;
  text: string;
  content: LinkContent;
}

interface StoredLink {
  name: string;
  text: string;
  /** a challenge is a lesson of one task, as it was written */
  content: LinkContent & { challenge?: ChallengeDocument };
}

const file = new URL("golden-links.json", import.meta.url);
const stored = JSON.parse(readFileSync(file, "utf8")) as readonly StoredLink[];

export const goldenLinks: readonly GoldenLink[] = stored.map(
  ({ name, text, content: { challenge, ...content } }) => ({
    name,
    text,
    content: challenge === undefined ? content : { ...content, lesson: lessonOf(challenge) },
  }),
);
