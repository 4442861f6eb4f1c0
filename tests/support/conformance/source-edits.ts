/** Replacements in the Python source of the physical robot example. */
import { readFileSync } from "node:fs";
import { join } from "node:path";

export const EXAMPLE = join(import.meta.dirname, "../../../examples/physical-robot");

const sources = new Map<string, string>();

/** A replacement in a Python file. The text must occur exactly once. */
export interface Edit {
  file: string;
  before: string;
  after: string;
}

/** Texts of changed files by their path in the example. */
export type EditedFiles = ReadonlyMap<string, string>;

/**
 * Applies edits in their order.
 * @param base files with earlier edits
 * @throws Error unless each text occurs exactly once
 */
export function editedFiles(
  edits: readonly Edit[],
  base: EditedFiles = new Map<string, string>(),
): EditedFiles {
  const files = new Map(base);
  for (const { file, before, after } of edits) {
    const parts = (files.get(file) ?? sourceOf(file)).split(before);
    if (parts.length !== 2) {
      throw new Error(`${file} contains this text ${parts.length - 1} times, not once: ${before}`);
    }
    files.set(file, parts.join(after));
  }
  return files;
}

function sourceOf(file: string): string {
  const source = sources.get(file) ?? readFileSync(join(EXAMPLE, file), "utf8");
  sources.set(file, source);
  return source;
}
