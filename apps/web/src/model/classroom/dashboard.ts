/**
 * The class of a teacher as the page shows it: the students from the worker, what they need, the
 * order of their cards, and which solutions pass.
 */
import type { LessonDocument } from "@corridor/challenge";
import { createStore, type StoreApi } from "zustand/vanilla";
import { activeMsAt } from "../../simulator/protocol/class-time.ts";
import type {
  ClassroomState,
  ClassroomStatus,
  CountedBump,
  FromClassroom,
  SeenStudent,
  ToClassroom,
} from "../../simulator/protocol/classroom-messages.ts";
import {
  needsHelp,
  openTask,
  openWork,
  settle,
  standingOf,
  type ShownStanding,
} from "./standing.ts";
import {
  followOrder,
  helpedOf,
  ORDER_MS,
  orderOf,
  type OrderedStudent,
  type ShownOrder,
  type Sorting,
} from "./student-order.ts";
import type { Programs } from "./program-reader.ts";
import type { Verification, Verifications } from "./verifier.ts";

export interface DashboardState {
  status: ClassroomStatus;
  /** ms since 1970 at which the connection was lost; null: it is not lost */
  lostAt: number | null;
  classroom: ClassroomState | null;
  lesson: LessonDocument | null;
  /** null: no lesson is known */
  lessonVersion: string | null;
  students: ReadonlyMap<number, SeenStudent>;
  shown: ReadonlyMap<number, ShownStanding>;
  /** ms since 1970 at which the connection of a student was lost */
  awaySince: ReadonlyMap<number, number>;
  verifications: Verifications;
  bumps: readonly CountedBump[];
  programs: Programs;
  order: ShownOrder;
  sorting: Sorting;
  /** number of the task of the results; null: the teacher has chosen none */
  chosenTask: number | null;
  /** priority of what the big screens show; null: of no dashboard that is open */
  displayed: number | null;
  /** ms since 1970 at the last update */
  now: number;
}

export interface DashboardPorts {
  send: (message: ToClassroom, transfer?: Transferable[]) => void;
  /** ms since 1970 */
  now: () => number;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
  /** the name of a student, in the language of the page */
  nameOf: (student: SeenStudent) => string;
  compareNames: (a: string, b: string) => number;
  /** Students have edited their programs. */
  readPrograms: (students: DashboardState["students"]) => void;
  /** There are claims to verify. */
  verify: (lesson: LessonDocument, students: DashboardState["students"]) => void;
}

const SECOND_MS = 1_000;
const nothing: ReadonlyMap<number, never> = new Map<number, never>();

export class Dashboard {
  readonly store: StoreApi<DashboardState>;
  readonly #ports: DashboardPorts;
  /** why the cards stay where they are */
  readonly #held = new Set<"pointer" | "focus">();
  #isCounting = false;
  #cancelUpdate: (() => void) | null = null;

  constructor(ports: DashboardPorts) {
    this.#ports = ports;
    this.store = createStore<DashboardState>()(() => ({
      status: { kind: "connecting" },
      lostAt: null,
      classroom: null,
      lesson: null,
      lessonVersion: null,
      students: nothing,
      shown: nothing,
      awaySince: nothing,
      verifications: nothing,
      bumps: [],
      programs: nothing,
      order: { order: [], changedAt: 0, waiting: 0 },
      sorting: "help",
      chosenTask: null,
      displayed: null,
      now: ports.now(),
    }));
  }

  send(message: ToClassroom, transfer: Transferable[] = []): void {
    this.#ports.send(message, transfer);
  }

