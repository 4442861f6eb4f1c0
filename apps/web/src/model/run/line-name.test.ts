import { describe, expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { lineName, lineNamer } from "./line-name.ts";
import type { LineState, ShownTruth } from "./line-state.ts";

const { t } = createI18n(en);
const line = {
  index: 1,
  rule: { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
  advice: null,
} as const;
const truths: (ShownTruth | null)[] = [
  null,
  { isTrue: true, left: "250.5", right: "> 60" },
  { isTrue: false, left: "50", right: "> 60" },
];

describe("the name of a line that runs", () => {
  it.each(["resting", "running", "bumped", "notRead"] satisfies LineState[])(
    "is what a line that is %s is called, whatever its numbers",
    (state) => {
      const nameOf = lineNamer(t, "en", line);
      for (const truth of [...truths, ...truths]) {
        expect(nameOf(state, truth)).toBe(lineName(t, { ...line, state, truth }));
      }
    },
  );

  it("contains its state, its sentence and its truth", () => {
    expect(lineNamer(t, "en", line)("running", truths[1] ?? null)).toBe(
      "Line 2, running: if right is more than 60, delayed right 90. Right is 250.5, true.",
    );
  });
});
