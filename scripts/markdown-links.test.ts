/** Links between the Markdown files of the repository. */
import { existsSync, globSync, readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { describe, expect, it } from "vitest";

const ROOT = join(import.meta.dirname, "..");
const files = globSync("{*,{apps,docs,e2e,examples,packages}/**/*}.md", {
  cwd: ROOT,
  exclude: ["**/node_modules", "**/dist"],
});

/** The text of a file without its blocks of code. */
function textOf(file: string): string {
  return readFileSync(join(ROOT, file), "utf8").replaceAll(/^ *```[^]*?^ *```$/gm, "");
}

/** The anchors of the headings of a file, as GitHub creates them. */
function anchorsIn(file: string): string[] {
  const headings = [...textOf(file).matchAll(/^#+ (.*)$/gm)].map(([, words = ""]) => words);
  return headings.map((words) =>
    words
      .toLowerCase()
      .replaceAll(/[^\p{L}\p{N} _-]/gu, "")
      .replaceAll(" ", "-"),
  );
}

/** The links of a file that lead nowhere. */
function brokenLinksIn(file: string): string[] {
  const links = [...textOf(file).matchAll(/\]\(([^)\s]+)\)/g)].map(([, link = ""]) => link);
  return links.filter((link) => {
    if (/^(?:https?:|\/)/.test(link)) return false;
    const [path = "", anchor] = link.split("#");
    const target = path === "" ? file : posix.join(posix.dirname(file), path);
    if (!existsSync(join(ROOT, target))) return true;
    return anchor !== undefined && !anchorsIn(target).includes(anchor);
  });
}

describe("links in Markdown files", () => {
  it.each(files)("lead to existing files and headings: %s", (file) => {
    expect(brokenLinksIn(file)).toEqual([]);
  });

  it("are checked in the files that readers start from", () => {
    expect(files).toEqual(expect.arrayContaining(["README.md", "docs/operations.md"]));
  });
});
