/**
 * The connections of a class at this relay: students, dashboards and big screens, and how they
 * reach those of other relays. Tiles and what big screens show are held in memory only.
 */
import type {
  ClassRole,
  RelayToScreen,
  RelayToStudent,
  RelayToTeacher,
  StudentTile,
  StudentToRelay,
  Tile,
} from "@corridor/protocol";
import type { ClassMessage, ClassPresence } from "../bus/class-message.ts";
import type { ClassRecord } from "../bus/class-record.ts";
import { Refusal, retryAfter } from "../platform/errors/problems.ts";
import { limits } from "../platform/limits/limits.ts";
import { MessageRates } from "../platform/limits/message-rates.ts";
import type { Clock } from "../platform/time/clock.ts";
import { BigScreens, type ScreenController, type ScreenMember } from "./big-screens.ts";
import { ClassEvents } from "./class-events.ts";
import type { ClassState } from "./class-state.ts";
import { CreditedFeed } from "./credited-feed.ts";
import type { MemberConnection } from "./member-connection.ts";
import { OtherRelays } from "./other-relays.ts";
import { changesFor, welcomeOf } from "./student-messages.ts";
import { requireCaller, type StudentCaller } from "./student-steps.ts";
import { requireStudent } from "./teacher-steps.ts";

type StudentConnection = MemberConnection<RelayToStudent>;
type StudentRates = MessageRates<keyof typeof limits.studentRates>;

interface ConnectedStudent {
  /** hash of the key */
  key: string;
  connectedAt: number;
  connection: StudentConnection;
  /** whether a dashboard watches, as the student's page last received it */
  watched: boolean;
}

interface Dashboard {
  connection: MemberConnection<RelayToTeacher>;
  tiles: CreditedFeed<ReadonlySet<number>>;
  watched: number | null;
}

export interface StudentMember {
  /** Counts a message of the student. @throws Refusal too-fast */
  count(kind: StudentToRelay["type"]): void;
  tile(tile: Tile): void;
  leave(): void;
}

export interface TeacherMember extends ScreenController {
  /** Receives the tiles of a student more often. @throws Refusal no-student */
  watch(student: number | null): void;
  seen(seq: number): void;
  leave(): void;
}

export interface ClassConnectionsParts {
  clock: Clock;
  /** @returns the newest state */
  readonly state: () => ClassState;
  /** Sends a message to the other relays of the class. */
  readonly notify: (message: ClassMessage) => void;
}

export class ClassConnections {
  readonly #clock: Clock;
  readonly #state: () => ClassState;
  readonly #notify: (message: ClassMessage) => void;
  readonly #events: ClassEvents;
  readonly #others: OtherRelays;
  readonly #students = new Map<number, ConnectedStudent>();
  readonly #dashboards = new Set<Dashboard>();
  readonly #screens: BigScreens;
  readonly #tiles = new Map<number, Tile>();
  /** of all students who have connected, so that a new connection is no new allowance */
  readonly #rates = new Map<number, StudentRates>();

