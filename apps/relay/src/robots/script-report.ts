/**
 * Reports the scripts of a robot to its page: connected, recently active and blocked ones, at all
 * relays. If the page is at another relay, this relay announces its own scripts there.
 */
import type { ScriptView } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import type { Scripts } from "../bus/bus.ts";
import type { ScriptAccess } from "./access/callers.ts";
import type { PageDisplay } from "./delivery/command-delivery.ts";
import type { PageOwnership } from "./page/page-ownership.ts";
import type { Presence } from "./presence/presence.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";

export interface ScriptReportParts {
  clock: Clock;
  presence: Presence;
  access: Pick<ScriptAccess, "blocked" | "isPaused" | "mayReset">;
  channel: Pick<RobotChannel, "announce" | "repeatAnnouncement" | "withOthers">;
  ownership: Pick<PageOwnership, "isElsewhere">;
  display: Pick<PageDisplay, "sendWith">;
}

export class ScriptReport {
  readonly #parts: ScriptReportParts;

  /** Sends a report whenever the presence of scripts changes. */
  constructor(parts: ScriptReportParts) {
    this.#parts = parts;
    parts.presence.onChange(() => this.send());
  }

  /** The scripts by name, at all relays that this one knows of. */
  get scripts(): ScriptView[] {
    return this.#parts.channel.withOthers(this.#own()).scripts;
  }

  /** Sends the current scripts to the page, here or at another relay. */
  send(): void {
    const { clock, access, channel, ownership, display } = this.#parts;
    if (ownership.isElsewhere) return this.announce();
    display.sendWith({
      type: "drivers",
      at: clock.now(),
      ...channel.withOthers(this.#own()),
      paused: access.isPaused,
      mayReset: access.mayReset,
    });
  }

  /**
   * Announces this relay and its scripts to the page's relay.
   * @param asks whether to request the newest snapshot immediately
   */
  announce(asks = false): void {
    this.#parts.channel.announce(this.#own(), asks);
  }

  /** Repeats the announcement if it is due. Without it, this relay receives no snapshots. */
  repeatAnnouncement(): void {
    if (this.#parts.ownership.isElsewhere) this.#parts.channel.repeatAnnouncement(this.#own());
  }

  #own(): Scripts {
    return this.#parts.presence.report(this.#parts.access.blocked);
  }
}
