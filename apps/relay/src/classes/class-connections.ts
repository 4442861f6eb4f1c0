/**
 * The connections of a class at this relay: students, dashboards and big screens. Tiles and what
 * big screens show are held in memory only.
 */
import {
  PROTOCOL_VERSION,
  type RelayToScreen,
  type RelayToStudent,
  type RelayToTeacher,
  type StudentTile,
  type TeacherToRelay,
  type Tile,
} from "@corridor/protocol";
import type { ClassRecord } from "../bus/class-record.ts";
import { Refusal, retryAfter } from "../platform/errors/problems.ts";
import { limits } from "../platform/limits/limits.ts";
import { MessageRates } from "../platform/limits/message-rates.ts";
import type { Clock } from "../platform/time/clock.ts";
import { ClassEvents } from "./class-events.ts";
import { nameOf, settingsOf, type ClassState } from "./class-state.ts";
import { CreditedFeed } from "./credited-feed.ts";
import type { MemberLink } from "./member-link.ts";
import { requireCaller, type StudentCaller } from "./student-steps.ts";
import { requireStudent } from "./teacher-steps.ts";

type StudentLink = MemberLink<RelayToStudent>;
type StudentRates = MessageRates<keyof typeof limits.studentRates>;
type Content = Extract<TeacherToRelay, { type: "display" }>["content"];

interface Dashboard {
  link: MemberLink<RelayToTeacher>;
  tiles: CreditedFeed<ReadonlySet<number>>;
  watched: number | null;
}

interface Screen {
  link: MemberLink<RelayToScreen>;
  displays: CreditedFeed<Content>;
}

export interface StudentMember {
  readonly rates: StudentRates;
  tile(tile: Tile): void;
  leave(): void;
}

export interface TeacherMember {
  /** Receives the tiles of a student more often. @throws Refusal no-student */
  watch(student: number | null): void;
  seen(seq: number): void;
  leave(): void;
}

export interface ScreenMember {
  seen(seq: number): void;
  leave(): void;
}

export class ClassConnections {
  readonly #clock: Clock;
  readonly #state: () => ClassState;
  readonly #events: ClassEvents;
  readonly #students = new Map<number, { key: string; link: StudentLink }>();
  readonly #dashboards = new Set<Dashboard>();
  readonly #screens = new Set<Screen>();
  readonly #tiles = new Map<number, Tile>();
  /** of all students who have connected, so that a new connection is no new allowance */
  readonly #rates = new Map<number, StudentRates>();
  #display: Content | null = null;

  /** @param state the newest state */
  constructor(clock: Clock, state: () => ClassState) {
    this.#clock = clock;
    this.#state = state;
    this.#events = new ClassEvents(clock, state);
  }

  get isEmpty(): boolean {
    return this.#students.size === 0 && this.#dashboards.size === 0 && this.#screens.size === 0;
  }

  // --- students ---

