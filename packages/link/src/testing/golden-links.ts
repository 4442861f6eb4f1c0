/** Links that have been given out, with what they carry: they stay readable for ever. Add, never change. */
import { readFileSync } from "node:fs";
import type { LinkContent } from "../link.ts";

export interface GoldenLink {
  name: string;
  text: string;
  content: LinkContent;
}

const file = new URL("golden-links.json", import.meta.url);

export const goldenLinks = JSON.parse(readFileSync(file, "utf8")) as readonly GoldenLink[];
