import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { publishFiles } from "./publish.ts";

function withFolder() {
  const served = mkdtempSync(join(tmpdir(), "corridor-publish-"));
  onTestFinished(() => rmSync(served, { recursive: true }));
  const built = join(served, ".next");
  return {
    /** publishes a build of these files */
    publish: (files: Record<string, string>): void => {
      for (const [file, text] of Object.entries(files)) {
        mkdirSync(dirname(join(built, file)), { recursive: true });
        writeFileSync(join(built, file), text);
      }
      publishFiles(built, served);
    },
    read: (file: string) =>
      existsSync(join(served, file)) ? readFileSync(join(served, file), "utf8") : null,
  };
}

it("replaces the page and retains the parts of the previous build for open pages", () => {
  const { publish, read } = withFolder();
  publish({ "index.html": "1", "assets/page-1.js": "1", "assets/same-0.js": "0", "old.txt": "" });
  publish({ "index.html": "2", "assets/page-2.js": "2", "assets/same-0.js": "0" });
  expect(read("index.html")).toBe("2");
  expect([read("assets/page-1.js"), read("assets/page-2.js")]).toEqual(["1", "2"]);
  expect(read("assets/same-0.js")).toBe("0");
  expect(read("old.txt")).toBeNull();
  expect(read(".next")).toBeNull();
});

it("deletes the parts of a page that was replaced twice", () => {
  const { publish, read } = withFolder();
  publish({ "index.html": "1", "assets/page-1.js": "1" });
  publish({ "index.html": "2", "assets/page-2.js": "2" });
  publish({ "index.html": "3", "assets/page-3.js": "3" });
  expect(read("assets/page-1.js")).toBeNull();
  expect([read("assets/page-2.js"), read("assets/page-3.js")]).toEqual(["2", "3"]);
});
