/**
 * Which scripts the owner of a robot has sent away, and whether any may drive. Sending away is no lock: whoever has the key can come back under
 * another name. It says to one of several scripts that it is not its turn; a new key ends them all.
 */
import { MAX_BLOCKED_SCRIPTS, type ScriptRef } from "@corridor/protocol";
import { keyId } from "../keys.ts";
import { noRobot, Refusal } from "../problems.ts";
import type {
  AwayResult,
  ScriptChange,
  SessionStore,
  StoredScript,
  StoredSession,
} from "../store/session-store.ts";
import type { RightsVersion } from "./rights.ts";
import { scriptOf, type Caller } from "./script.ts";

export interface ScriptGateParts {
  robot: string;
  rights: RightsVersion;
  stored: Standing;
  store: Pick<SessionStore, "find">;
  /** changes who is away in the store, with all that follows for commands */
  change: (change: Omit<ScriptChange, "reason">) => Promise<AwayResult>;
  /** pauses in the store, with all that follows for commands @returns false: there is no such robot */
  pause: (isPaused: boolean) => Promise<boolean>;
  /** is told when this relay has changed something */
  changed: () => void;
  /** is told of a script that was sent away */
  blocked: (script: StoredScript) => void;
  /** is told when remote driving was paused */
  paused: () => void;
}

/** What the owner lets scripts do. */
type Standing = Pick<StoredSession, "away" | "isPaused">;

export class ScriptGate {
  readonly #parts: ScriptGateParts;
  #away: readonly StoredScript[];
  #isPaused: boolean;

  constructor(parts: ScriptGateParts) {
    this.#parts = parts;
    this.#away = parts.stored.away;
    this.#isPaused = parts.stored.isPaused;
  }

  get isPaused(): boolean {
    return this.#isPaused;
  }

  get away(): readonly StoredScript[] {
    return this.#away;
  }

  /** Asked at every message. @throws Refusal when the script was sent away */
  check({ script }: Caller): void {
    if (this.#away.some(({ id }) => id === script?.id)) throw scriptIsAway();
  }

  /**
   * Sends a script away; one that is away already stays so.
   * @throws Refusal when there is no such key, or too many scripts are away
   */
  async sendAway({ driver, name, client }: ScriptRef): Promise<StoredScript> {
    const stored = await this.#stored();
    const key = stored?.keys.find(({ kind, hash }) => kind === "drive" && keyId(hash) === driver);
    if (key === undefined) {
      throw new Refusal(
        "unknown-driver",
        "This robot has no driver key with the id in 'driver'. List its scripts with GET .../scripts.",
      );
    }
    const script = scriptOf(key.hash, { name, client });
    await this.#change({ add: script, remove: null });
    return script;
  }

  /** @throws Refusal when no script with this id is away */
  async letBack(id: string): Promise<void> {
    const stored = await this.#stored();
    if (stored?.away.some((script) => script.id === id) !== true) {
      throw new Refusal(
        "no-script",
        "This robot has no blocked script with this id. List its scripts with GET .../scripts.",
      );
    }
    await this.#change({ add: null, remove: id });
  }

  /** Pauses remote driving, or lets scripts drive again; each as often as it is asked for. */
  async pause(isPaused: boolean): Promise<void> {
    if (!(await this.#parts.pause(isPaused))) throw noRobot();
    this.learn({ away: this.#away, isPaused });
    this.#parts.changed();
  }

  /** Takes in what the store holds: another relay may have changed it. */
  learn({ away, isPaused }: { away: readonly StoredScript[]; isPaused?: boolean }): void {
    const before = this.#away;
    const wasPaused = this.#isPaused;
    this.#away = away;
    this.#parts.rights.changed();
    this.#isPaused = isPaused ?? wasPaused;
    if (this.#isPaused && !wasPaused) this.#parts.paused();
    for (const script of away) {
      if (!before.some(({ id }) => id === script.id)) this.#parts.blocked(script);
    }
  }

  /** Another relay may have changed it a moment ago. */
  async #stored(): Promise<StoredSession | null> {
    return this.#parts.store.find(this.#parts.robot);
  }

  async #change(change: Pick<ScriptChange, "add" | "remove">): Promise<void> {
    const result = await this.#parts.change({ ...change, most: MAX_BLOCKED_SCRIPTS });
    if (result.outcome === "no-session") throw noRobot();
    if (result.outcome === "full") {
      throw new Refusal(
        "too-many-blocked",
        `${MAX_BLOCKED_SCRIPTS} scripts are blocked, the maximum. Unblock one, or create a new key, which disconnects all scripts of the old key.`,
      );
    }
    this.learn(result);
    this.#parts.changed();
  }
}

/** The answer to a script that was sent away. */
export function scriptIsAway(): Refusal {
  return new Refusal(
    "blocked",
    "The robot's owner has blocked this script. Ask the owner to press 'Unblock', then restart the script.",
  );
}
