/**
 * Removes the keys from the elements of the icons. React needs them only in development, and random
 * keys compress badly.
 */
import type { Plugin } from "vite";

const ICON = /\/lucide-react\/dist\/esm\/icons\/[\w-]+\.m?js$/;

export function leanIcons(): Plugin {
  return {
    name: "corridor-lean-icons",
    apply: "build",
    transform: {
      filter: { id: ICON },
      handler: (code) => ({ code: code.replaceAll(/, key: "\w+"/g, ""), map: null }),
    },
  };
}
