/** Published links with their content. They must stay readable: add links, never change one. */
import { readFileSync } from "node:fs";
import type { LinkContent } from "../link.ts";

export interface GoldenLink {
  name: string;
  text: string;
  content: LinkContent;
}

const file = new URL("golden-links.json", import.meta.url);

export const goldenLinks = JSON.parse(readFileSync(file, "utf8")) as readonly GoldenLink[];
