/** The keys of one robot: validates, creates and revokes them. */
import { MAX_KEYS, type KeyList, type KeyRequest, type CreatedKey } from "@corridor/protocol";
import { hashKey, keyId, matchKey, mintKey } from "../../platform/keys.ts";
import { noRobot, notAuthorised, Refusal } from "../../platform/errors/problems.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { KeyChange, StoredKey } from "../../commands/robot-step.ts";
import type { KeyUse, RobotStore, StoredRobot } from "../../store/robot-store.ts";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { AccessListener, PermissionChanges } from "./access-listener.ts";
import { checkRight, type RightsVersion, type Verb, type ScriptAccess } from "./callers.ts";

export interface KeyRingParts {
  robot: string;
  rights: RightsVersion;
  stored: Pick<StoredRobot, "keys">;
  store: Pick<RobotStore, "find" | "keyTimes">;
  clock: Clock;
  changes: Pick<PermissionChanges, "changeKeys">;
  /** the permissions of scripts, which are read together with the keys */
  scripts: Pick<ScriptAccess, "apply" | "keyRevoked">;
  listener: Pick<AccessListener, "keysChanged" | "reread" | "revoked" | "doubted">;
}

export class KeyRing {
  readonly #parts: KeyRingParts;
  #keys: readonly StoredKey[];
  /** number of notifications that the keys may have changed */
  #changes = 0;
  /** last use of each key, and the last use that is stored */
  readonly #uses = new Map<string, { at: number; notedAt: number | null }>();
  #isReloading = false;
  /** false: the keys may have changed, and the store did not respond in time */
  #isSure = true;
  #cancelTimers: (() => void)[] = [];

  constructor(parts: KeyRingParts) {
    this.#parts = parts;
    this.#keys = parts.stored.keys;
  }

  /**
   * The stored key that matches; null if no key of this robot matches.
   * @param use where the key stood. A key for URLs is no bearer key, and the reverse
   * @throws StoreUnavailableError if it is unknown whether the key is still valid
   */
  match(key: string, use?: StoredKey["use"]): StoredKey | null {
    const held = matchKey(
      key,
      this.#keys.filter((each) => each.use === use),
    );
    if (held !== null) {
      this.#requireSure(held);
      this.#used(held);
    }
    return held;
  }

  /**
   * Checks that a key is valid and permits an operation.
   * @throws Refusal if the key is revoked or lacks the permission; StoreUnavailableError as for `match`
   */
  check({ hash }: StoredKey, verb: Verb): void {
    const held = this.#keys.find((key) => key.hash === hash);
    if (held === undefined) throw keyRevoked();
    this.#requireSure(held);
    checkRight(held.kind, verb);
    this.#used(held);
  }

