/**
 * Every class name in a component exists in its stylesheet, and few components need a table of
 * names.
 */
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { expect, test } from "vitest";
import { importOneByOne } from "./lean-classes.ts";

const root = join(import.meta.dirname, "../src");

test("a component that names its classes one by one brings no table of them", () => {
  const component = `import styles from "./a.module.css";
import frame from "./b.module.css";
use(styles["line"], frame[kind]);`;
  expect(importOneByOne(component)).toBe(`import * as styles from "./a.module.css";
import frame from "./b.module.css";
use(styles["line"], frame[kind]);`);
});

test("every class that a component names stands in its stylesheet", () => {
  const components = readdirSync(root, { recursive: true, encoding: "utf8" }).filter((file) =>
    file.endsWith(".tsx"),
  );
  const missing = components.flatMap((file) => {
    const code = readFileSync(join(root, file), "utf8");
    const imports = code.matchAll(/import (\w+) from "([^"]+\.module\.css)";/g);
    return [...imports].flatMap(([, table = "", path = ""]) => {
      const rules = readFileSync(join(root, dirname(file), path), "utf8");
      const named = code.matchAll(new RegExp(`\\b${table}\\["(\\w+)"\\]`, "g"));
      return [...named]
        .map(([, name = ""]) => name)
        .filter((name) => !new RegExp(`\\.${name}\\b`).test(rules))
        .map((name) => `${file}: ${name}`);
    });
  });
  expect(missing).toEqual([]);
});
