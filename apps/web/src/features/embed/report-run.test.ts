import { decodeLink } from "@corridor/link";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { threeTasks } from "../../model/challenge/testing/three-tasks.ts";
import { createChallengeStore } from "../../model/challenge/challenge-store.ts";
import { createRunStore } from "../../model/run/run-store.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import type { FromWorker, RunEvent } from "../../simulator/protocol/worker-messages.ts";
import type { FrameReport } from "@corridor/protocol";
import { RunReporter } from "./report-run.ts";

function openReporter() {
  const reports: FrameReport[] = [];
  const run = createRunStore();
  const challenge = createChallengeStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  let receive: (message: FromWorker) => void = () => undefined;
  const simulator = {
    listen: (listener: (message: FromWorker) => void) => {
      receive = listener;
      return () => undefined;
    },
  };
  const services = { run, challenge, workspace, simulator };
  const reporter = new RunReporter(services, (report) => reports.push(report));
  const show = (state: "running" | "paused", tick: number) =>
    run.setState({ snapshot: { ...snapshotOf(), state, tick }, nowTick: tick });
  const event = (change: Partial<RunEvent>) => {
    const pose = { x: 50, y: 50, heading: 0 };
    const none = { cause: null, diagnosis: null, program: null };
    const base = { kind: "bump", tick: 90, pose, line: 0, driver: "program", bumps: 1 } as const;
    receive({ type: "event", event: { ...base, ...none, ...change } });
  };
  return { reports, reporter, challenge, show, event };
}

describe("a site around the page", () => {
  it("receives each run from the start, but not a pause and its end", () => {
    const { reports, show } = openReporter();
    show("running", 0);
    show("running", 60);
    show("paused", 60);
    show("running", 61);
    expect(reports).toEqual([{ type: "run", attempts: 1 }]);
    show("paused", 0);
    show("running", 0);
    expect(reports.at(-1)).toEqual({ type: "run", attempts: 2 });
  });

  it("receives a bump with its line, and the goal in a maze without a task", () => {
    const { reports, show, event } = openReporter();
    show("running", 1);
    event({});
    event({ line: "default", tick: 100, bumps: 2 });
    event({ kind: "goal", tick: 301, bumps: 2 });
    expect(reports.slice(1)).toEqual([
      { type: "bump", seconds: 1.5, bumps: 1, line: 1 },
      { type: "bump", seconds: 1.67, bumps: 2, line: null },
      { type: "met", task: 1, lines: 2, seconds: 5.02, bumps: 2, attempts: 1, code: null },
    ]);
  });

  it("receives a failed and a met task, with the completion code of the program", () => {
    const { reports, challenge, show, event } = openReporter();
    challenge.setState({ lesson: threeTasks, index: 0 });
    show("running", 1);
    challenge.setState({ result: { state: "failed", code: "bump", tick: 120 } });
    show("paused", 0);
    challenge.setState({ result: { state: "open" } });
    show("running", 1);
    event({ kind: "goal", tick: 300 });
    const result = { driver: "program", ticks: 300, bumps: 0, lines: 2 } as const;
    challenge.setState({ result: { state: "here", ...result } });
    challenge.setState({ result: { state: "met", ...result } });
    const [, failed, , met] = reports;
    expect(failed).toEqual({ type: "failed", task: 1, code: "bump", seconds: 2, attempts: 1 });
    expect(met).toMatchObject({ type: "met", task: 1, lines: 2, seconds: 5, attempts: 2 });
    const code = met?.type === "met" ? decodeLink(met.code ?? "") : null;
    expect(code).toMatchObject({ ok: true, value: { completion: { task: 0 } } });
    expect(reports).toHaveLength(4);
  });
});