  /** All valid keys, with their times from the store and from this relay. */
  async list(): Promise<KeyList["keys"]> {
    const stored = await this.#parts.store.keyTimes(this.#parts.robot);
    const times = new Map(stored.map((each) => [each.hash, each]));
    return this.#keys.map(({ hash, kind, use = null }) => {
      const { createdAt, lastUsedAt } = times.get(hash) ?? { createdAt: 0, lastUsedAt: null };
      const usedAt = Math.max(lastUsedAt ?? 0, this.#uses.get(hash)?.at ?? 0);
      return {
        id: keyId(hash),
        kind,
        use,
        createdAt: new Date(createdAt).toISOString(),
        lastUsedAt: usedAt === 0 ? null : new Date(usedAt).toISOString(),
      };
    });
  }

  /** Uses that are due to be stored: the first of a key immediately, later ones once a minute. */
  dueUses(): KeyUse[] {
    return [...this.#uses].flatMap(([hash, { at, notedAt }]) =>
      notedAt === null || at - notedAt >= limits.touchMs ? [{ hash, at }] : [],
    );
  }

  /** Marks these uses as stored. */
  usesNoted(uses: readonly KeyUse[]): void {
    for (const { hash, at } of uses) {
      const use = this.#uses.get(hash);
      if (use !== undefined) use.notedAt = at;
    }
  }

  /**
   * Creates a key.
   * @returns the key in plain text, which cannot be requested again
   * @throws Refusal too-many-keys, nothing-to-replace or no-robot
   */
  async make({
    kind,
    use,
    replace = false,
  }: KeyRequest): Promise<Pick<CreatedKey, "id" | "kind" | "key">> {
    const alike = use === undefined ? { kind } : { kind, use };
    const remove = typeof replace === "string" ? [await this.#hashToReplace(replace, alike)] : [];
    const key = this.#mint(use ?? kind);
    const hash = hashKey(key);
    const removeKind = replace === true ? alike : null;
    await this.#change({ add: [{ ...alike, hash }], remove, removeKind });
    return { id: keyId(hash), kind, key };
  }

  /**
   * Activates a key that a script has held since it requested access.
   * @throws Refusal too-many-keys or no-robot
   */
  async admit(hash: string): Promise<void> {
    await this.#change({ add: [{ kind: "drive", hash }], remove: [], removeKind: null });
  }

  /**
   * Revokes a key immediately, for all of its users.
   * @throws Refusal no-key, forbidden or no-robot
   */
  async revoke(id: string): Promise<void> {
    const key = await this.#storedKey(id);
    if (key === null) {
      throw new Refusal(
        "no-key",
        "This robot has no key with this id. List its keys with GET .../keys.",
      );
    }
    if (key.kind === "own") {
      throw new Refusal(
        "forbidden",
        "The owner key cannot be revoked. To invalidate it, delete the robot.",
      );
    }
    await this.#change({ add: [], remove: [key.hash], removeKind: null });
  }

  /**
   * Reads the keys again, because another relay may have changed them. If the store does not
   * respond in time, only the owner key is valid until it does.
   */
  refresh(): void {
    this.#changes += 1;
    if (this.#isReloading) return;
    this.#isReloading = true;
    void this.#reload();
  }

  /**
   * Reads the keys and the permissions of scripts once.
   * @returns false if the robot was deleted
   */
  async reread(): Promise<boolean> {
    const stored = await this.#parts.store.find(this.#parts.robot);
    if (stored === null) return false;
    this.#apply(stored.keys);
    this.#parts.scripts.apply(stored);
    return true;
  }

  close(): void {
    for (const cancel of this.#cancelTimers) cancel();
    this.#cancelTimers = [];
  }

  async #reload(): Promise<void> {
    const { clock } = this.#parts;
    const cancelDoubt = clock.after(limits.keysUnsureMs, () => {
      this.#isSure = false;
      this.#parts.rights.changed();
      this.#parts.listener.doubted();
    });
    this.#cancelTimers = [cancelDoubt];
    for (let known = -1; known !== this.#changes;) {
      const asked = this.#changes;
      try {
        if (await this.reread()) this.#parts.listener.reread();
        known = asked;
      } catch {
        await new Promise<void>((resolve) => {
          this.#cancelTimers = [cancelDoubt, clock.after(limits.keysRetryMs, resolve)];
        });
      }
    }
    cancelDoubt();
    this.#isSure = true;
    this.#parts.rights.changed();
    this.#isReloading = false;
  }

  /** The owner key is exempt, because it ends only with the robot itself. */
  #requireSure({ kind }: StoredKey): void {
    if (!this.#isSure && kind !== "own")
      throw new StoreUnavailableError("the valid keys are unknown");
  }

  #apply(keys: readonly StoredKey[]): void {
    const gone = this.#keys.filter(({ hash }) => !keys.some((key) => key.hash === hash));
    this.#keys = keys;
    this.#parts.rights.changed();
    for (const key of gone) {
      this.#uses.delete(key.hash);
      this.#parts.listener.revoked(key);
      this.#parts.scripts.keyRevoked(key);
    }
  }

  #used({ hash }: StoredKey): void {
    const at = this.#parts.clock.now();
    const use = this.#uses.get(hash);
    if (use === undefined) this.#uses.set(hash, { at, notedAt: null });
    else use.at = at;
  }

  /** Reads the key from the store, because another relay may have just created it. */
  async #storedKey(id: string): Promise<StoredKey | null> {
    const stored = await this.#parts.store.find(this.#parts.robot);
    return stored?.keys.find(({ hash }) => keyId(hash) === id) ?? null;
  }

  async #hashToReplace(
    id: string,
    { kind, use }: Pick<StoredKey, "kind" | "use">,
  ): Promise<string> {
    const key = await this.#storedKey(id);
    if (key?.kind === kind && key.use === use) return key.hash;
    const detail = `This robot has no key of kind '${kind}' and this use with the id in 'replace'. List its keys with GET .../keys.`;
    throw new Refusal("nothing-to-replace", detail);
  }

  async #change(change: Pick<KeyChange, "add" | "remove" | "removeKind">): Promise<void> {
    const result = await this.#parts.changes.changeKeys({
      ...change,
      most: MAX_KEYS,
      now: this.#parts.clock.now(),
    });
    if (result.outcome === "no-robot") throw noRobot();
    if (result.outcome === "full") {
      throw new Refusal(
        "too-many-keys",
        `This robot has ${MAX_KEYS} keys, the maximum. Revoke a key, then try again.`,
      );
    }
    this.#apply(result.keys);
    this.#parts.listener.keysChanged();
  }

  /** Creates a key whose id differs from those of the robot's other keys. */
  #mint(kind: "drive" | "watch" | "url"): string {
    for (;;) {
      const key = mintKey(kind);
      const id = keyId(hashKey(key));
      if (!this.#keys.some(({ hash }) => keyId(hash) === id)) return key;
    }
  }
}

/** Error response for a revoked key. */
export function keyRevoked(): Refusal {
  return notAuthorised("This key was revoked. Copy the robot's new address from its page.");
}
