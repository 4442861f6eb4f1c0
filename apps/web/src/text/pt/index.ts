/** Portuguese. */
import type { Words } from "../words.ts";

export const files = import.meta.glob<Words>(["./*.json", "!./missions.json", "!./watch.json"], {
  eager: true,
  import: "default",
});
