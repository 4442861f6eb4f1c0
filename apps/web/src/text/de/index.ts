/** German. */
import language from "./language.json" with { type: "json" };

export const de = { language };
