/**
 * Pairing codes in Redis or Valkey. The page and the script may be connected to different relays.
 */
import { z } from "zod";
import type {
  NewPairing,
  PairingFinder,
  PairingStore,
  PairingTransition,
  StoredPairing,
} from "../pairing-store.ts";
import type { Redis } from "./connection.ts";
import type { DeletedBytes } from "./deleted-bytes.ts";
import { Script } from "./script.ts";

const ENDS = "corridor:pairings";
/** Codes to delete per step, because each step blocks Redis. */
const MOST_AT_ONCE = 500;

const openAnswer = z.enum(["opened", "taken", "no-robot"]);
const question = z
  .object({ key: z.string(), name: z.string().nullable(), client: z.string() })
  .nullable();
const findAnswer = z
  .object({
    robot: z.string(),
    code: z.string(),
    endsAt: z.number(),
    state: z.enum(["open", "asked", "accepted", "refused"]),
    // As text, because a Lua table cannot hold null.
    question: z
      .string()
      .transform((text): unknown => JSON.parse(text))
      .pipe(question),
  })
  .nullable();

export class RedisPairingStore implements PairingStore {
  readonly #script: Script;
  readonly #deletedBytes: DeletedBytes;

  /** @param redis closed by the caller */
  constructor(redis: Redis, deletedBytes: DeletedBytes) {
    this.#script = new Script(redis, ["pairings.lua"]);
    this.#deletedBytes = deletedBytes;
  }

  async open(pairing: NewPairing): Promise<"opened" | "taken" | "no-robot"> {
    return openAnswer.parse(await this.#step("open", pairing));
  }

  async find(by: PairingFinder, now: number): Promise<StoredPairing | null> {
    return findAnswer.parse(await this.#step("find", { ...robotOrHash(by), now }));
  }

  async transition(
    by: PairingFinder,
    { from, to, question: asked }: PairingTransition,
    now: number,
  ): Promise<boolean> {
    const stored = asked && { key: asked.key, question: JSON.stringify(asked) };
    const values = { ...robotOrHash(by), from, to, ...stored, now };
    return z.boolean().parse(await this.#step("transition", values));
  }

  async remove(robot: string): Promise<boolean> {
    const removed = z.boolean().parse(await this.#step("remove", { robot }));
    if (removed) {
      this.#deletedBytes.deleted();
      await this.#deletedBytes.sweep();
    }
    return removed;
  }

  async removeEnded(now: number): Promise<number> {
    let total = 0;
    for (let count = MOST_AT_ONCE; count === MOST_AT_ONCE; total += count) {
      count = z.int().parse(await this.#step("removeEnded", { now, most: MOST_AT_ONCE }));
    }
    if (total > 0) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return total;
  }

  async #step(name: string, values: unknown): Promise<unknown> {
    return this.#script.run(name, [ENDS], values);
  }
}

function robotOrHash(by: PairingFinder): { robot: string } | { hash: string } {
  return "robot" in by ? by : { hash: "code" in by ? by.code : by.key };
}
