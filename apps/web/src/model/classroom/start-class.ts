/** Starts a class with a lesson. Only what the relay needs is sent: the label stays on the device. */
import { oldestDocumentOf, type LessonDocument } from "@corridor/challenge/document";
import { classFields, createdClassSchema, readJson, type CreatedClass } from "@corridor/protocol";
import type { ClassRefusal } from "./class-calls.ts";

const MAX_ANSWER = 4_096;
/** Largest request, in bytes. */
const MAX_LESSON_BYTES = 64 * 1_024;

export interface ClassRequest {
  lesson: LessonDocument;
  /** pseudonyms; null: the words of the page's language */
  names: string[] | null;
  expected: number | null;
}

export type StartResult = { ok: true; value: CreatedClass } | { ok: false; problem: ClassRefusal };

type Ask = (
  url: string,
  request: { method: "POST"; headers: Record<string, string>; body: string },
) => Promise<Response>;

export async function startClass(request: ClassRequest, ask: Ask): Promise<StartResult> {
  const { lesson, names, expected } = request;
  const body = JSON.stringify({ names, expected, lesson: oldestDocumentOf(lesson) });
  if (new TextEncoder().encode(body).length > MAX_LESSON_BYTES) return failed("too-large");
  try {
    const answer = await ask("/api/v1/classes", {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body,
    });
    const text = await answer.text();
    if (answer.status === 201) {
      const created = readJson(createdClassSchema, text, MAX_ANSWER);
      return created.ok ? created : failed("old");
    }
    if (answer.status === 429) return failed("too-many");
    // A static host has no relay: its responses are web pages.
    const isRelay = answer.headers.get("content-type")?.includes("json") === true;
    return failed(isRelay && answer.status < 500 ? "old" : "offline");
  } catch {
    return failed("offline");
  }
}

/** The pseudonyms of a pasted text, one a line; null if the relay would refuse them. */
export function namesOf(text: string): string[] | null {
  const names = text
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter((line) => line !== "");
  const read = classFields.names.safeParse(names);
  return read.success && read.data !== null ? read.data : null;
}

function failed(problem: ClassRefusal): StartResult {
  return { ok: false, problem };
}
