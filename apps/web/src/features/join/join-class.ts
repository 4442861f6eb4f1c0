/** Joins a class with the letters that the teacher shows. */
import {
  joinedClassSchema,
  joinRequestSchema,
  MAX_STUDENTS,
  PAIRING_LENGTH,
  PAIRING_LETTERS,
  problemSchema,
  readJson,
  readValue,
  type JoinedClass,
  type ProblemDocument,
} from "@corridor/protocol";

const MAX_ANSWER = 4_096;
/** if the relay does not send a `Retry-After` */
const DEFAULT_WAIT_SECONDS = 20;
const PAIRING_CODE = new RegExp(`^[${PAIRING_LETTERS}]{${PAIRING_LENGTH}}$`);

export type JoinProblem =
  /** `wrong`: no class has this code; `robot`: a pairing code; `old`: the page is too old */
  | { kind: "wrong" | "robot" | "locked" | "old" | "offline" }
  /** number of students in the class */
  | { kind: "full"; count: number }
  | { kind: "tooFast"; seconds: number };

export type JoinResult = { ok: true; value: JoinedClass } | { ok: false; problem: JoinProblem };

interface JoinRequest {
  method: "POST";
  headers: Record<string, string>;
  body: string;
}

/** the part of fetch that is used */
type Ask = (url: string, request: JoinRequest) => Promise<Response>;

/** @param typed upper or lower case, with spaces or hyphens */
export async function joinClass(typed: string, ask: Ask): Promise<JoinResult> {
  const code = readValue(joinRequestSchema, { code: typed });
  if (!code.ok) return failed(isPairingCode(typed) ? "robot" : "wrong");
  try {
    const answer = await ask("/api/v1/joins", {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(code.value),
    });
    const text = await answer.text();
    if (answer.status === 201) {
      const joined = readJson(joinedClassSchema, text, MAX_ANSWER);
      return joined.ok ? joined : failed("old");
    }
    return refused(answer, text);
  } catch {
    return failed("offline");
  }
}

function refused(answer: Response, text: string): JoinResult {
  const problem = readJson(problemSchema, text, MAX_ANSWER);
  // A static host has no relay: its responses are web pages.
  if (!problem.ok || answer.status >= 500) return failed("offline");
  switch (problem.value.type) {
    case "/problems/no-class":
      return failed("wrong");
    case "/problems/class-locked":
      return failed("locked");
    case "/problems/class-full":
      return full(problem.value);
    default:
      return answer.status === 429 ? tooFast(answer) : failed("old");
  }
}

function tooFast(answer: Response): JoinResult {
  const seconds = Number(answer.headers.get("retry-after"));
  const isUsable = Number.isInteger(seconds) && seconds > 0;
  return {
    ok: false,
    problem: { kind: "tooFast", seconds: isUsable ? seconds : DEFAULT_WAIT_SECONDS },
  };
}

/** A class with pseudonyms of the teacher has as many places as names. */
function full({ errors }: ProblemDocument): JoinResult {
  const count = Number(errors.find(({ path }) => path === "students")?.found);
  return { ok: false, problem: { kind: "full", count: count > 0 ? count : MAX_STUDENTS } };
}

function failed(kind: Exclude<JoinProblem["kind"], "tooFast" | "full">): JoinResult {
  return { ok: false, problem: { kind } };
}

function isPairingCode(typed: string): boolean {
  return PAIRING_CODE.test(typed.toUpperCase().replaceAll(/[ -]/g, ""));
}
