/**
 * The advice displayed in the lines: the coach's advice on the current program, without hidden
 * advice. Advice disappears as soon as its reason does. It appears only after the edits settle, so
 * that nothing flickers while the student types a number. React-free.
 */
import type { Advice, Fix } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { TFunction } from "i18next";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { ChallengeState, ChallengeStore } from "../challenge/challenge-store.ts";
import type { RunStore } from "../run/run-store.ts";
import type { AdviceText } from "./advice-text.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";

type AdviceWords = (
  ...about: [t: TFunction, language: string, advice: Advice, when: Condition | null]
) => AdviceText;

/** The coach's functions. They load from a separate file once the page is idle. */
export interface Coach {
  adviseProgram: (program: ProgramDocument, maze: MazeDocument) => Advice[];
  applyFix: (program: ProgramDocument, fix: Fix) => ProgramDocument;
  adviceText: AdviceWords;
  /** whether an advice on this program is for the student while a challenge is open */
  concernsReader: (advice: Advice, program: ProgramDocument, open: ChallengeState) => boolean;
}

export interface AdvicePorts {
  workspace: WorkspaceStore;
  load: () => Promise<Coach>;
  /** schedules a function, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
  challenge: ChallengeStore;
  run: Pick<RunStore, "getState" | "subscribe">;
}

export interface AdviceState {
  /** displayed advice, from the top line down */
  shown: readonly Advice[];
  /** newest advice that appeared, for one announcement to screen readers */
  announcement: Advice | null;
}

export interface AdviceStore extends Pick<
  StoreApi<AdviceState>,
  "getState" | "subscribe" | "getInitialState"
> {
  /** hides this advice on every line with the same content */
  hide: (advice: Advice) => void;
  /** the program with the fix applied; null while the coach is not loaded */
  fixedProgram: (fix: Fix) => ProgramDocument | null;
  /** an advice in words; null while the coach is not loaded */
  textOf: (...about: Parameters<AdviceWords>) => AdviceText | null;
}

/** Edits in quicker succession belong together. */
const SETTLE_MS = 1000;

/** Creates a store that follows the workspace. */
export function createAdviceStore({
  workspace,
  load,
  later,
  challenge,
  run,
}: AdvicePorts): AdviceStore {
  const store = createStore<AdviceState>()(() => ({ shown: [], announcement: null }));
  const hidden = new Set<string>();
  const announced = new Set<string>();
  let settled: ReadonlySet<string> = new Set();
  let coach: Coach | null = null;
  let edits = 0;
  /**
   * whether advice is deferred until the robot stops, because it would move lines that the student
   * follows
   */
  let isHeld = false;

  function refresh(): void {
    if (coach === null) return;
    const { program, maze } = workspace.getState();
    const { adviseProgram, concernsReader: isFor } = coach;
    const all = adviseProgram(program, maze);
    const shown = all.filter((advice) => {
      const key = keyOf(advice, program);
      return settled.has(key) && !hidden.has(key) && isFor(advice, program, challenge.getState());
    });
    if (shown.length > 0 || store.getState().shown.length > 0) store.setState({ shown });
  }

  function settle(): void {
    if (coach === null) return;
    isHeld = run.getState().snapshot?.state === "running";
    if (isHeld) return;
    const { program, maze } = workspace.getState();
    const all = coach.adviseProgram(program, maze);
    settled = new Set(all.map((advice) => keyOf(advice, program)));
    refresh();
    const fresh = store.getState().shown.find((advice) => !announced.has(keyOf(advice, program)));
    if (fresh === undefined) return;
    for (const key of settled) announced.add(key);
    store.setState({ announcement: fresh });
  }

  function settleSoon(): void {
    const edit = ++edits;
    later(() => {
      if (edit !== edits) return;
      if (coach !== null) {
        settle();
        return;
      }
      // A failed load costs only the advice. The next edit loads the coach again.
      load().then(
        (loaded) => {
          coach = loaded;
          if (edit === edits) settle();
        },
        () => {},
      );
    }, SETTLE_MS);
  }

  workspace.subscribe((next, before) => {
    if (next.program !== before.program) refresh();
    if (next.program !== before.program || next.maze !== before.maze) settleSoon();
  });
  // After a bump the card comes first: deferred advice waits for Reset, or for the next edit.
  run.subscribe(({ snapshot, event }) => {
    if (isHeld && snapshot?.state !== "running" && event?.kind !== "bump") settle();
  });
  settleSoon();

  return {
    ...store,
    hide: (advice) => {
      hidden.add(keyOf(advice, workspace.getState().program));
      refresh();
    },
    textOf: (...about) => coach && coach.adviceText(...about),
    fixedProgram: (fix) => coach?.applyFix(workspace.getState().program, fix) ?? null,
  };
}

/** The advice on a line or on "otherwise"; null if there is none. */
export function adviceOn(line: LineRef, { shown }: AdviceState): Advice | null {
  return shown.find((advice) => advice.line === line) ?? null;
}

/** Lines with the same content have the same key, regardless of their position. */
function keyOf({ kind, line }: Advice, program: ProgramDocument): string {
  return `${kind} ${JSON.stringify(line === "default" ? line : program.rules[line])}`;
}
