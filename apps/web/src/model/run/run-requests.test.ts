import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { SimulatorClient, type WorkerPort } from "../../simulator/simulator-client.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { loadRun, saveRun } from "./run-requests.ts";

const run: RunDocument = {
  format: "corridor/run",
  version: 1,
  name: "",
  maze: firstMaze,
  program: firstProgram,
  seed: 0,
  ticks: 0,
  inputs: [],
  digest: "0123456789abcdef",
};

function newWorker() {
  const sent: ToWorker[] = [];
  const port: WorkerPort = { postMessage: (message) => void sent.push(message), onmessage: null };
  const simulator = new SimulatorClient(port);
  const receive = (data: FromWorker) => port.onmessage?.({ data } as MessageEvent<FromWorker>);
  const ids = () => sent.flatMap((each) => ("id" in each ? [each.id] : []));
  return { simulator, sent, receive, ids };
}

describe("requests to the worker", () => {
  it("receive only their own answer", async () => {
    const { simulator, receive, ids } = newWorker();
    const one = loadRun(simulator, run);
    const other = loadRun(simulator, run);
    const texts: string[] = [];
    saveRun(simulator, (saved) => texts.push(saved.ok ? saved.text : saved.reason));
    const [first = 0, second = 0, third = 0] = ids();
    receive({ type: "run-saved", id: third + 1, saved: { ok: true, text: "another", ticks: 1 } });
    receive({ type: "run-saved", id: third, saved: { ok: true, text: "mine", ticks: 1 } });
    receive({
      type: "run-loaded",
      id: second,
      loaded: { ok: false, reason: "refused", problems: [] },
    });
    receive({ type: "run-loaded", id: first, loaded: { ok: false, reason: "cancelled" } });
    expect(await one.loaded).toMatchObject({ reason: "cancelled" });
    expect(await other.loaded).toMatchObject({ reason: "refused" });
    expect(texts).toEqual(["mine"]);
  });

  it("fail when the simulator breaks, and open nothing later", async () => {
    const { simulator, sent, receive, ids } = newWorker();
    const { loaded } = loadRun(simulator, run);
    receive({ type: "fault", reason: "broken" });
    expect(await loaded).toEqual({ ok: false, reason: "fault" });
    expect(sent.at(-1)).toEqual({ type: "cancel-load", id: ids()[0] });
  });

  it("fail at once if the worker never loaded", async () => {
    const { simulator } = newWorker();
    const { loaded } = loadRun(simulator, run);
    simulator.fail("its file is missing");
    expect(await loaded).toMatchObject({ reason: "fault" });
    expect(await loadRun(simulator, run).loaded).toMatchObject({ reason: "fault" });
  });
});
