import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { SPEECH_INTERVAL_MS, SpeechQueue, type Utterance } from "./speech-queue.ts";

const chatter = (text: string, about: string | null = text): Utterance => ({
  text,
  kind: "chatter",
  about,
});
const news = (text: string, about: string | null = null): Utterance => ({
  text,
  kind: "news",
  about,
});

/** The announcements of a queue that is read every 100 ms, with utterances at given times. */
function heard(comes: readonly (readonly [at: number, utterance: Utterance])[]): string[] {
  const queue = new SpeechQueue();
  const said: string[] = [];
  for (let now = 0; now <= 10_000; now += 100) {
    for (const [at, utterance] of comes) if (at === now) queue.offer(utterance);
    const text = queue.take(now);
    if (text !== null) said.push(`${now} ${text}`);
  }
  return said;
}

describe("SpeechQueue", () => {
  it.each([
    {
      title: "says the first at once and the next a second later",
      comes: [
        [0, chatter("line 1")],
        [100, chatter("line 2")],
      ],
      said: ["0 line 1", "1000 line 2"],
    },
    {
      title: "says the newest of what came in between",
      comes: [
        [0, chatter("line 1")],
        [200, chatter("line 2")],
        [600, chatter("line 3")],
      ],
      said: ["0 line 1", "1000 line 3"],
    },
    {
      title: "says nothing when it is again as it was said last",
      comes: [
        [0, chatter("line 1")],
        [200, chatter("line 2")],
        [600, chatter("line 1")],
        [3000, chatter("line 1")],
      ],
      said: ["0 line 1"],
    },
    {
      title: "says each turn, also one like the last",
      comes: [
        [0, chatter("right 90", null)],
        [2000, chatter("right 90", null)],
      ],
      said: ["0 right 90", "2000 right 90"],
    },
    {
      title: "lets news pass before chatter, which is then out of date",
      comes: [
        [0, chatter("line 1")],
        [200, chatter("line 2")],
        [300, news("bump")],
      ],
      said: ["0 line 1", "1000 bump"],
    },
    {
      title: "says all news in their order, one a second",
      comes: [
        [0, news("bump")],
        [0, news("advice")],
        [100, chatter("line 1")],
        [200, news("goal")],
      ],
      said: ["0 bump", "1000 advice", "2000 goal"],
    },
    {
      title: "says of news about the same thing only the newest",
      comes: [
        [0, news("block", "square")],
        [300, news("open", "square")],
        [600, news("block again", "square")],
      ],
      said: ["0 block", "1000 block again"],
    },
  ] satisfies {
    title: string;
    comes: (readonly [number, Utterance])[];
    said: string[];
  }[])("$title", ({ comes, said }) => {
    expect(heard(comes)).toEqual(said);
  });

  it("says nothing while nothing comes", () => {
    expect(heard([])).toEqual([]);
    expect(new SpeechQueue().rest(0)).toBeNull();
  });

  it("forgets chatter on demand, and may say a state again", () => {
    const queue = new SpeechQueue();
    queue.offer(chatter("line 1"));
    expect(queue.take(0)).toBe("line 1");
    queue.offer(chatter("line 2"));
    queue.dropChatter();
    expect(queue.take(5000)).toBeNull();
    queue.offer(chatter("line 1"));
    expect(queue.take(5000)).toBeNull();
    queue.forgetState();
    queue.offer(chatter("line 1"));
    expect(queue.take(5000)).toBe("line 1");
  });

  it("never says two things within a second", () => {
    const utterance = fc.record({
      text: fc.constantFrom("a", "b", "c"),
      kind: fc.constantFrom("chatter" as const, "news" as const),
      about: fc.constant(null),
    });
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.integer({ min: 0, max: 80 }), utterance), { maxLength: 40 }),
        (all) => {
          const comes = all.map(([at, each]) => [at * 100, each] as const);
          const times = heard(comes).map((entry) => Number(entry.split(" ")[0]));
          const gaps = times.slice(1).map((time, at) => time - (times[at] ?? 0));
          expect(Math.min(Infinity, ...gaps)).toBeGreaterThanOrEqual(SPEECH_INTERVAL_MS);
          expect(times.length > 0).toBe(comes.length > 0);
        },
      ),
    );
  });
});
