import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { SPEECH_INTERVAL_MS, SpeechQueue, type Utterance } from "./speech-queue.ts";

const state = (text: string, about: string | null = text): Utterance => ({
  text,
  kind: "state",
  about,
});
const event = (text: string, about: string | null = null): Utterance => ({
  text,
  kind: "event",
  about,
});

/** The announcements of a queue that is read every 100 ms, with utterances at given times. */
function announcementsOf(
  comes: readonly (readonly [at: number, utterance: Utterance])[],
): string[] {
  const queue = new SpeechQueue();
  const announced: string[] = [];
  for (let now = 0; now <= 10_000; now += 100) {
    for (const [at, utterance] of comes) if (at === now) queue.offer(utterance);
    const text = queue.take(now);
    if (text !== null) announced.push(`${now} ${text}`);
  }
  return announced;
}

describe("SpeechQueue", () => {
  it.each([
    {
      title: "says the first at once and the next a second later",
      comes: [
        [0, state("line 1")],
        [100, state("line 2")],
      ],
      announced: ["0 line 1", "1000 line 2"],
    },
    {
      title: "says the newest of what came in between",
      comes: [
        [0, state("line 1")],
        [200, state("line 2")],
        [600, state("line 3")],
      ],
      announced: ["0 line 1", "1000 line 3"],
    },
    {
      title: "says nothing when it is again as it was announced last",
      comes: [
        [0, state("line 1")],
        [200, state("line 2")],
        [600, state("line 1")],
        [3000, state("line 1")],
      ],
      announced: ["0 line 1"],
    },
    {
      title: "says each turn, also one like the last",
      comes: [
        [0, state("right 90", null)],
        [2000, state("right 90", null)],
      ],
      announced: ["0 right 90", "2000 right 90"],
    },
    {
      title: "announces an event before a state, which is then out of date",
      comes: [
        [0, state("line 1")],
        [200, state("line 2")],
        [300, event("bump")],
      ],
      announced: ["0 line 1", "1000 bump"],
    },
    {
      title: "announces all events in their order, one a second",
      comes: [
        [0, event("bump")],
        [0, event("advice")],
        [100, state("line 1")],
        [200, event("goal")],
      ],
      announced: ["0 bump", "1000 advice", "2000 goal"],
    },
    {
      title: "announces only the newest of the events about one subject",
      comes: [
        [0, event("block", "square")],
        [300, event("open", "square")],
        [600, event("block again", "square")],
      ],
      announced: ["0 block", "1000 block again"],
    },
  ] satisfies {
    title: string;
    comes: (readonly [number, Utterance])[];
    announced: string[];
  }[])("$title", ({ comes, announced }) => {
    expect(announcementsOf(comes)).toEqual(announced);
  });

  it("announces nothing while nothing is pending", () => {
    expect(announcementsOf([])).toEqual([]);
    expect(new SpeechQueue().rest(0)).toBeNull();
  });

  it("drops a pending state on demand, and may announce a state again", () => {
    const queue = new SpeechQueue();
    queue.offer(state("line 1"));
    expect(queue.take(0)).toBe("line 1");
    queue.offer(state("line 2"));
    queue.dropState();
    expect(queue.take(5000)).toBeNull();
    queue.offer(state("line 1"));
    expect(queue.take(5000)).toBeNull();
    queue.allowRepeat();
    queue.offer(state("line 1"));
    expect(queue.take(5000)).toBe("line 1");
  });

  it("never announces two texts within a second", () => {
    const utterance = fc.record({
      text: fc.constantFrom("a", "b", "c"),
      kind: fc.constantFrom("state" as const, "event" as const),
      about: fc.constant(null),
    });
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.integer({ min: 0, max: 80 }), utterance), { maxLength: 40 }),
        (all) => {
          const comes = all.map(([at, each]) => [at * 100, each] as const);
          const times = announcementsOf(comes).map((entry) => Number(entry.split(" ")[0]));
          const gaps = times.slice(1).map((time, at) => time - (times[at] ?? 0));
          expect(Math.min(Infinity, ...gaps)).toBeGreaterThanOrEqual(SPEECH_INTERVAL_MS);
          expect(times.length > 0).toBe(comes.length > 0);
        },
      ),
    );
  });
});
