import type { Diagnosis } from "@corridor/coach";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import reasons from "../../text/en/diagnosis.json" with { type: "json" };
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import {
  diagnosisText,
  diagnosisTitle,
  diagnosisWords,
  roomText,
  statesOtherRoom,
} from "./diagnosis-text.ts";

const readings = { front: 49.6, right: 50, back: 250, left: 250 };
const when = { sensor: "front" as const, is: "<" as const, than: 60 };
const moment = { tick: 100, line: 1, when, action: "delayed left 90" as const, readings };
const contact = { x: 400, y: 150, cell: { column: 4, row: 1 }, isCorner: false };
const bump = {
  kind: "bump" as const,
  tick: 130,
  line: 1,
  action: "delayed left 90" as const,
  phase: "delay" as const,
  side: "front" as const,
  decidedAt: 100,
  startedAt: 100,
  reading: 49.6,
  needs: 75,
  contact,
};
const diagnosis: Diagnosis = {
  event: bump,
  cause: { kind: "delayed", moment, side: "left", needs: 75 },
  fixes: [{ kind: "action", line: 1, action: "left 90" }],
};

/** Creates the words as a component does. The first namespace is not that of the page. */
function wordsFor(namespaces: ["diagnosis", "words"] | ["missions", "words"]) {
  const i18n = createI18n(en);
  i18n.addResourceBundle("en", "diagnosis", reasons);
  return diagnosisWords(i18n.getFixedT("en", namespaces[0]), "en");
}

describe("the words of a diagnosis", () => {
  it.each([[["diagnosis", "words"]], [["missions", "words"]]] as const)(
    "are whole sentences for a translator of %j",
    (namespaces) => {
      const words = wordsFor([...namespaces]);
      expect(diagnosisTitle(words, diagnosis)).toBe("Bump: look at line 2");
      expect(diagnosisText(words, diagnosis)).toBe(
        "Bump at 2.1 s. Line 2 chose “delayed left 90” at 1.6 s with 50 cm in front. It drives on first and needs 75 cm.",
      );
    },
  );

  it("state what happened where no cause is known, and blame no line", () => {
    const words = wordsFor(["diagnosis", "words"]);
    const facts: Diagnosis = { event: bump, cause: null, fixes: [] };
    expect(diagnosisTitle(words, facts)).toBe("Bump");
    expect(diagnosisText(words, facts)).toBe(
      "Bump at 2.1 s. “delayed left 90” drives on first and needs 75 cm ahead. Front read 50 cm. Line 2 decided at 1.6 s.",
    );
  });

  it("name the line that decided last as a fact where a steady motion ended at a wall", () => {
    const words = wordsFor(["diagnosis", "words"]);
    const event = {
      ...bump,
      action: "forward" as const,
      phase: "steady" as const,
      line: "default" as const,
      decidedAt: 129,
      reading: 250,
      needs: null,
    };
    const facts: Diagnosis = { event, cause: null, fixes: [] };
    expect(diagnosisTitle(words, facts)).toBe("Bump");
    expect(diagnosisText(words, facts)).toBe(
      "Bump at 2.1 s. The robot started to drive forward at 1.6 s. The wall was 250 cm ahead then. “otherwise” decided last.",
    );
  });

  it("state the seconds of the clock, which excludes waits for a script", () => {
    const words = { ...wordsFor(["diagnosis", "words"]), waited: (tick: number) => tick - 60 };
    const facts: Diagnosis = { event: bump, cause: null, fixes: [] };
    expect(diagnosisText(words, facts)).toMatch(/^Bump at 1\.0 s\./);
  });

  it.each([
    { side: "front" as const, text: "“move 2000” needed 2025 cm ahead. Front read 50 cm." },
    { side: "back" as const, text: "“move -2000” needed 2025 cm behind. Back read 50 cm." },
  ])("name a command of a script as its list does ($side)", ({ side, text }) => {
    const words = wordsFor(["diagnosis", "words"]);
    const move = { action: "move" as const, phase: "measured" as const, line: null, needs: 2025 };
    const facts: Diagnosis = { event: { ...bump, ...move, side }, cause: null, fixes: [] };
    expect(diagnosisText(words, facts)).toBe(`Bump at 2.1 s. ${text}`);
  });

  it("name a corner that the beam passes", () => {
    const words = wordsFor(["diagnosis", "words"]);
    const event = {
      ...bump,
      phase: "steady" as const,
      needs: null,
      reading: 250,
      contact: { ...contact, isCorner: true },
    };
    expect(diagnosisText(words, { event, cause: null, fixes: [] })).toBe(
      "Bump at 2.1 s. The robot started to drive forward at 1.6 s. The wall was 250 cm ahead then. The robot touched the corner of a block. The robot is 50 cm wide, and its beam is thin. Line 2 decided last.",
    );
  });
});

describe("one reading", () => {
  /** A delayed turn whose line was true just below its number. */
  function justBelow(front: number, than: number, needs: number): Diagnosis {
    const nearly = { ...moment, when: { ...when, than }, readings: { ...readings, front } };
    return {
      event: { ...bump, reading: front, needs },
      cause: { kind: "delayed", moment: nearly, side: "left", needs },
      fixes: [],
    };
  }

  it("is the same number in the sentence and above the bars", () => {
    const words = wordsFor(["diagnosis", "words"]);
    const { event, cause } = justBelow(49.999_999, 50, 75);
    if (event.kind !== "bump") throw new Error("no bump");
    expect(diagnosisText(words, { event, cause, fixes: [] })).toContain("with 49.99 cm in front.");
    expect(roomText(words, event, cause)).toEqual({ reading: "49.99", needs: "75" });
    expect(roomText(words, event, null)).toEqual({ reading: "50", needs: "75" });
  });

  it("is in the sentence only, if the robot bumped in a later part of the turn", () => {
    const { event, cause } = justBelow(48, 50, 75);
    if (event.kind !== "bump" || cause === null) throw new Error("no bump");
    expect(statesOtherRoom(event, cause)).toBe(false);
    const wayOut = { ...event, phase: "way-out" as const, startedAt: event.startedAt + 50 };
    expect(statesOtherRoom({ ...wayOut, needs: 85, reading: 50 }, cause)).toBe(true);
  });

  it("is the same number for every reading and every number of the line", () => {
    const words = wordsFor(["diagnosis", "words"]);
    const cm = fc.double({ min: 25, max: 74.999, noNaN: true });
    fc.assert(
      fc.property(cm, fc.double({ min: 1e-9, max: 2, noNaN: true }), (front, more) => {
        const { event, cause } = justBelow(front, front + more, 75);
        if (event.kind !== "bump") throw new Error("no bump");
        const [, inText] =
          /with ([\d.]+) cm/.exec(diagnosisText(words, { event, cause, fixes: [] })) ?? [];
        expect(roomText(words, event, cause).reading).toBe(inText);
      }),
    );
  });
});
