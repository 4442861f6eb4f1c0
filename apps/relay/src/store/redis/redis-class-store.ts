/** Classes in Redis or Valkey. Each commit is published to the other relays in the same step. */
import { z } from "zod";
import { classRowIn, studentRowIn } from "../class-rows.ts";
import type {
  ClassChanges,
  ClassCommitResult,
  ClassStore,
  CodeRow,
  FoundCode,
  LoadedClass,
  NewClass,
} from "../class-store.ts";
import { asked, type Redis } from "./connection.ts";
import type { DeletedBytes } from "./deleted-bytes.ts";
import { CLASS_BIRTHS, CLASS_USES, classCodeKeyOf, classKeyOf } from "./redis-keys.ts";
import { removeExpired } from "./remove-expired.ts";
import { Script } from "./script.ts";

const commitAnswer = z.enum(["committed", "conflict", "code-taken", "no-class"]);
/** `students` is the inside of a JSON array, because Lua has one type for lists and objects. */
const loadAnswer = z.object({ row: z.string(), students: z.string() }).nullable();
const progressAnswer = z.array(
  z.object({ student: z.coerce.number(), texts: z.array(z.string()) }),
);

export class RedisClassStore implements ClassStore {
  readonly #redis: Redis;
  readonly #script: Script;
  readonly #deletedBytes: DeletedBytes;

  /** @param redis closed by the caller */
  constructor(redis: Redis, deletedBytes: DeletedBytes) {
    this.#redis = redis;
    this.#script = new Script(redis, ["expiry.lua", "classes.lua"]);
    this.#deletedBytes = deletedBytes;
  }

  async create({ id, row, lesson, code }: NewClass): Promise<boolean> {
    const values = {
      id,
      version: row.version,
      row: JSON.stringify(row),
      lesson,
      code: { hash: code },
    };
    return z.boolean().parse(await this.#step("create", { ...values, createdAt: row.createdAt }));
  }

  async load(id: string): Promise<LoadedClass | null> {
    const found = loadAnswer.parse(await this.#step("load", { id }));
    if (found === null) return null;
    const students = z.array(z.unknown()).parse(JSON.parse(`[${found.students}]`));
    return {
      row: classRowIn(found.row),
      students: students
        .map((each) => studentRowIn(JSON.stringify(each)))
        .toSorted((a, b) => a.student - b.student),
    };
  }

  async commit(
    id: string,
    version: number,
    changes: ClassChanges,
    message: string,
  ): Promise<ClassCommitResult> {
    const { row, students, removed, progress, programs, lesson, newCodes, oldCodes } = changes;
    const result = await this.#step("commit", {
      id,
      expected: version,
      version: row.version,
      row: JSON.stringify(row),
      students: students.map((each) => ({ student: each.student, text: JSON.stringify(each) })),
      removed,
      progress,
      programs,
      ...(lesson !== null && { lesson }),
      newCodes: newCodes.map(withoutNulls),
      oldCodes,
      message,
    });
    const answer = commitAnswer.parse(result);
    if (answer === "committed" && removed.length > 0) this.#deletedBytes.deleted();
    return answer;
  }

  async erased(): Promise<void> {
    await this.#deletedBytes.sweep();
  }

  async findCode(hash: string): Promise<FoundCode | null> {
    const found = await asked(this.#redis.get(classCodeKeyOf(hash)));
    if (found === null) return null;
    const [id = "", student, endsAt] = found.split(" ");
    return { id, student: numberOf(student), endsAt: numberOf(endsAt) };
  }

  async lesson(id: string): Promise<string | null> {
    return asked(this.#redis.hGet(classKeyOf(id), "lesson"));
  }

  async program(id: string, student: number): Promise<string | null> {
    return asked(this.#redis.hGet(classKeyOf(id), `program:${student}`));
  }

  async progress(id: string): Promise<{ student: number; text: string }[]> {
    const lists = progressAnswer.parse(await this.#step("progress", { id }));
    return lists
      .toSorted((a, b) => a.student - b.student)
      .flatMap(({ student, texts }) => texts.map((text) => ({ student, text })));
  }

  async touch(id: string, now: number): Promise<void> {
    await this.#step("touch", { id, now });
  }

  async remove(id: string): Promise<boolean> {
    const isRemoved = z.boolean().parse(await this.#step("remove", { id }));
    if (isRemoved) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return isRemoved;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const all = await removeExpired(before, async (values) => this.#step("removeExpired", values));
    if (all.length > 0) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return all;
  }

  async #step(name: string, values: unknown): Promise<unknown> {
    return this.#script.run(name, [CLASS_USES, CLASS_BIRTHS], values);
  }
}

/** A part of the value of a code: `-` is no number. */
function numberOf(text = "-"): number | null {
  return text === "-" ? null : Number(text);
}

/** A null of JSON is not nil in Lua. */
function withoutNulls({ hash, student, endsAt }: CodeRow): object {
  return { hash, ...(student !== null && { student }), ...(endsAt !== null && { endsAt }) };
}
