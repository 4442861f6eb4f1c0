/**
 * Takes the keys out of the icons' drawings. React asks for them only while Corridor is developed, and
 * since they are random they are what compresses worst of an icon.
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
