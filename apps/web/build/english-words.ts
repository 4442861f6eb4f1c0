/**
 * Emits the English texts as a JSON file beside the page's script. The browser fetches both in
 * parallel, and parses JSON several times as fast as the same texts in a script.
 */
import type { Plugin } from "vite";
import { en } from "../src/text/en/index.ts";

const NAME = "virtual:english-words-address";
const FILE = /(?:^|\/)words-en-[\w-]+\.json$/;

export function englishWords(): Plugin {
  return {
    name: "corridor-english-words",
    resolveId: (id) => (id === NAME ? `\0${NAME}` : null),
    load(id) {
      if (id !== `\0${NAME}`) return null;
      // In development the texts are a module, so that an edit is displayed at once.
      if (this.environment.mode === "dev") return `export default ""`;
      const file = this.emitFile({
        type: "asset",
        name: "words-en.json",
        source: JSON.stringify(en),
      });
      return `export default import.meta.ROLLUP_FILE_URL_${file}`;
    },
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle }) {
        const file = Object.keys(bundle ?? {}).find((name) => FILE.test(name));
        if (file === undefined) return [];
        const attrs = {
          rel: "preload",
          href: `/${file}`,
          as: "fetch",
          crossorigin: true,
          fetchpriority: "low",
        };
        return [{ tag: "link", attrs, injectTo: "head" }];
      },
    },
  };
}