  /** Handles a message of the worker. */
  receive(message: FromClassroom): void {
    const now = this.#ports.now();
    switch (message.type) {
      case "status": {
        const { status } = message;
        const isLost = status.kind === "lost" || status.kind === "connecting";
        const { lostAt, classroom } = this.store.getState();
        const lost = isLost && classroom !== null ? (lostAt ?? now) : null;
        this.store.setState({ status, lostAt: lost });
        return this.#scheduleUpdate();
      }
      case "state":
        this.store.setState({ classroom: message.state, now });
        return this.#scheduleUpdate();
      case "lesson":
        this.store.setState({ lesson: message.lesson, lessonVersion: message.version });
        return this.#verify();
      case "students": {
        const students = new Map(this.store.getState().students);
        for (const student of message.removed) students.delete(student);
        for (const each of message.changed) students.set(each.student, each);
        this.#update(students);
        if (message.changed.some(({ programs }) => programs > 0)) {
          this.#ports.readPrograms(students);
        }
        return this.#verify();
      }
      case "bumps":
        return this.store.setState({ bumps: message.bumps });
      case "displayed":
        return this.store.setState({ displayed: message.priority });
    }
  }

  /** Solutions were run. */
  verified(verifications: Verifications): void {
    const before = this.store.getState().verifications;
    // A student without a claim in the newest lesson may have solved tasks of the one before.
    for (const student of new Set([...before.keys(), ...verifications.keys()])) {
      const passed = passedOf(verifications.get(student));
      const known = passedOf(before.get(student));
      if (passed.length !== known.length) this.send({ type: "verified", student, tasks: passed });
    }
    this.store.setState({ verifications });
    this.#update(this.store.getState().students);
  }

  /** The pointer or the focus is on a card: the cards stay where they are. */
  hold(by: "pointer" | "focus", isHeld: boolean): void {
    if (isHeld) this.#held.add(by);
    else this.#held.delete(by);
  }

  setSorting(sorting: Sorting): void {
    this.store.setState({ sorting });
    this.sortNow();
  }

  /** Shows the results of another task, also on the big screens. */
  chooseTask(task: number): void {
    this.store.setState({ chosenTask: task });
  }

  /** Puts the cards in order at once, because the teacher asks for it. */
  sortNow(): void {
    const changedAt = this.#ports.now();
    const wanted = this.#wanted({ ...this.store.getState(), now: changedAt });
    this.store.setState({ order: { order: wanted.order, changedAt, waiting: 0 } });
  }

  /** The page shows seconds that run, beside those of a pause or a lost connection. */
  countSeconds(isCounting: boolean): void {
    this.#isCounting = isCounting;
    if (isCounting) this.#update(this.store.getState().students);
  }

  /**
   * Schedules an update for when the order may change, or for the next full second while the page
   * displays seconds. An interval of a second takes a fifth of the main thread's limit.
   */
  #scheduleUpdate(): void {
    const state = this.store.getState();
    const now = this.#ports.now();
    const untilOrder = state.order.changedAt + ORDER_MS - now;
    const untilSecond = SECOND_MS - (now % SECOND_MS);
    const orderMs = untilOrder > 0 ? untilOrder : ORDER_MS;
    this.#cancelUpdate?.();
    this.#cancelUpdate = this.#ports.later(
      () => this.#update(this.store.getState().students),
      this.#countsSeconds(state) ? untilSecond : orderMs,
    );
  }

  #countsSeconds({ now, classroom, lostAt, awaySince }: DashboardState): boolean {
    const isPaused = (classroom?.time.pauseEndsAt ?? 0) > now;
    return this.#isCounting || isPaused || lostAt !== null || awaySince.size > 0;
  }

  #update(students: DashboardState["students"]): void {
    const now = this.#ports.now();
    const before = this.store.getState();
    const { classroom, verifications } = before;
    const active = classroom === null ? 0 : activeMsAt(classroom.time, now);
    const shown = new Map<number, ShownStanding>();
    const awaySince = new Map<number, number>();
    for (const [number, student] of students) {
      const task = openTask(student);
      const isSolved = verifications.get(number)?.get(task)?.kind === "passes";
      const helpAt = active - (now - (student.helpSince ?? 0) - (classroom?.time.ahead ?? 0));
      const next = standingOf({ student, task, isSolved }, active, helpAt);
      shown.set(number, settle(before.shown.get(number) ?? null, next, now));
      if (!student.isConnected) awaySince.set(number, before.awaySince.get(number) ?? now);
    }
    const next = {
      ...before,
      now,
      students,
      shown: isSameMap(before.shown, shown) ? before.shown : shown,
      awaySince: isSameMap(before.awaySince, awaySince) ? before.awaySince : awaySince,
    };
    const { order, helped } = this.#wanted(next);
    const isHeld = this.#held.size > 0;
    next.order = followOrder(before.order, order, helped, { isHeld, now });
    const isSame =
      next.students === before.students &&
      next.shown === before.shown &&
      next.awaySince === before.awaySince &&
      next.order === before.order &&
      minuteOf(next) === minuteOf(before);
    // One update of the store, and none if only seconds have passed: every card looks at each.
    if (!isSame || this.#countsSeconds(before)) this.store.setState(next);
    this.#scheduleUpdate();
  }

  #wanted(state: DashboardState): { order: number[]; helped: Set<number> } {
    const { students, shown, sorting } = state;
    const list = [...students.values()].flatMap((student): OrderedStudent[] => {
      const each = shown.get(student.student);
      if (each === undefined) return [];
      // A translation of each name is too slow for every update.
      const name = sorting === "name" ? this.#ports.nameOf(student) : "";
      const timeMs = timeOf(state, student);
      return [{ student: student.student, name, shown: each, timeMs }];
    });
    const order = orderOf(list, sorting, this.#ports.compareNames);
    return { order, helped: helpedOf(list) };
  }

  #verify(): void {
    const { lesson, students, verifications } = this.store.getState();
    const hasClaims = [...students.values()].some(({ tasks }) =>
      tasks.some(({ claims }) => claims.length > 0),
    );
    if (lesson !== null && (hasClaims || verifications.size > 0))
      this.#ports.verify(lesson, students);
  }
}

