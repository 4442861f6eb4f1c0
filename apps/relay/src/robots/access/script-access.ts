/**
 * Scripts that the owner of a robot has blocked, and whether remote driving is paused. Blocking is
 * no access control, because a script with the key can return under another name. It excludes one
 * of several scripts until the owner unblocks it. Only a new key ends the access of all.
 */
import { MAX_BLOCKED_SCRIPTS, type ScriptRef } from "@corridor/protocol";
import { keyId } from "../../platform/keys.ts";
import { noRobot, Refusal } from "../../platform/errors/problems.ts";
import type {
  ScriptChange,
  RobotStore,
  StoredKey,
  StoredScript,
  StoredRobot,
} from "../../store/port.ts";
import type { AccessListener, PermissionChanges } from "./access-listener.ts";
import { scriptOf, type RightsVersion, type Caller } from "./caller.ts";

export interface ScriptAccessParts {
  robot: string;
  rights: RightsVersion;
  stored: ScriptPermissions;
  store: Pick<RobotStore, "find">;
  changes: Pick<PermissionChanges, "changeBlocked" | "pause" | "permitReset">;
  listener: Pick<AccessListener, "scriptsChanged" | "blocked" | "paused">;
}

/** Permissions of scripts, as the owner has set them. */
type ScriptPermissions = Pick<StoredRobot, "blocked" | "isPaused" | "mayReset">;

/** What is missing has not changed. */
type ChangedPermissions = Partial<Omit<ScriptPermissions, "blocked">> & {
  blocked: readonly StoredScript[];
};

export class ScriptAccess {
  readonly #parts: ScriptAccessParts;
  #blocked: readonly StoredScript[];
  #isPaused: boolean;
  #mayReset: boolean;

  constructor(parts: ScriptAccessParts) {
    this.#parts = parts;
    this.#blocked = parts.stored.blocked;
    this.#isPaused = parts.stored.isPaused;
    this.#mayReset = parts.stored.mayReset;
  }

  get isPaused(): boolean {
    return this.#isPaused;
  }

  /** Whether scripts may reset the robot. */
  get mayReset(): boolean {
    return this.#mayReset;
  }

  get blocked(): readonly StoredScript[] {
    return this.#blocked;
  }

  /** @throws Refusal blocked */
  check({ script }: Caller): void {
    if (this.#blocked.some(({ id }) => id === script?.id)) throw scriptIsBlocked();
  }

  /**
   * Blocks a script. A script that is already blocked stays blocked.
   * @throws Refusal unknown-driver, too-many-blocked or no-robot
   */
  async block({ driver, name, client }: ScriptRef): Promise<StoredScript> {
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

  /** @throws Refusal no-script if no script with this id is blocked */
  async unblock(id: string): Promise<void> {
    const stored = await this.#stored();
    if (stored?.blocked.some((script) => script.id === id) !== true) {
      throw new Refusal(
        "no-script",
        "This robot has no blocked script with this id. List its scripts with GET .../scripts.",
      );
    }
    await this.#change({ add: null, remove: id });
  }

  /** Pauses remote driving, or resumes it. Repeated calls have no further effect. */
  async pause(isPaused: boolean): Promise<void> {
    if (!(await this.#parts.changes.pause(isPaused))) throw noRobot();
    this.apply({ blocked: this.#blocked, isPaused });
    this.#parts.listener.scriptsChanged();
  }

  /** Permits or forbids scripts to reset the robot. Repeated calls have no further effect. */
  async permitReset(mayReset: boolean): Promise<void> {
    if (!(await this.#parts.changes.permitReset(mayReset))) throw noRobot();
    this.#mayReset = mayReset;
    this.#parts.listener.scriptsChanged();
  }

  /** Applies the stored permissions, which another relay may have changed. */
  apply({ blocked, isPaused, mayReset }: ChangedPermissions): void {
    const before = this.#blocked;
    const wasPaused = this.#isPaused;
    this.#blocked = blocked;
    this.#parts.rights.changed();
    this.#isPaused = isPaused ?? wasPaused;
    this.#mayReset = mayReset ?? this.#mayReset;
    if (this.#isPaused && !wasPaused) this.#parts.listener.paused();
    for (const script of blocked) {
      if (!before.some(({ id }) => id === script.id)) this.#parts.listener.blocked(script);
    }
  }

  /** The scripts of a revoked key are no longer blocked, because they cannot return. */
  keyRevoked({ hash }: StoredKey): void {
    this.apply({ blocked: this.#blocked.filter(({ driver }) => driver !== hash) });
  }

  /** Reads the store, because another relay may have just changed it. */
  async #stored(): Promise<StoredRobot | null> {
    return this.#parts.store.find(this.#parts.robot);
  }

  async #change(change: Pick<ScriptChange, "add" | "remove">): Promise<void> {
    const result = await this.#parts.changes.changeBlocked({
      ...change,
      most: MAX_BLOCKED_SCRIPTS,
    });
    if (result.outcome === "no-robot") throw noRobot();
    if (result.outcome === "full") {
      throw new Refusal(
        "too-many-blocked",
        `${MAX_BLOCKED_SCRIPTS} scripts are blocked, the maximum. Unblock one, or create a new key, which disconnects all scripts of the old key.`,
      );
    }
    this.apply(result);
    this.#parts.listener.scriptsChanged();
  }
}

/** Error response for a blocked script. */
export function scriptIsBlocked(): Refusal {
  return new Refusal(
    "blocked",
    "The robot's owner has blocked this script. Ask the owner to press 'Unblock', then restart the script.",
  );
}
