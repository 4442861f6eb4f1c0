import { describe, expect, it } from "vitest";
import { frameOf } from "../../stage/testing/frame-of.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { Scrubber } from "./scrubber.ts";

function newScrubber() {
  const sent: ToWorker[] = [];
  const listeners = new Set<(message: FromWorker) => void>();
  const scrubber = new Scrubber({
    send: (message) => sent.push(message),
    listen: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  });
  const emit = (message: FromWorker) => {
    for (const listener of listeners) listener(message);
  };
  const shown = () => emit({ type: "frame", frame: frameOf({ view: "past" }), timeline: null });
  return { scrubber, sent, shown, emit, listeners };
}

const seeks = (...ticks: number[]) => ticks.map((tick) => ({ type: "seek", tick }));

describe("drawing along the timeline", () => {
  it("requests one tick at a time, and the newest tick next", () => {
    const { scrubber, sent, shown } = newScrubber();
    for (const tick of [10, 20, 30, 40]) scrubber.show(tick);
    expect(sent).toEqual(seeks(10));
    shown();
    expect(sent).toEqual(seeks(10, 40));
    shown();
    expect(sent).toEqual(seeks(10, 40));
    scrubber.show(50);
    expect(sent).toEqual(seeks(10, 40, 50));
  });

  it("waits for the frame, not for other messages", () => {
    const { scrubber, sent, emit } = newScrubber();
    scrubber.show(10);
    scrubber.show(20);
    emit({ type: "digest", digest: "" });
    expect(sent).toEqual(seeks(10));
  });

  it.each([
    {
      name: "the drawing ends",
      end: ({ scrubber }: ReturnType<typeof newScrubber>) => scrubber.stop(),
    },
    {
      name: "the simulator breaks",
      end: ({ emit }: ReturnType<typeof newScrubber>) => emit({ type: "fault", reason: "broken" }),
    },
  ])("does not wait for a frame that never came once $name", ({ end }) => {
    const bench = newScrubber();
    bench.scrubber.show(10);
    bench.scrubber.show(20);
    end(bench);
    bench.scrubber.show(30);
    expect(bench.sent).toEqual(seeks(10, 30));
    expect(bench.listeners.size).toBe(1);
  });

  it("discards the pending tick on stop", () => {
    const { scrubber, sent, shown, listeners } = newScrubber();
    scrubber.show(10);
    scrubber.show(20);
    scrubber.stop();
    shown();
    expect(sent).toEqual(seeks(10));
    expect(listeners.size).toBe(0);
  });
});
