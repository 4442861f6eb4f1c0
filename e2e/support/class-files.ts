/** The bytes that a relay stores of a class. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** The texts that are in any file of the data folder. */
export function textsInFiles(folder: string, texts: readonly string[]): string[] {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => readFileSync(join(parentPath, name)));
  return texts.filter((text) => files.some((bytes) => bytes.includes(text)));
}
