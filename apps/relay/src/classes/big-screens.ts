/** The big screens of a class at this relay, and the newest content for them. */
import { PROTOCOL_VERSION, type RelayToScreen, type TeacherToRelay } from "@corridor/protocol";
import type { ClassMessage } from "../bus/class-message.ts";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";
import type { ClassRow } from "../store/class-store.ts";
import { CreditedFeed } from "./credited-feed.ts";
import type { MemberConnection } from "./member-connection.ts";

export type DisplayContent = Extract<TeacherToRelay, { type: "display" }>["content"];

interface Screen {
  connection: MemberConnection<RelayToScreen>;
  displays: CreditedFeed<DisplayContent>;
}

export interface ScreenMember {
  seen(seq: number): void;
  leave(): void;
}

export class BigScreens {
  readonly #clock: Clock;
  readonly #screens = new Set<Screen>();
  #content: DisplayContent | null = null;
  #priority: number | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  get size(): number {
    return this.#screens.size;
  }

  /** null: none yet */
  get content(): DisplayContent | null {
    return this.#content;
  }

  /** of the content; null: any content replaces it */
  get priority(): number | null {
    return this.#priority;
  }

  /** Connects a big screen. @param row of the class */
  join(
    connection: MemberConnection<RelayToScreen>,
    { code, lessonVersion: lesson }: ClassRow,
  ): ScreenMember {
    const screen: Screen = {
      connection,
      displays: new CreditedFeed({
        clock: this.#clock,
        intervalMs: () => limits.displayIntervalMs,
        merge: (_waiting, newer) => newer,
        send: (seq, content) => connection.send({ type: "display", seq, content }),
      }),
    };
    connection.send({ type: "welcome", version: PROTOCOL_VERSION, code, lesson });
    this.#screens.add(screen);
    if (this.#content !== null) screen.displays.offer(this.#content);
    return {
      seen: (seq) => screen.displays.seen(seq),
      leave: () => {
        this.#screens.delete(screen);
        screen.displays.close();
      },
    };
  }

  /**
   * Replaces what the big screens show.
   * @param priority null: replaces any content
   * @returns false if what they show has a higher priority
   */
  show(content: DisplayContent, priority: number | null): boolean {
    if (priority !== null && this.#priority !== null && priority < this.#priority) return false;
    this.#content = content;
    this.#priority = priority;
    for (const { displays } of this.#screens) displays.offer(content);
    return true;
  }

  /** Handles what the big screens of another relay show. Repeated content is no newer than this. */
  received({ content, isNew, priority }: Extract<ClassMessage, { kind: "display" }>): void {
    const isHigher = priority !== null && this.#priority !== null && priority > this.#priority;
    if (isNew || isHigher || this.#content === null) this.show(content, priority);
  }

  /** The dashboard whose content has this priority has closed: any content replaces it. */
  release(priority: number): void {
    if (this.#priority === priority) this.#priority = null;
  }

  /** Sends what has changed in the class. */
  changed(before: ClassRow, row: ClassRow): void {
    for (const { connection } of this.#screens) {
      if (row.code !== before.code) connection.send({ type: "code", code: row.code });
      if (row.lessonVersion !== before.lessonVersion) {
        connection.send({ type: "lesson", version: row.lessonVersion });
      }
    }
  }

  /** Ends all connections, because the class has ended. */
  ended(): void {
    for (const { connection } of this.#screens) connection.close("over");
  }
}
