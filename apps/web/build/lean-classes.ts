/**
 * Puts the short names of classes where they are used. A stylesheet's table of names would come along
 * with its first component, also for those that come later or never; a component that names its classes
 * one by one imports each by itself instead, and the bundler writes it in its place.
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
          ? // Its rules stay, though nothing of its script may be left.
            { code, map: null, moduleSideEffects: "no-treeshake" }
          : { code: importOneByOne(code), map: null },
    },
  };
}

/** A name that is computed, as in `styles[kind]`, needs the table. */
export function importOneByOne(code: string): string {
  return code.replaceAll(IMPORT, (statement, table: string, path: string) =>
    new RegExp(`\\b${table}\\[(?!["'])`).test(code)
      ? statement
      : `import * as ${table} from ${path};`,
  );
}