  /**
   * Connects a student. An earlier connection of the student ends.
   * @throws Refusal not-authorised if the key is not valid any more
   */
  joinStudent(caller: StudentCaller, link: StudentLink): StudentMember {
    const { student: number, key } = caller;
    const row = requireCaller(this.#state(), caller);
    this.#students.get(number)?.link.close("replaced");
    this.#students.set(number, { key, link });
    const rates = this.#rates.get(number) ?? new MessageRates(limits.studentRates, this.#clock);
    this.#rates.set(number, rates);
    const { row: classRow } = this.#state();
    const settings = settingsOf(classRow, this.#clock.now());
    link.send({
      type: "welcome",
      version: PROTOCOL_VERSION,
      student: number,
      name: nameOf(classRow, row),
      renamesLeft: row.renamesLeft,
      progress: row.progress,
      helpWanted: row.helpSince !== null,
      watched: this.#isWatched(number),
      pauseEndsInMs: settings.pauseEndsInMs,
      paceTo: settings.paceTo,
      lesson: settings.lesson,
    });
    this.#showTile(number);
    return {
      rates,
      tile: (tile) => {
        this.#tiles.set(number, tile);
        this.#showTile(number);
      },
      leave: () => {
        if (this.#students.get(number)?.link !== link) return;
        this.#students.delete(number);
        if (this.#state().students.has(number)) this.#showTile(number);
      },
    };
  }

  // --- teachers ---

  /**
   * Connects a dashboard.
   * @param since the last event that it received on an earlier connection
   * @throws Refusal too-many-readers
   */
  joinTeacher(link: MemberLink<RelayToTeacher>, since: string | null): TeacherMember {
    this.#limitConnections();
    const dashboard: Dashboard = {
      link,
      watched: null,
      tiles: new CreditedFeed({
        clock: this.#clock,
        intervalMs: () =>
          dashboard.watched === null ? limits.tilesIntervalMs : limits.watchedTilesIntervalMs,
        merge: (waiting, newer) => new Set([...waiting, ...newer]),
        send: (seq, students) => {
          const tiles = [...students].filter((each) => this.#state().students.has(each));
          link.send({ type: "tiles", seq, tiles: tiles.map((each) => this.#tileOf(each)) });
        },
      }),
    };
    for (const message of this.#events.first(since)) link.send(message);
    this.#dashboards.add(dashboard);
    const { students } = this.#state();
    if (students.size > 0) dashboard.tiles.offer(new Set(students.keys()));
    return {
      watch: (student) => this.#watch(dashboard, student),
      seen: (seq) => dashboard.tiles.seen(seq),
      leave: () => {
        this.#watch(dashboard, null);
        this.#dashboards.delete(dashboard);
        dashboard.tiles.close();
      },
    };
  }

  /** Shows a hint to a student. @throws Refusal no-student */
  hint(student: number, task: number, hint: number): void {
    requireStudent(this.#state(), student);
    this.#students.get(student)?.link.send({ type: "hint", task, hint });
  }

  /** Replaces what the big screens show. */
  display(content: Content): void {
    this.#display = content;
    for (const { displays } of this.#screens) displays.offer(content);
  }

  // --- big screens ---

  /** @throws Refusal too-many-readers */
  joinScreen(link: MemberLink<RelayToScreen>): ScreenMember {
    this.#limitConnections();
    const screen: Screen = {
      link,
      displays: new CreditedFeed({
        clock: this.#clock,
        intervalMs: () => limits.displayIntervalMs,
        merge: (_waiting, newer) => newer,
        send: (seq, content) => link.send({ type: "display", seq, content }),
      }),
    };
    const { code, lessonVersion: lesson } = this.#state().row;
    link.send({ type: "welcome", version: PROTOCOL_VERSION, code, lesson });
    this.#screens.add(screen);
    if (this.#display !== null) screen.displays.offer(this.#display);
    return {
      seen: (seq) => screen.displays.seen(seq),
      leave: () => {
        this.#screens.delete(screen);
        screen.displays.close();
      },
    };
  }

  // --- changes of the class ---

  /**
   * Tells all members what has changed, here or at another relay.
   * @param records the events of the change; null: some may be missing
   */
  changed(before: ClassState, records: readonly ClassRecord[] | null): void {
    for (const message of this.#events.follow(records)) {
      for (const { link } of this.#dashboards) link.send(message);
    }
    this.#forgetRemoved(before);
    for (const [number, { key, link }] of this.#students) {
      const row = this.#state().students.get(number);
      if (row === undefined) link.close("removed");
      else if (row.key !== key) link.close("replaced");
      else this.#tellStudent(link, number, before);
    }
    const { row } = this.#state();
    for (const { link } of this.#screens) {
      if (row.code !== before.row.code) link.send({ type: "code", code: row.code });
      if (row.lessonVersion !== before.row.lessonVersion) {
        link.send({ type: "lesson", version: row.lessonVersion });
      }
    }
  }

  /** Ends all connections, because the class has ended. */
  ended(): void {
    for (const { link } of [...this.#students.values(), ...this.#dashboards, ...this.#screens]) {
      link.close("over");
    }
  }

  deleteOldEvents(): void {
    this.#events.deleteOld();
  }

  #tellStudent(link: StudentLink, number: number, before: ClassState): void {
    const { row, students } = this.#state();
    const [student, earlier] = [students.get(number), before.students.get(number)];
    const settings = settingsOf(row, this.#clock.now());
    if (student !== undefined && student.name !== earlier?.name) {
      const { renamesLeft } = student;
      link.send({ type: "name", name: nameOf(row, student), renamesLeft });
    }
    if (row.lessonVersion !== before.row.lessonVersion) {
      link.send({ type: "lesson", version: row.lessonVersion });
    }
    if (row.pause?.endsAt !== before.row.pause?.endsAt) {
      link.send({ type: "pause", endsInMs: settings.pauseEndsInMs });
    }
    if (row.paceTo !== before.row.paceTo) link.send({ type: "pace", to: row.paceTo });
  }

  #forgetRemoved(before: ClassState): void {
    for (const number of before.students.keys()) {
      if (this.#state().students.has(number)) continue;
      this.#tiles.delete(number);
      this.#rates.delete(number);
    }
  }

  #watch(dashboard: Dashboard, student: number | null): void {
    if (student !== null) requireStudent(this.#state(), student);
    const earlier = dashboard.watched;
    if (student === earlier) return;
    const affected = [earlier, student].filter((each) => each !== null);
    const before = affected.map((each) => this.#isWatched(each));
    dashboard.watched = student;
    dashboard.tiles.intervalChanged();
    for (const [index, each] of affected.entries()) {
      const watched = this.#isWatched(each);
      if (watched === before[index]) continue;
      this.#students.get(each)?.link.send({ type: "watched", watched });
    }
  }

  #isWatched(student: number): boolean {
    return [...this.#dashboards].some(({ watched }) => watched === student);
  }

  /** The tile or the connection of a student has changed. */
  #showTile(student: number): void {
    for (const { tiles } of this.#dashboards) tiles.offer(new Set([student]));
  }

  #tileOf(student: number): StudentTile {
    const tile = this.#tiles.get(student) ?? null;
    return { student, connected: this.#students.has(student), tile };
  }

  #limitConnections(): void {
    if (this.#dashboards.size + this.#screens.size < limits.teacherConnections) return;
    throw new Refusal(
      "too-many-readers",
      `At most ${limits.teacherConnections} dashboards and big screens of a class connect. Close one, then try again.`,
      { headers: retryAfter(5_000) },
    );
  }
}
