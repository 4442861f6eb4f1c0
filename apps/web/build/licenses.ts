/** Serves the licenses of all packages in the page, its workers and its fonts as one file. */
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { bundledLicenses } from "../../../scripts/bundled-licenses.ts";

const FILE = "third-party-licenses.txt";

/** Packages whose files are not modules of these builds: the font, and the service worker's code. */
const others = [
  "@fontsource-variable/inter/package.json",
  "workbox-core/package.json",
  "workbox-expiration/package.json",
  "workbox-precaching/package.json",
  "workbox-routing/package.json",
  "workbox-strategies/package.json",
].map((file) => fileURLToPath(import.meta.resolve(file)));

/** @returns the plugin for the page, and the plugin for its workers, which are built before it */
export function licenses(): { page: Plugin; worker: () => Plugin } {
  const modules = new Set<string>(others);
  const collect = (ids: Iterable<string>): void => {
    for (const id of ids) modules.add(id);
  };
  return {
    page: {
      name: "corridor-licenses",
      apply: "build",
      async generateBundle() {
        collect(this.getModuleIds());
        const source = await bundledLicenses([...modules]);
        this.emitFile({ type: "asset", fileName: FILE, source });
      },
    },
    worker: () => ({
      name: "corridor-worker-licenses",
      generateBundle() {
        collect(this.getModuleIds());
      },
    }),
  };
}
