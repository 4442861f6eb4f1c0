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

it("fails if a package has no license file", async () => {
  const file = join(modules, "@redis/client/dist/index.js");
  await expect(bundledLicenses([file])).rejects.toThrow("@redis/client has no license file");
});
