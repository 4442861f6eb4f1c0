/** Arabic. */
import language from "./language.json" with { type: "json" };

export const ar = { language };
