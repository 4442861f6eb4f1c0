/** The newest numbered events of a class, and the dashboards that follow them. */
import { PROTOCOL_VERSION, type ClassEvent, type RelayToTeacher } from "@corridor/protocol";
import { classRecordSchema, type ClassRecord } from "../bus/class-record.ts";
import { EventLog, type NumberedEvent, type Packing } from "../platform/events/event-log.ts";
import type { Clock } from "../platform/time/clock.ts";
import { settingsOf, type ClassState } from "./class-state.ts";

const packing: Packing<ClassRecord> = {
  pack: (record) => JSON.stringify(record),
  unpack: (text) => classRecordSchema.parse(JSON.parse(text)),
};

export class ClassEvents {
  readonly #clock: Clock;
  readonly #state: () => ClassState;
  readonly #log: EventLog<ClassRecord>;

  /** @param state the newest state */
  constructor(clock: Clock, state: () => ClassState) {
    this.#clock = clock;
    this.#state = state;
    const { stream, n } = state().row;
    this.#log = new EventLog(clock, packing, { stream, n });
  }

  /**
   * The first messages to a dashboard.
   * @param since the last event that it received; null: it needs no earlier ones
   */
  first(since: string | null): RelayToTeacher[] {
    const { stream, n: newest } = this.#log;
    const known = since === null ? newest : this.#log.numberOf(since);
    const missed = known === null ? null : this.#log.after(known);
    const n = missed === null ? null : known;
    const settings = settingsOf(this.#state().row, this.#clock.now());
    const welcome = { type: "welcome", version: PROTOCOL_VERSION, stream, n, settings } as const;
    if (missed === null) return [welcome, { type: "gap", n: newest }];
    return [welcome, ...[...missed].map((event) => this.#messageOf(event))];
  }

  /**
   * Follows the class to its newest state.
   * @param records the events of the change; null: some may be missing
   * @returns messages to the dashboards
   */
  follow(records: readonly ClassRecord[] | null): RelayToTeacher[] {
    const { n } = this.#state().row;
    if (records !== null && this.#log.n + records.length === n) {
      this.#log.deleteOld();
      return records.map((record) => this.#messageOf(this.#log.add(record)));
    }
    if (this.#log.n === n) return [];
    this.#log.skipTo(n);
    return [{ type: "gap", n }];
  }

  deleteOld(): void {
    this.#log.deleteOld();
  }

  #messageOf({ n, record }: NumberedEvent<ClassRecord>): ClassEvent {
    if (record.type !== "settings") return { ...record, n };
    return { type: "settings", n, settings: settingsOf(this.#state().row, this.#clock.now()) };
  }
}
