/** The keys of one robot: whose a key is, new ones, and the end of old ones for everybody who uses them. */
import { MAX_KEYS, type KeyList, type KeyWish, type MadeKey } from "@corridor/protocol";
import { hashKey, keyId, matchKey, mintKey } from "../keys.ts";
import { noRobot, notAuthorised, Refusal } from "../problems.ts";
import type { KeyChange, SessionStore, StoredKey } from "../store/session-store.ts";
import { checkRight, type Verb } from "./rights.ts";

export interface KeyRingParts {
  robot: string;
  keys: readonly StoredKey[];
  store: SessionStore;
  /** is told when this relay has changed the keys */
  changed: () => void;
  /** is told of a key that counts no more */
  revoked: (key: StoredKey) => void;
}

export class KeyRing {
  readonly #robot: string;
  readonly #store: SessionStore;
  readonly #changed: () => void;
  readonly #revoked: (key: StoredKey) => void;
  #keys: readonly StoredKey[];

  constructor({ robot, keys, store, changed, revoked }: KeyRingParts) {
    this.#robot = robot;
    this.#store = store;
    this.#changed = changed;
    this.#revoked = revoked;
    this.#keys = keys;
  }

  /** The stored key that belongs to a bearer key; null when it is none of this robot's. */
  match(key: string): StoredKey | null {
    return matchKey(key, this.#keys);
  }

  /** Asked at every message. @throws Refusal when the key was revoked, or does not allow it */
  check({ hash }: StoredKey, verb: Verb): void {
    const held = this.#keys.find((key) => key.hash === hash);
    if (held === undefined) throw keyRevoked();
    checkRight(held.kind, verb);
  }

  list(): KeyList["keys"] {
    return this.#keys.map(({ hash, kind }) => ({ id: keyId(hash), kind }));
  }

  /**
   * Makes a key.
   * @returns the key itself, which nobody can ask for again
   * @throws Refusal when there are too many
   */
  async make({ kind, replace = false }: KeyWish): Promise<Omit<MadeKey, "address">> {
    const key = this.#mint(kind);
    const hash = hashKey(key);
    const old = this.#keys.filter((other) => replace && other.kind === kind);
    await this.#change({ add: [{ kind, hash }], remove: old.map((other) => other.hash) });
    return { id: keyId(hash), kind, key };
  }

  /** Ends a key at once, wherever it is in use. @throws Refusal when it cannot be revoked */
  async revoke(id: string): Promise<void> {
    const key = this.#keys.find(({ hash }) => keyId(hash) === id);
    if (key === undefined) {
      throw new Refusal("no-key", "It was revoked already, or never was. GET .../keys lists all.");
    }
    if (key.kind === "own") {
      throw new Refusal("forbidden", "The owner key ends with its robot: delete the robot itself.");
    }
    await this.#change({ add: [], remove: [key.hash] });
  }

  /** Looks again which keys count: another relay has changed them, or may have. */
  async refresh(): Promise<void> {
    const stored = await this.#store.find(this.#robot);
    if (stored !== null) this.#learn(stored.keys);
  }

  #learn(keys: readonly StoredKey[]): void {
    const gone = this.#keys.filter(({ hash }) => !keys.some((key) => key.hash === hash));
    this.#keys = keys;
    for (const key of gone) this.#revoked(key);
  }

  async #change(change: Omit<KeyChange, "most">): Promise<void> {
    const result = await this.#store.changeKeys(this.#robot, { ...change, most: MAX_KEYS });
    if (result.outcome === "no-session") throw noRobot();
    if (result.outcome === "full") {
      throw new Refusal("too-many-keys", `A robot has ${MAX_KEYS} at most. Revoke one first.`);
    }
    this.#learn(result.keys);
    this.#changed();
  }

  /** A key whose id no other key of this robot has. */
  #mint(kind: KeyWish["kind"]): string {
    for (;;) {
      const key = mintKey(kind);
      if (!this.list().some(({ id }) => id === keyId(hashKey(key)))) return key;
    }
  }
}

/** The answer to whoever used a key when it was revoked. */
export function keyRevoked(): Refusal {
  return notAuthorised("This key was revoked. Copy the robot's new address from its page.");
}
