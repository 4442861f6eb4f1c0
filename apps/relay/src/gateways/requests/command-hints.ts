/**
 * Hints for invalid commands that the error of a field does not explain to beginners: a number in
 * the wrong place, and misspelt actions.
 */
import { remoteActionNames, type FieldProblem } from "@corridor/protocol";
import leven from "leven";

/** Maximum number of wrong letters in an action. */
const MAX_MISSPELT = 2;

const NO_UNTIL = "until only with forward, reverse, or drive without milliseconds";

/** Explains the only field that some actions take and others do not. */
export function withUntilHint(problems: readonly FieldProblem[]): FieldProblem[] {
  const isUntil = ({ path, expected }: FieldProblem): boolean =>
    expected === "no field of this name" && /^(command\.)?until$/.test(path);
  return problems.map((each) => (isUntil(each) ? { ...each, expected: NO_UNTIL } : each));
}

/** Adds what was probably meant to the first problem of a command. */
export function withCommandHint(body: unknown, problems: readonly FieldProblem[]): FieldProblem[] {
  const [first, ...rest] = withUntilHint(problems);
  const meant = first === undefined ? null : meantBy(body, first.path);
  if (first === undefined) return [];
  if (meant === null) return [first, ...rest];
  return [{ ...first, expected: meant }, ...rest];
}

function meantBy(body: unknown, path: string): string | null {
  if (typeof body !== "object" || body === null) return null;
  const { action, degrees, distance } = body as Record<string, unknown>;
  if (typeof action !== "string") return null;
  const words = action.trim().toLowerCase().split(/\s+/);
  const [word = "", number] = words;
  if (path !== "action" && path !== "degrees" && path !== "distance") return null;
  const amount =
    path === "action" ? Number(number ?? degrees ?? Number.NaN) : Number(degrees ?? distance);
  if (["left", "right", "turn"].includes(word) && words.length <= 2) {
    if (path === "distance") return null;
    if (path === "degrees" && word === "turn" && number === undefined) return null;
    const isQuarter = number === undefined && degrees === undefined && word !== "turn";
    if (isQuarter) return `'${word} 90'`;
    if (Number.isFinite(amount)) return turn(word === "left" ? -amount : amount);
  }
  const isBackward = ["reverse", "backward", "back"].includes(word);
  if ((isBackward || word === "forward") && words.length <= 2 && path !== "degrees") {
    const cm = path === "action" && number === undefined ? Number(distance) : amount;
    if (Number.isFinite(cm)) return move(isBackward ? -cm : cm);
  }
  return path === "action" ? nearest(words.join(" ")) : null;
}

function turn(degrees: number): string {
  return `the action turn with the field degrees: ${degrees} (negative is left)`;
}

function move(cm: number): string {
  return `the action move with the field distance: ${cm} (negative is backward)`;
}

function nearest(action: string): string | null {
  const [name] = remoteActionNames
    .map((each) => ({ each, distance: leven(each, action) }))
    .filter(({ each, distance }) => distance <= Math.min(MAX_MISSPELT, each.length / 2 - 1))
    .toSorted((a, b) => a.distance - b.distance);
  if (name === undefined) return null;
  return `${name.each}, or another of ${remoteActionNames.filter((each) => each !== name.each).join(", ")}`;
}
