import { generateMaze } from "@corridor/maze";
import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";
import { createRaceStore, RACE_KEY } from "../../model/run/race-store.ts";
import { createRunStore } from "../../model/run/run-store.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore, setMaze } from "../../model/workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { SimulatorClient, type WorkerPort } from "../../simulator/simulator-client.ts";
import { runEventAt } from "../../simulator/worker/testing/run-event-at.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { RaceService } from "./race-service.ts";

const other = generateMaze({ kind: "tree", columns: 9, rows: 9, seed: 3, name: "Other" });
const finish = { goalTick: 600, bumps: 1, driver: "program", lines: 2 } as const;

function runOf(changes: Partial<RunDocument> = {}): RunDocument {
  return {
    format: "corridor/run",
    version: 1,
    name: firstMaze.name,
    maze: firstMaze,
    program: firstProgram,
    seed: 0,
    ticks: 600,
    inputs: [],
    digest: "0123456789abcdef",
    ...changes,
  };
}

/** A service whose worker returns the given answer. */
function bench(answer: "ready" | "broken" | "silent" = "ready", tab = new MemoryStorage()) {
  const sent: ToWorker[] = [];
  const port: WorkerPort = {
    onmessage: null,
    postMessage(message) {
      sent.push(message);
      if (message.type === "save-run") {
        const saved = { ok: true, text: JSON.stringify(runOf()), ticks: 600 } as const;
        emit({ type: "run-saved", id: message.id, saved });
      }
      if (message.type !== "add-ghost" || answer === "silent") return;
      const problems = [{ path: "digest", found: "a", expected: "b" }];
      const added =
        answer === "ready" ? ({ ok: true, finish } as const) : ({ ok: false, problems } as const);
      emit({ type: "ghost-added", id: message.id, added });
    },
  };
  const emit = (data: FromWorker) => port.onmessage?.({ data } as MessageEvent<FromWorker>);
  const ports = {
    simulator: new SimulatorClient(port),
    workspace: createWorkspaceStore(firstMaze, firstProgram),
    run: createRunStore(),
    race: createRaceStore(),
    screen: createScreenStore(),
    tab,
  };
  const words = { t: (key: string) => key } as unknown as ConstructorParameters<
    typeof RaceService
  >[1];
  const texts = () => ports.screen.getState().messages.map(({ text }) => text);
  return { ...ports, service: new RaceService(ports, words), sent, emit, texts };
}

