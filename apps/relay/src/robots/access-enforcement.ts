/**
 * Enforces changed permissions of a robot: disconnects those that lost access, has their commands
 * ended, and notifies the page and other relays.
 */
import type { StoredKey, StoredScript } from "../commands/robot-step.ts";
import type { AccessListener } from "./access/access-listener.ts";
import type { CommandRecall } from "./delivery/command-recall.ts";
import type { ScriptClocks } from "./delivery/script-clocks.ts";
import type { PageOwnership } from "./page/page-ownership.ts";
import type { Presence } from "./presence/presence.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { Subscribers } from "./readers/subscribers.ts";

export interface AccessEnforcementParts {
  subscribers: Pick<Subscribers, "dismiss">;
  ownership: Pick<PageOwnership, "page">;
  recall: Pick<CommandRecall, "askAgain">;
  presence: Pick<Presence, "blockedChanged" | "keyRevoked">;
  channel: Pick<RobotChannel, "rightsChanged">;
  clocks: Pick<ScriptClocks, "revoked">;
}

export class AccessEnforcement implements AccessListener {
  readonly #parts: AccessEnforcementParts;

  constructor(parts: AccessEnforcementParts) {
    this.#parts = parts;
  }

  keysChanged(): void {
    this.#parts.channel.rightsChanged();
  }

  scriptsChanged(): void {
    this.#parts.channel.rightsChanged();
    this.#parts.presence.blockedChanged();
  }

  reread(): void {
    this.#parts.presence.blockedChanged();
  }

  revoked({ hash }: StoredKey): void {
    this.#parts.clocks.revoked(hash);
    this.#parts.subscribers.dismiss((caller) => caller.hash === hash, "revoked");
    this.#parts.presence.keyRevoked(hash);
    this.#askToEnd();
  }

  blocked({ id }: StoredScript): void {
    this.#parts.subscribers.dismiss(({ script }) => script?.id === id, "blocked");
    this.#askToEnd();
  }

  paused(): void {
    this.#askToEnd();
  }

  /** Disconnects all except the page, whose key ends only with the robot itself. */
  doubted(): void {
    this.#parts.subscribers.dismiss(({ kind }) => kind !== "own", "busy");
  }

  /** Asks a page at this relay to end recalled commands. */
  #askToEnd(): void {
    const { ownership, recall } = this.#parts;
    // If that fails, the page is asked when it reconnects.
    if (ownership.page !== null) recall.askAgain().catch(() => undefined);
  }
}
