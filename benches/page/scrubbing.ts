/** Going to any moment of an hour's run, and what the hour holds of the page's memory. */
import type { Goal } from "../core/goals.ts";
import { scrubReport } from "./scrub.ts";
import type { Section } from "./section.ts";

const MEBIBYTE = 2 ** 20;

export const scrubbing: Section = {
  title: "Scrubbing",
  measure: () => {
    const goals = scrubReport().flatMap(({ name, p50, p99, worst, bytes, counted }): Goal[] => {
      const times = [p50, p99, worst].map((each) => each.toFixed(2)).join(" / ");
      const sizes = [bytes, counted].map((each) => (each / MEBIBYTE).toFixed(1)).join(" / ");
      console.log(`  ${name}: p50 / p99 / worst ${times} ms; held / counted ${sizes} MiB`);
      return [
        {
          words: `to any moment of an hour, ${name}, p99`,
          measured: p99,
          bound: { atMost: 50 },
          unit: "ms",
        },
        {
          words: `an hour, ${name}`,
          measured: bytes / MEBIBYTE,
          bound: { atMost: 64 },
          unit: "MiB",
        },
      ];
    });
    return Promise.resolve(goals);
  },
};
