import { describe, expect, it } from "vitest";
import { DoorChoice, type LineEnd } from "./transport-choice.ts";

const never: LineEnd = { livedMs: null, isDeliberate: false };
const after = (livedMs: number, isDeliberate = false): LineEnd => ({ livedMs, isDeliberate });

describe("the choice of a way to the relay", () => {
  it("goes by HTTPS at once where a WebSocket never said welcome", () => {
    const choice = new DoorChoice();
    expect(choice.lost(never)).toBe(true);
    expect(choice.door).toBe("https");
  });

  it("tries a WebSocket again where nothing answers at all", () => {
    const choice = new DoorChoice();
    choice.lost(never);
    expect(choice.lost(never)).toBe(false);
    expect(choice.door).toBe("websocket");
  });

  it("stays with HTTPS where that has worked", () => {
    const choice = new DoorChoice();
    choice.lost(never);
    expect(choice.lost(after(50_000))).toBe(false);
    expect(choice.door).toBe("https");
  });

  it("takes a WebSocket that is cut soon, twice, for one that a filter cuts", () => {
    const choice = new DoorChoice();
    expect([choice.lost(after(20_000)), choice.lost(after(20_000))]).toEqual([false, true]);
    expect(choice.door).toBe("https");
  });

  it("stays with WebSockets that live long, or that the relay itself closes", () => {
    const choice = new DoorChoice();
    for (const end of [after(90_000), after(10_000), after(90_000), after(10_000)]) {
      expect(choice.lost(end)).toBe(false);
    }
    for (let n = 0; n < 5; n++) expect(choice.lost(after(100, true))).toBe(false);
    expect(choice.door).toBe("websocket");
  });

  it("is patient with a relay that restarts, where WebSockets have worked", () => {
    const choice = new DoorChoice();
    choice.lost(after(90_000));
    expect([choice.lost(never), choice.lost(never), choice.lost(never)]).toEqual([
      false,
      false,
      true,
    ]);
  });

  it("looks for a WebSocket more and more rarely", () => {
    const choice = new DoorChoice();
    const pauses = Array.from({ length: 10 }, () => {
      choice.websocketFailed();
      return choice.probeMs;
    });
    expect(pauses).toEqual(pauses.toSorted((a, b) => a - b));
    expect(pauses.at(-1)).toBe(pauses.at(-2));
    choice.websocketOpened();
    expect(choice.door).toBe("websocket");
  });
});
