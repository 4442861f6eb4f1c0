/**
 * Lets each stylesheet of the build begin with the order of the layers. The first sheet that a browser
 * reads decides it, and which one that is changes with what shares what: a part's own sheet may come
 * before the one that has the statement.
 */
import type { Plugin } from "vite";

/** As in src/ui/base.css. */
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
