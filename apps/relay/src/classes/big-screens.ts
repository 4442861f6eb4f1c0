/**
 * The big screens of a class at this relay, the newest content for them, and which dashboard
 * controls them: the one whose content has the highest priority.
 */
import { PROTOCOL_VERSION, type RelayToScreen, type TeacherToRelay } from "@corridor/protocol";
import type { ClassMessage } from "../bus/class-message.ts";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";
import type { ClassRow } from "../store/class-store.ts";
import { CreditedFeed } from "./credited-feed.ts";
import type { MemberConnection } from "./member-connection.ts";

type DisplayContent = Extract<TeacherToRelay, { type: "display" }>["content"];
type DisplayMessage = Extract<ClassMessage, { kind: "display" }>;

interface Screen {
  connection: MemberConnection<RelayToScreen>;
  displays: CreditedFeed<DisplayContent>;
}

export interface ScreenMember {
  seen(seq: number): void;
  leave(): void;
}

interface Controller {
  /** of its newest content; null: none */
  priority: number | null;
  readonly displayed: (priority: number | null) => void;
}

/** A dashboard, as the big screens use it. */
export interface ScreenController {
  /**
   * Replaces what the big screens show.
   * @param priority it does not replace content of another dashboard with a higher one; null: it
   * replaces any content, and any content replaces it
   */
  display(content: DisplayContent, priority: number | null): void;
  /** Any other dashboard may replace what this one shows. */
  leave(): void;
}

export interface BigScreensParts {
  clock: Clock;
  /** Sends what a dashboard here does to the big screens of the other relays. */
  readonly notify: (message: DisplayMessage | Extract<ClassMessage, { kind: "released" }>) => void;
}

export class BigScreens {
  readonly #parts: BigScreensParts;
  readonly #screens = new Set<Screen>();
  readonly #controllers = new Set<Controller>();
  #content: DisplayContent | null = null;
  /** of the content; null: any content replaces it */
  #priority: number | null = null;

  constructor(parts: BigScreensParts) {
    this.#parts = parts;
  }

  get size(): number {
    return this.#screens.size;
  }

  /** The content for a relay that has none yet; null: no dashboard has sent any. */
  get message(): DisplayMessage | null {
    const [content, priority] = [this.#content, this.#priority];
    return content === null ? null : { kind: "display", content, isNew: false, priority };
  }

  /** Connects a big screen. @param row of the class */
  join(
    connection: MemberConnection<RelayToScreen>,
    { code, lessonVersion: lesson }: ClassRow,
  ): ScreenMember {
    const screen: Screen = {
      connection,
      displays: new CreditedFeed({
        clock: this.#parts.clock,
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
   * Lets a dashboard control the big screens.
   * @param displayed called with the priority of what they show now, which may be content of another
   * dashboard; null: its dashboard has closed, and any content replaces it
   */
  control(displayed: Controller["displayed"]): ScreenController {
    const controller: Controller = { priority: null, displayed };
    this.#controllers.add(controller);
    if (this.#priority !== null) displayed(this.#priority);
    return {
      display: (content, priority) => {
        controller.priority = priority;
        if (!this.#show(content, priority)) return;
        this.#parts.notify({ kind: "display", content, isNew: true, priority });
      },
      leave: () => {
        this.#controllers.delete(controller);
        const { priority } = controller;
        if (priority === null || this.#hasControllerOf(priority)) return;
        this.#release(priority);
        this.#parts.notify({ kind: "released", priority });
      },
    };
  }

  /** Handles what the big screens of another relay show. Repeated content is no newer than this. */
  received({ content, isNew, priority }: DisplayMessage): void {
    const isHigher = priority !== null && this.#priority !== null && priority > this.#priority;
    if (isNew || isHigher || this.#content === null) this.#show(content, priority);
  }

  /** At another relay, the dashboard whose content has this priority has closed. */
  released(priority: number): void {
    if (!this.#hasControllerOf(priority)) this.#release(priority);
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

  /** @returns false if what they show has a higher priority */
  #show(content: DisplayContent, priority: number | null): boolean {
    if (priority !== null && this.#priority !== null && priority < this.#priority) return false;
    this.#content = content;
    for (const { displays } of this.#screens) displays.offer(content);
    const isOther = priority !== this.#priority;
    this.#priority = priority;
    if (isOther && priority !== null) this.#displayed();
    return true;
  }

  #release(priority: number): void {
    if (this.#priority !== priority) return;
    this.#priority = null;
    this.#displayed();
  }

  #displayed(): void {
    for (const { displayed } of this.#controllers) displayed(this.#priority);
  }

  /** Whether a device that has reconnected here sends content with this priority. */
  #hasControllerOf(priority: number): boolean {
    return [...this.#controllers].some((controller) => controller.priority === priority);
  }
}