/** The task of the results: the chosen one, or the newest that students may open. */
export function resultsTask({
  classroom,
  lesson,
  chosenTask,
}: Pick<DashboardState, "classroom" | "lesson" | "chosenTask">): number {
  const task = chosenTask ?? classroom?.settings.paceTo ?? 1;
  return Math.min(task, lesson?.tasks.length ?? 1);
}

/** Whether the class is paused now. */
export function isClassPaused({
  classroom,
  now,
}: Pick<DashboardState, "classroom" | "now">): boolean {
  const endsAt = classroom?.time.pauseEndsAt ?? null;
  return endsAt !== null && endsAt > now;
}

/** The active time now, in ms. */
export function activeNow({ classroom, now }: Pick<DashboardState, "classroom" | "now">): number {
  return classroom === null ? 0 : activeMsAt(classroom.time, now);
}

/** Active ms on the open task, until its first verified solution. */
export function timeOf(
  state: Pick<DashboardState, "classroom" | "now" | "verifications">,
  student: SeenStudent,
): number {
  const openedAt = openWork(student)?.openedAt ?? null;
  if (openedAt === null) return 0;
  const verification = verificationOf(state, student);
  const end = verification?.kind === "passes" ? verification.claim.activeAt : activeNow(state);
  return Math.max(0, end - openedAt);
}

/** Whether the solution of the open task passes; undefined without a claim. */
export function verificationOf(
  { verifications }: Pick<DashboardState, "verifications">,
  student: SeenStudent,
): Verification | undefined {
  return verifications.get(student.student)?.get(openTask(student));
}

/** The students who need help, as their cards show it. */
export function helpedOfState({ shown }: Pick<DashboardState, "shown">): Set<number> {
  return new Set(
    [...shown].flatMap(([student, each]) => (needsHelp(each.standing) ? [student] : [])),
  );
}

/** Number of the minute of the class, which the page shows. */
function minuteOf(state: DashboardState): number {
  return Math.floor(activeNow(state) / 60_000);
}

function passedOf(tasks: ReadonlyMap<number, Verification> | undefined): number[] {
  return [...(tasks ?? [])].flatMap(([task, { kind }]) => (kind === "passes" ? [task] : []));
}

function isSameMap<Value>(
  one: ReadonlyMap<number, Value>,
  other: ReadonlyMap<number, Value>,
): boolean {
  return one.size === other.size && [...one].every(([key, value]) => other.get(key) === value);
}