describe("a race", () => {
  it("makes the run on the screen ghost A and puts the robot at its start", async () => {
    const { service, race, sent, texts } = bench();
    await service.raceThisRun();
    expect(race.getState().ghosts).toMatchObject([{ badge: "A", finish }]);
    expect(sent.map(({ type }) => type)).toEqual(["save-run", "add-ghost", "reset"]);
    expect(texts()).toEqual(["race:ready"]);
  });

  it("reports why a run is not in it", async () => {
    const { service } = bench();
    expect(await service.add(runOf({ ticks: 0 }))).toBe("empty");
    expect(await service.add(runOf({ maze: other }))).toBe("other-maze");
    const edit = { tick: 3, do: "maze", maze: other } as const;
    expect(await service.add(runOf({ inputs: [edit] }))).toBe("edited");
    expect(await service.add(runOf())).toBeNull();
    expect(await service.add(runOf({ name: "A friend" }))).toBe("same");
    expect(await bench("broken").service.add(runOf())).toBe("broken");
  });

  it("accepts the same maze under another name", async () => {
    const { service } = bench();
    expect(await service.add(runOf({ maze: { ...firstMaze, name: "Mine" } }))).toBeNull();
  });

  it("has room for seven ghosts, and gives a free letter again", async () => {
    const { service, race } = bench();
    for (const digest of "1234567") expect(await service.add(runOf({ digest }))).toBeNull();
    expect(await service.add(runOf({ digest: "8" }))).toBe("full");
    const [, second] = race.getState().ghosts;
    service.remove(second?.id ?? 0);
    expect(await service.add(runOf({ digest: "8" }))).toBeNull();
    expect(race.getState().ghosts.map(({ badge, digest }) => badge + digest)).toEqual([
      "A1 600",
      "B8 600",
      "C3 600",
      "D4 600",
      "E5 600",
      "F6 600",
      "G7 600",
    ]);
  });

  it("leaves no ghost behind that could not be loaded", async () => {
    const broken = bench("broken");
    await broken.service.raceThisRun();
    expect(broken.race.getState().ghosts).toEqual([]);
    expect(broken.texts()).toEqual(["race:refused.broken"]);
    expect(broken.sent.some(({ type }) => type === "reset")).toBe(false);
    const silent = bench("silent");
    const added = silent.service.add(runOf());
    silent.emit({ type: "fault", reason: "" });
    expect(await added).toBe("failed");
    expect(silent.race.getState().ghosts).toEqual([]);
  });

  it("ends with a message when the maze changes; a new name does not count", async () => {
    const { service, race, workspace, sent, texts } = bench();
    await service.add(runOf());
    setMaze(workspace, { ...firstMaze, name: "Mine" });
    expect(race.getState().ghosts).toHaveLength(1);
    setMaze(workspace, other);
    expect(race.getState().ghosts).toEqual([]);
    expect(sent.at(-1)).toMatchObject({ type: "remove-ghost" });
    expect(texts()).toContain("race:over");
  });

  it("stores the time of the robot to the goal, until the run is truncated before it", async () => {
    const { race, emit } = bench();
    emit({ type: "event", event: runEventAt("goal", 540, firstProgram) });
    expect(race.getState().you).toEqual({
      goalTick: 540,
      bumps: 1,
      driver: "program",
      lines: firstProgram.rules.length,
    });
    emit({ type: "truncated", after: 540 });
    expect(race.getState().you).not.toBeNull();
    emit({ type: "truncated", after: 539 });
    expect(race.getState().you).toBeNull();
  });

  it("returns after a reload without messages, with the same letters", async () => {
    const { service, race, tab } = bench();
    await service.add(runOf());
    await service.add(runOf({ digest: "fedcba9876543210" }));
    const [first] = race.getState().ghosts;
    if (first) service.remove(first.id);

    const reloaded = bench("ready", tab);
    await reloaded.service.resume();
    expect(reloaded.race.getState().ghosts).toMatchObject([
      { badge: "B", digest: "fedcba9876543210 600", finish },
    ]);
    expect(reloaded.texts()).toEqual([]);
    // The ghosts also survive a second reload.
    const again = bench("ready", tab);
    await again.service.resume();
    expect(again.race.getState().ghosts).toHaveLength(1);
    again.service.end();
    expect(tab.getItem(RACE_KEY)).toBeNull();
  });

  it("does not return in another maze, or from an unreadable record", async () => {
    const tab = new MemoryStorage();
    await bench("ready", tab).service.add(runOf());
    const elsewhere = bench("ready", tab);
    setMaze(elsewhere.workspace, other);
    await elsewhere.service.resume();
    expect(elsewhere.race.getState().ghosts).toEqual([]);
    expect(tab.getItem(RACE_KEY)).toBeNull();

    for (const text of [
      "{",
      "7",
      "[null]",
      '[{"badge":"A","run":"{}"}]',
      '[{"badge":1,"run":2}]',
    ]) {
      tab.setItem(RACE_KEY, text);
      const broken = bench("ready", tab);
      await broken.service.resume();
      expect(broken.race.getState().ghosts).toEqual([]);
      expect(tab.getItem(RACE_KEY)).toBeNull();
    }
  });

  it("continues if the tab cannot store it", async () => {
    const { service, race, tab } = bench();
    tab.isFull = true;
    expect(await service.add(runOf())).toBeNull();
    expect(race.getState().ghosts).toHaveLength(1);
    expect(tab.getItem(RACE_KEY)).toBeNull();
  });
});