  constructor({ clock, state, notify }: ClassConnectionsParts) {
    this.#clock = clock;
    this.#state = state;
    this.#notify = notify;
    this.#events = new ClassEvents(clock, state);
    this.#screens = new BigScreens({
      clock,
      notify: (message) => {
        if (!this.#others.isEmpty) notify(message);
      },
    });
    this.#others = new OtherRelays({
      clock,
      notify,
      presence: () => this.#presence(),
      changed: (students) => this.#othersChanged(students),
    });
  }

  /** Connections at this relay, by role. */
  get counts(): Record<ClassRole, number> {
    const [learn, teach] = [this.#students.size, this.#dashboards.size];
    return { learn, teach, show: this.#screens.size };
  }

  get isEmpty(): boolean {
    return Object.values(this.counts).every((count) => count === 0);
  }

  // --- students ---

  /**
   * Connects a student. An earlier connection of the student ends.
   * @throws Refusal not-authorised if the key is not valid any more
   */
  joinStudent(caller: StudentCaller, connection: StudentConnection): StudentMember {
    const { student: number, key } = caller;
    const row = requireCaller(this.#state(), caller);
    this.#students.get(number)?.connection.close("replaced");
    const watched = this.#isWatched(number);
    this.#students.set(number, { key, connection, watched, connectedAt: this.#clock.now() });
    const rates = this.#rates.get(number) ?? new MessageRates(limits.studentRates, this.#clock);
    this.#rates.set(number, rates);
    connection.send(welcomeOf(this.#state(), row, { watched, now: this.#clock.now() }));
    this.#showTile(number);
    this.#others.announce();
    return {
      count: (kind) => {
        const isWatchedTile = kind === "tile" && this.#isWatched(number);
        rates.count(isWatchedTile ? "watched tile" : kind);
      },
      tile: (tile) => {
        this.#tiles.set(number, tile);
        this.#showTile(number);
        this.#others.tile(number, tile);
      },
      leave: () => {
        if (this.#students.get(number)?.connection !== connection) return;
        this.#students.delete(number);
        this.#showTile(number);
        this.#others.announce();
      },
    };
  }

  // --- teachers ---

  /**
   * Connects a dashboard.
   * @param since the last event that it received on an earlier connection
   * @throws Refusal too-many-readers
   */
  joinTeacher(connection: MemberConnection<RelayToTeacher>, since: string | null): TeacherMember {
    this.#limitConnections();
    const dashboard: Dashboard = {
      connection,
      watched: null,
      tiles: new CreditedFeed({
        clock: this.#clock,
        intervalMs: () =>
          dashboard.watched === null ? limits.tilesIntervalMs : limits.watchedTilesIntervalMs,
        merge: (waiting, newer) => new Set([...waiting, ...newer]),
        send: (seq, students) => {
          const tiles = [...students].filter((each) => this.#state().students.has(each));
          connection.send({ type: "tiles", seq, tiles: tiles.map((each) => this.#tileOf(each)) });
        },
      }),
    };
    for (const message of this.#events.first(since)) connection.send(message);
    const screens = this.#screens.control((priority) =>
      connection.send({ type: "displayed", priority }),
    );
    this.#dashboards.add(dashboard);
    const { students } = this.#state();
    if (students.size > 0) dashboard.tiles.offer(new Set(students.keys()));
    this.#others.announce(true);
    return {
      watch: (student) => this.#watch(dashboard, student),
      display: (content, priority) => screens.display(content, priority),
      seen: (seq) => dashboard.tiles.seen(seq),
      leave: () => {
        this.#watch(dashboard, null);
        this.#dashboards.delete(dashboard);
        screens.leave();
        dashboard.tiles.close();
        this.#others.announce();
      },
    };
  }

  /** Shows a hint to a student. @throws Refusal no-student */
  hint(student: number, task: number, hint: number): void {
    requireStudent(this.#state(), student);
    const found = this.#students.get(student);
    if (found === undefined) this.#notify({ kind: "hint", student, task, hint });
    else found.connection.send({ type: "hint", task, hint });
  }

  // --- big screens ---

  /** @throws Refusal too-many-readers */
  joinScreen(connection: MemberConnection<RelayToScreen>): ScreenMember {
    this.#limitConnections();
    const screen = this.#screens.join(connection, this.#state().row);
    this.#others.announce();
    return {
      seen: (seq) => screen.seen(seq),
      leave: () => {
        screen.leave();
        this.#others.announce();
      },
    };
  }

  // --- changes of the class ---

  /**
   * Notifies all members of what has changed, here or at another relay.
   * @param records the events of the change; null: some may be missing
   */
  changed(before: ClassState, records: readonly ClassRecord[] | null): void {
    for (const message of this.#events.follow(records)) {
      for (const { connection } of this.#dashboards) connection.send(message);
    }
    this.#deleteRemoved(before);
    const now = this.#clock.now();
    for (const [number, { key, connection }] of this.#students) {
      const row = this.#state().students.get(number);
      if (row === undefined) connection.close("removed");
      else if (row.key !== key) connection.close("replaced");
      else {
        const messages = changesFor(row, this.#state(), before, now);
        for (const message of messages) connection.send(message);
      }
    }
    this.#screens.changed(before.row, this.#state().row);
  }

  /** Ends all connections, because the class has ended. */
  ended(): void {
    for (const { connection } of [...this.#students.values(), ...this.#dashboards])
      connection.close("over");
    this.#screens.ended();
  }

  deleteOldEvents(): void {
    this.#events.deleteOld();
  }

  // --- other relays ---

  /** Handles a message of another relay. */
  received(message: ClassMessage, from: string): void {
    switch (message.kind) {
      case "here":
        this.#closeReplaced(message.presence);
        this.#others.received(message.presence, from);
        if (message.asks) this.#answer();
        return;
      case "tiles":
        for (const { student, tile } of message.tiles) {
          if (!this.#state().students.has(student)) continue;
          this.#tiles.set(student, tile);
          this.#showTile(student);
        }
        return;
      case "hint": {
        const { student, task, hint } = message;
        return this.#students.get(student)?.connection.send({ type: "hint", task, hint });
      }
      case "display":
        return this.#screens.received(message);
      case "released":
        return this.#screens.released(message.priority);
    }
  }

  /** Messages of other relays may have been missed, or this relay has just joined them. */
  missed(): void {
    this.#others.announce(true);
  }

  /** Reports to other relays that this one does not serve the class any more. */
  leave(): void {
    this.#others.leave();
  }

  /** Students who have connected to another relay since they connected to this one. */
  #closeReplaced({ students }: ClassPresence): void {
    for (const { student, connectedAt } of students) {
      const here = this.#students.get(student);
      if (here !== undefined && here.connectedAt < connectedAt) here.connection.close("replaced");
    }
  }

  /** Sends what another relay that has just joined needs. */
  #answer(): void {
    this.#others.announce();
    for (const student of this.#students.keys()) {
      const tile = this.#tiles.get(student);
      if (tile !== undefined) this.#others.tile(student, tile);
    }
    const { message } = this.#screens;
    if (message !== null) this.#notify(message);
  }

  #othersChanged(students: ReadonlySet<number>): void {
    for (const student of students) this.#showTile(student);
    this.#updateWatched();
  }

  #presence(): ClassPresence {
    const watched = [...this.#dashboards].map((dashboard) => dashboard.watched);
    return {
      students: [...this.#students].map(([student, { connectedAt }]) => ({ student, connectedAt })),
      watched: watched.filter((student) => student !== null),
      dashboards: this.#dashboards.size,
      screens: this.#screens.size,
    };
  }

  #deleteRemoved(before: ClassState): void {
    for (const number of before.students.keys()) {
      if (this.#state().students.has(number)) continue;
      this.#tiles.delete(number);
      this.#rates.delete(number);
    }
  }

  #watch(dashboard: Dashboard, student: number | null): void {
    if (student !== null) requireStudent(this.#state(), student);
    if (student === dashboard.watched) return;
    dashboard.watched = student;
    dashboard.tiles.intervalChanged();
    this.#updateWatched();
    this.#others.announce();
  }

  /** Notifies students whom a dashboard at any relay starts or stops to watch. */
  #updateWatched(): void {
    for (const [number, student] of this.#students) {
      const watched = this.#isWatched(number);
      if (watched === student.watched) continue;
      student.watched = watched;
      student.connection.send({ type: "watched", watched });
    }
  }

  #isWatched(student: number): boolean {
    const isWatchedHere = [...this.#dashboards].some(({ watched }) => watched === student);
    return isWatchedHere || this.#others.isWatched(student);
  }

  /** The tile or the connection of a student has changed. */
  #showTile(student: number): void {
    if (!this.#state().students.has(student)) return;
    for (const { tiles } of this.#dashboards) tiles.offer(new Set([student]));
  }

  #tileOf(student: number): StudentTile {
    const tile = this.#tiles.get(student) ?? null;
    const connected = this.#students.has(student) || this.#others.isConnected(student);
    return { student, connected, tile };
  }

  #limitConnections(): void {
    const here = this.#dashboards.size + this.#screens.size;
    const elsewhere = this.#others.dashboards + this.#others.screens;
    if (here + elsewhere < limits.teacherConnections) return;
    throw new Refusal(
      "too-many-readers",
      `At most ${limits.teacherConnections} dashboards and big screens of a class connect. Close one, then try again.`,
      { headers: retryAfter(5_000) },
    );
  }
}
