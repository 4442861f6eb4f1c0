import { describe, expect, it } from "vitest";
import { TransportChoice, type ConnectionEnd } from "./transport-choice.ts";

const never: ConnectionEnd = { lifetimeMs: null, isDeliberate: false };
const after = (lifetimeMs: number, isDeliberate = false): ConnectionEnd => ({
  lifetimeMs,
  isDeliberate,
});

describe("TransportChoice", () => {
  it("falls back to long polling at once if a WebSocket received no welcome", () => {
    const choice = new TransportChoice();
    expect(choice.lost(never)).toBe(true);
    expect(choice.transport).toBe("long-poll");
  });

  it("returns to WebSockets if long polling fails as well", () => {
    const choice = new TransportChoice();
    choice.lost(never);
    expect(choice.lost(never)).toBe(false);
    expect(choice.transport).toBe("websocket");
  });

  it("stays with long polling if that has worked", () => {
    const choice = new TransportChoice();
    choice.lost(never);
    expect(choice.lost(after(50_000))).toBe(false);
    expect(choice.transport).toBe("long-poll");
  });

  it("falls back after two short-lived WebSockets", () => {
    const choice = new TransportChoice();
    expect([choice.lost(after(20_000)), choice.lost(after(20_000))]).toEqual([false, true]);
    expect(choice.transport).toBe("long-poll");
  });

  it("stays with WebSockets that are long-lived or were closed by the relay", () => {
    const choice = new TransportChoice();
    for (const end of [after(90_000), after(10_000), after(90_000), after(10_000)]) {
      expect(choice.lost(end)).toBe(false);
    }
    for (let n = 0; n < 5; n++) expect(choice.lost(after(100, true))).toBe(false);
    expect(choice.transport).toBe("websocket");
  });

  it("retries WebSockets that have worked, because the relay may be restarting", () => {
    const choice = new TransportChoice();
    choice.lost(after(90_000));
    expect([choice.lost(never), choice.lost(never), choice.lost(never)]).toEqual([
      false,
      false,
      true,
    ]);
  });

  it("probes for WebSockets less and less often", () => {
    const choice = new TransportChoice();
    const intervals = Array.from({ length: 10 }, () => {
      choice.websocketFailed();
      return choice.probeMs;
    });
    expect(intervals).toEqual(intervals.toSorted((a, b) => a - b));
    expect(intervals.at(-1)).toBe(intervals.at(-2));
    choice.websocketOpened();
    expect(choice.transport).toBe("websocket");
  });
});
