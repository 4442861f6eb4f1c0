/**
 * Tells the page's first script, which is no part of the bundle, where the simulator worker is, so
 * that the worker starts while the page's own script is still on its way.
 */
import type { Plugin } from "vite";

const WORKER = /(?:^|\/)simulator\.worker-[\w-]+\.js$/;

export function firstScript(): Plugin {
  return {
    name: "corridor-first-script",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(html, { bundle = {} }) {
        const worker = Object.keys(bundle).find((file) => WORKER.test(file));
        if (worker === undefined) throw new Error("the build has no simulator worker");
        const told = html.replace("data-simulator", `data-simulator="/${worker}"`);
        if (told === html) throw new Error("index.html has no script with data-simulator");
        return told;
      },
    },
  };
}
