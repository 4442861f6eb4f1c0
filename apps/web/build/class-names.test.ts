import { fileURLToPath } from "node:url";
import { expect, it, vi } from "vitest";

const dialog = fileURLToPath(new URL("../src/ui/dialog.module.css", import.meta.url));
const button = fileURLToPath(new URL("../src/ui/button.module.css", import.meta.url));

it("gives classes the same names in each build, independent of the order of files", async () => {
  const one = await import("./class-names.ts");
  const names = [one.scopedName("frame", dialog), one.scopedName("button", button)];
  vi.resetModules();
  const other = await import("./class-names.ts");
  expect([other.scopedName("button", button), other.scopedName("frame", dialog)]).toEqual(
    names.toReversed(),
  );
  expect(new Set([...names, other.scopedName("appear", dialog)]).size).toBe(3);
});

it("throws for a class that no file contains", async () => {
  const { scopedName } = await import("./class-names.ts");
  expect(() => scopedName("nowhere", dialog)).toThrow("has no class nowhere");
});
