/**
 * Callers of a robot: who they are, what their keys permit, and which scripts the owner has blocked
 * or paused. The relay distinguishes scripts by key and name, or without a name by key and language.
 * Scripts of one key that send neither count as one.
 *
 * Blocking is no access control, because a script with the key can return under another name. It
 * excludes one of several scripts until the owner unblocks it. Only a new key ends the access of all.
 */
import { createHash } from "node:crypto";
import {
  BLOCKED_SCRIPT,
  READ_ONLY,
  MAX_BLOCKED_SCRIPTS,
  type Hello,
  type ScriptRef,
} from "@corridor/protocol";
import { Refusal, noRobot } from "../../platform/errors/problems.ts";
import type { KeyKind, StoredKey, StoredScript, ScriptChange } from "../../commands/robot-step.ts";
import type { RobotStore, StoredRobot } from "../../store/robot-store.ts";
import { keyId } from "../../platform/keys.ts";
import type { AccessListener, PermissionChanges } from "./access-listener.ts";

/** A key in use, and the script that uses it. */
export interface Caller extends StoredKey {
  /** null for callers that are not scripts: the owner and viewers */
  script: StoredScript | null;
}

/** What a script sends about itself. */
export interface Introduction {
  /** its language, such as "Python" */
  client: string;
  /** its name; null: none */
  name: string | null;
}

export const unknownScript: Introduction = { client: "Script", name: null };

/** @returns the caller that uses a key */
export function callerOf(key: StoredKey, introduction: Introduction): Caller {
  return { ...key, script: key.kind === "drive" ? scriptOf(key.hash, introduction) : null };
}

/** @param driver hash of its key */
export function scriptOf(driver: string, { client, name }: Introduction): StoredScript {
  const mark = name === null ? `language ${client}` : `name ${name}`;
  const id = createHash("sha256").update(`${driver}\n${mark}`).digest("base64url").slice(0, 8);
  return { id, driver, client, name };
}

/** Permissions: each request and message requires one of these verbs. */
export const rights = {
  /** own the robot: receive commands and report their results */
  host: ["own"],
  /** read the stored data of the robot */
  inspect: ["own"],
  /** create, list and revoke keys */
  grant: ["own"],
  /** list scripts, block and unblock them, pause all */
  moderate: ["own"],
  /** delete the robot with all its data */
  remove: ["own"],
  /** send commands, cancel own commands, stop the robot */
  command: ["drive"],
  /** read the robot's maze */
  look: ["own", "drive", "watch"],
  /** read snapshots and states of commands */
  read: ["drive", "watch"],
  /** read the stored commands and their results */
  log: ["own", "drive", "watch"],
} as const satisfies Record<string, readonly KeyKind[]>;

export type Verb = keyof typeof rights;

/** The verb that a role in a `hello` message requires. */
export const verbOfRole = {
  own: "host",
  drive: "command",
  watch: "read",
} as const satisfies Record<Hello["role"], Verb>;

const remedies: Record<KeyKind, string> = {
  own: "The owner key is for the robot's page only. Use the driver key, the part of the address after the #.",
  drive:
    "A driver key does not permit this request. It requires the owner key, which only the robot's page has.",
  watch: READ_ONLY,
};

/**
 * Version of one robot's permissions. It rises when permissions may have changed, and once a
 * second. The result of a check stays valid while the version is unchanged, so frequent callers
 * check rarely.
 */
export class RightsVersion {
  value = 0;

  changed(): void {
    this.value += 1;
  }
}

/** @throws Refusal forbidden if keys of this kind lack the permission */
export function checkRight(kind: KeyKind, verb: Verb): void {
  const kinds: readonly KeyKind[] = rights[verb];
  if (!kinds.includes(kind)) throw new Refusal("forbidden", remedies[kind]);
}

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
  return new Refusal("blocked", BLOCKED_SCRIPT);
}
