/** What a relay, SQLite or Redis has written into a folder. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** The texts that are in any file of the folder. */
export function textsInFiles(folder: string, texts: readonly string[]): string[] {
  const files = readFiles(folder);
  return texts.filter((text) => files.some((bytes) => bytes.includes(text)));
}

/** All files of one moment: Redis and SQLite replace files, so a listed file can be gone. */
function readFiles(folder: string): Buffer[] {
  for (;;)
    try {
      return readdirSync(folder, { recursive: true, withFileTypes: true })
        .filter((entry) => entry.isFile())
        .map(({ parentPath, name }) => readFileSync(join(parentPath, name)));
    } catch (error) {
      if (!(error instanceof Error && "code" in error && error.code === "ENOENT")) throw error;
    }
}
