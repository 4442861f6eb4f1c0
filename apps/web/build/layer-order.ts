/**
 * Prepends the order of the cascade layers to each stylesheet of the build. The first stylesheet
 * that a browser reads decides the order. Which one that is depends on how the bundler splits the
 * stylesheets.
 */
import type { Plugin } from "vite";

/** The same order as in src/ui/base.css. */
export const ORDER = "@layer base,ui,features,reader;";

export function layerOrder(): Plugin {
  return {
    name: "corridor-layer-order",
    apply: "build",
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        for (const file of Object.values(bundle)) {
          if (file.type !== "asset" || !file.fileName.endsWith(".css")) continue;
          file.source = `${ORDER}${textOf(file.source)}`;
        }
      },
    },
  };
}

function textOf(source: string | Uint8Array): string {
  return typeof source === "string" ? source : new TextDecoder().decode(source);
}
