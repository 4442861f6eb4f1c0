/**
 * Inlines the short names of classes in components. A stylesheet's table of names would load with
 * its first component, with the names of components that load later or never. A component that
 * names its classes one by one imports each name instead, and the bundler inlines it.
 */
import type { Plugin } from "vite";

const STYLES = /\.module\.css$/;
const COMPONENT = /\/src\/.*\.tsx$/;
const IMPORT = /import (\w+) from ("[^"]+\.module\.css");/g;

export function leanClasses(): Plugin {
  return {
    name: "corridor-lean-classes",
    apply: "build",
    enforce: "post",
    transform: {
      filter: { id: [STYLES, COMPONENT] },
      handler: (code, id) =>
        STYLES.test(id)
          ? // The rules are needed even if no name of the module is used.
            { code, map: null, moduleSideEffects: "no-treeshake" }
          : { code: importOneByOne(code), map: null },
    },
  };
}

/** A computed name, as in `styles[kind]`, needs the whole table. */
export function importOneByOne(code: string): string {
  return code.replaceAll(IMPORT, (statement, table: string, path: string) =>
    new RegExp(`\\b${table}\\[(?!["'])`).test(code)
      ? statement
      : `import * as ${table} from ${path};`,
  );
}
