import { globSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { bundledLicenses } from "./bundled-licenses.ts";

const modules = join(import.meta.dirname, "../node_modules");

it("lists each package of the modules once, by name, with its version and license", async () => {
  const files = ["react/index.js", "@fontsource-variable/inter/index.css", "react/jsx-runtime.js"];
  const text = await bundledLicenses([
    ...files.map((file) => join(modules, file)),
    join(import.meta.dirname, "own-file.ts"),
  ]);
  expect(text).toMatch(/^@fontsource-variable\/inter [\d.]+\n\n[^]*\n---\n\nreact [\d.]+\n\nMIT/);
  expect(text).toContain("SIL OPEN FONT LICENSE");
  expect(text.match(/^react /gm)).toHaveLength(1);
});

it("lists the packages that a package has copied into its files", async () => {
  const folder = "@modelcontextprotocol/server/dist";
  const [file = ""] = globSync("ajvProvider-*.mjs", { cwd: join(modules, folder) });
  const text = await bundledLicenses([join(modules, folder, file)]);
  for (const name of ["@modelcontextprotocol/server", "ajv", "ajv-formats", "fast-uri"]) {
    expect(text).toMatch(new RegExp(`^${name} \\d`, "m"));
  }
});

it("fails if a package has no license file", async () => {
  const file = join(modules, "@redis/client/dist/index.js");
  await expect(bundledLicenses([file])).rejects.toThrow("@redis/client has no license file");
});
