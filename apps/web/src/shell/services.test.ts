import { describe, expect, it } from "vitest";
import { createScreenStore } from "../model/screen/screen-store.ts";
import { en } from "../text/en/index.ts";
import { createI18n } from "../text/i18n.ts";
import type { WorkerPort } from "../simulator/simulator-client.ts";
import { snapshotOf } from "@corridor/protocol/testing";
import { frameOf } from "../stage/testing/frame-of.ts";
import { runEventAt } from "../simulator/worker/testing/run-event-at.ts";
import type { FromWorker, ToWorker } from "../simulator/protocol/worker-messages.ts";
import { createServices } from "./create-services.ts";
import { MemoryStorage } from "../model/storage/testing/memory-storage.ts";
import { ProjectReader } from "../model/projects/project-reader.ts";

/** The page's services, and the worker's end of them. */
function openPage() {
  const sent: ToWorker[] = [];
  const worker: WorkerPort = { postMessage: (message) => sent.push(message), onmessage: null };
  const services = createServices({
    worker,
    device: new MemoryStorage(),
    tab: new MemoryStorage(),
    words: createI18n(en),
    screen: createScreenStore(),
    reader: new ProjectReader(),
    nextFrame: (work) => work(),
  });
  const receive = (data: FromWorker) => worker.onmessage?.({ data } as MessageEvent<FromWorker>);
  return { ...services, receive, sent };
}

it("displays the numbers of one tick everywhere: the stage writes those that the page has displayed", () => {
  const { receive, run, sent } = openPage();
  const snapshot = snapshotOf({ tick: 77, state: "running", line: 0 });
  let written = -1;
  run.subscribe((state) => {
    written = state.snapshot?.tick ?? -1;
    expect(sent.some(({ type }) => type === "stage-numbers")).toBe(false);
  });
  receive({ type: "frame", frame: frameOf({ snapshot }), timeline: null });
  expect(written).toBe(77);
  expect(sent).toContainEqual({ type: "stage-numbers", snapshot });
});

describe("a run that continued from an earlier tick", () => {
  it("leaves nothing on the page that came after it", () => {
    const { receive, run, cards } = openPage();
    receive({ type: "event", event: runEventAt("bump", 316) });
    receive({ type: "event", event: runEventAt("goal", 400) });
    receive({ type: "truncated", after: 350 });
    expect(run.getState().event).toBeNull();
    expect(cards.getState().goal).toBeNull();
    expect(cards.getState().bump?.event.tick).toBe(316);
  });

  it("retains what came before it", () => {
    const { receive, run, cards } = openPage();
    receive({ type: "event", event: runEventAt("goal", 400) });
    receive({ type: "truncated", after: 400 });
    expect(run.getState().event?.tick).toBe(400);
    expect(cards.getState().goal?.event.tick).toBe(400);
  });

  it("is empty when another run is displayed", () => {
    const { receive, run, cards } = openPage();
    receive({ type: "event", event: runEventAt("goal", 0) });
    receive({ type: "truncated", after: -1 });
    expect(run.getState().event).toBeNull();
    expect(cards.getState()).toEqual({ bump: null, goal: null });
  });
});
