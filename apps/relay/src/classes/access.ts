/** Who may do what in a class: the kind of each key, and the rights that it gives. */
import { notAuthorised, Refusal } from "../platform/errors/problems.ts";
import { hashKey, isSameHash } from "../platform/keys.ts";
import type { ClassState } from "./class-state.ts";

/** teach: a dashboard; show: a big screen; learn: a student */
export type Member =
  | { kind: "teach" | "show" }
  | { kind: "learn"; student: number; /** hash of the key */ key: string };

/** Permissions: each request requires one of these verbs. */
export const classRights = {
  /** read the class with its students */
  inspect: ["teach"],
  /** end the class */
  end: ["teach"],
  /** change the lesson, pause, lock, pace, codes and students */
  direct: ["teach"],
  /** connect as a dashboard, a big screen or a student */
  teach: ["teach"],
  show: ["show"],
  learn: ["learn"],
  /** read the lesson */
  readLesson: ["teach", "show", "learn"],
} as const satisfies Record<string, readonly Member["kind"][]>;

export type ClassVerb = keyof typeof classRights;

/** The member with a key; null if the class has none. */
export function memberOf({ row, students }: ClassState, key: string): Member | null {
  const given = hashKey(key);
  const known = row.keys.find(({ hash }) => isSameHash(hash, given));
  if (known !== undefined) return { kind: known.kind };
  for (const { student, key: hash } of students.values()) {
    if (isSameHash(hash, given)) return { kind: "learn", student, key: hash };
  }
  return null;
}

/** @throws Refusal forbidden if keys of this kind lack the permission */
export function checkClassRight(kind: Member["kind"], verb: ClassVerb): void {
  const kinds: readonly Member["kind"][] = classRights[verb];
  if (kinds.includes(kind)) return;
  throw new Refusal("forbidden", remedies[kinds[0] ?? "teach"]);
}

/** By the kind of key that is required. */
const remedies: Record<Member["kind"], string> = {
  teach: "This requires the teacher's key, which starts with tea_.",
  show: "This requires the key of the big screen, which starts with scr_.",
  learn: "This requires the key of a student, which starts with stu_.",
};

/** @param key as sent; null: none */
export function wrongClassKey(key: string | null): Refusal {
  return notAuthorised(
    key === null
      ? "Send a key of this class, as: Authorization: Bearer KEY"
      : "The key is invalid, or the teacher removed this student. Join the class again with its code.",
  );
}
