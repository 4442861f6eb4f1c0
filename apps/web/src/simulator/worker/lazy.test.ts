import { describe, expect, it } from "vitest";
import { Lazy } from "./lazy.ts";

/** A part whose attempts to load are ended by the test. */
function lazyPart() {
  const attempts: PromiseWithResolvers<string>[] = [];
  const story: string[] = [];
  const part = new Lazy(
    () => {
      const attempt = Promise.withResolvers<string>();
      attempts.push(attempt);
      return attempt.promise;
    },
    (work) => {
      try {
        work();
      } catch (error) {
        story.push(`fault: ${String(error)}`);
      }
    },
  );
  const use = (name: string, then?: () => void): void =>
    part.use(
      (loaded) => {
        story.push(`${name} uses ${loaded}`);
        then?.();
      },
      (error) => {
        story.push(`${name} fails: ${String(error)}`);
        then?.();
      },
    );
  const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));
  return { part, attempts, story, use, settle };
}

describe("a part that loads on first use", () => {
  it("loads once, and its uses run in the order of the calls", async () => {
    const { part, attempts, story, use, settle } = lazyPart();
    expect(part.isRequested).toBe(false);
    use("one", () => use("three"));
    use("two");
    await settle();
    expect(story).toEqual([]);
    expect(part).toMatchObject({ isRequested: true, loaded: null });
    attempts[0]?.resolve("race");
    await settle();
    expect(part.loaded).toBe("race");
    use("four");
    await settle();
    expect(story).toEqual(["one uses race", "two uses race", "three uses race", "four uses race"]);
    expect(attempts).toHaveLength(1);
  });

  it("reports a failure to each use, and loads again with the next one", async () => {
    const { part, attempts, story, use, settle } = lazyPart();
    use("one", () => use("retry"));
    use("two");
    attempts[0]?.reject("offline");
    await settle();
    expect(story).toEqual(["one fails: offline", "two fails: offline"]);
    expect(attempts).toHaveLength(2);
    use("three");
    attempts[1]?.resolve("race");
    await settle();
    expect(story.slice(2)).toEqual(["retry uses race", "three uses race"]);
    expect(attempts).toHaveLength(2);
    expect(part.loaded).toBe("race");
  });

  it("is not requested after a failure, which a use may ignore", async () => {
    const { part, attempts, settle } = lazyPart();
    part.use(() => undefined);
    attempts[0]?.reject("offline");
    await settle();
    expect(part).toMatchObject({ isRequested: false, loaded: null });
  });

  it("goes on with the next use after one that throws", async () => {
    const { attempts, story, use, settle } = lazyPart();
    use("one", () => {
      throw "broken";
    });
    use("two");
    attempts[0]?.resolve("race");
    await settle();
    expect(story).toEqual(["one uses race", "fault: broken", "two uses race"]);
  });
});
