/**
 * The example of a physical robot passes all checks. For each check, a copy with an injected fault
 * fails this check first.
 *
 * The checks run in sections of a few checks, each on a robot of its own, so that all sections run
 * concurrently. A fault runs alone in the section that must catch it, up to the check that must
 * fail. Earlier sections run with several faults at once, and must pass.
 */
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { CheckGroup } from "../../../packages/conformance/src/check.ts";
import { passes } from "../../../packages/conformance/src/report.ts";
import { groups, type Outcome, type Result } from "../../../packages/conformance/src/run-checks.ts";
import type { InjectedFault } from "../../support/conformance/injected-fault.ts";
import { injectedFaults } from "../../support/conformance/injected-faults.ts";
import {
  batchesOfLaterFaults,
  earlyFailures,
  firstFailure,
  sectionOf,
  runSection,
  sections,
  stopRobots,
  webSocketSection,
  type EarlyFailure,
} from "../../support/conformance/kit-runs.ts";
import { Pool } from "../../support/conformance/pool.ts";

/** Robots that run concurrently. A run mostly waits for leases and ttls. */
const CONCURRENCY = 16;
/** Timeout for all runs, in ms. */
const RUN_MS = 600_000;

/** Promises that no run can test, so that no fault is injected. */
const NEVER_TESTABLE = ["state-change", "events-time"];

/** Faults that only sections after this one must catch. */
interface Batch {
  section: CheckGroup;
  faults: readonly InjectedFault[];
}

describe("the physical robot", () => {
  const unchanged = new Map<CheckGroup, Promise<Result[]>>();
  const caught = new Map<InjectedFault, Promise<Result | undefined>>();
  const early = new Map<Batch, Promise<EarlyFailure[]>>();

  beforeAll(() => {
    const pool = new Pool(CONCURRENCY);
    /** Adds an entry to one of the maps. A test awaits it later. */
    const start = <Key, T>(map: Map<Key, Promise<T>>, key: Key, run: () => Promise<T>): void => {
      const result = pool.run(run);
      result.catch(() => undefined);
      map.set(key, result);
    };
    // The heartbeat of the WebSocket takes the longest. Faults of the last checks need long runs.
    for (const section of [webSocketSection, ...sections.toReversed()]) {
      const isTracked = section === webSocketSection;
      start(unchanged, section, async () => runSection({ section, isTracked }));
      const batches = section === webSocketSection ? [] : batchesOfLaterFaults(section);
      for (const faults of batches) {
        start(early, { section, faults }, async () => earlyFailures(section, faults));
      }
      const faults = injectedFaults.filter((fault) => sectionOf(fault) === section);
      for (const fault of faults.toReversed()) {
        start(caught, fault, async () => firstFailure(fault));
      }
    }
  });

  afterAll(stopRobots);

  it(
    "passes all checks, and reports the features that it does not offer",
    async () => {
      const results = (
        await Promise.all(sections.map(async (section) => unchanged.get(section) ?? []))
      ).flat();
      const of = (kind: Outcome["kind"]) =>
        results.filter(({ outcome }) => outcome.kind === kind).map(({ promise }) => promise);
      expect(results.filter(({ outcome }) => outcome.kind === "failed")).toEqual([]);
      expect(of("not testable")).toEqual(NEVER_TESTABLE);
      expect(of("not offered")).toEqual([
        "pose-heading",
        "pose-axes",
        "pose-ending",
        "maze",
        "reset",
        "reset-replaces",
        "reset-rate",
        ...webSocketSection.checks.map(({ promise }) => promise),
      ]);
      expect(passes(results)).toBe(true);
    },
    RUN_MS,
  );

  it(
    "passes the checks of connections with a WebSocket",
    async () => {
      const results = (await unchanged.get(webSocketSection)) ?? [];
      expect(results.map(({ promise }) => promise)).toEqual(
        webSocketSection.checks.map(({ promise }) => promise),
      );
      expect(results.filter(({ outcome }) => outcome.kind !== "passed")).toEqual([]);
    },
    RUN_MS,
  );

  it.each(injectedFaults)(
    "with a fault, $fault: caught by $caughtBy",
    async (fault) => {
      const found = await caught.get(fault);
      // All fields of the failure, so that the report shows which other check failed first.
      expect(found).toEqual({ ...found, promise: fault.caughtBy });
    },
    RUN_MS,
  );

  it.each(sections.slice(0, -1))(
    "with faults that later checks must catch: passes the checks of $title",
    async (section) => {
      const batches = [...early].filter(([batch]) => batch.section === section);
      expect(batches.length).toBeGreaterThan(0);
      const failures = await Promise.all(batches.map(([, result]) => result));
      expect(failures.flat()).toEqual([]);
    },
    RUN_MS,
  );

  it("has an injected fault for every check", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    const covered = new Set(injectedFaults.map(({ caughtBy }) => caughtBy));
    expect(checks.filter((promise) => !covered.has(promise))).toEqual(NEVER_TESTABLE);
  });
});
