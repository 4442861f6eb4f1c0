/** The order of the cards. Pure. */
import { needsHelp, rank, type ShownStanding } from "./standing.ts";

export const sortKeys = ["help", "name", "time"] as const;
/** help: needs help first; time: longest time on the open task first */
export type Sorting = (typeof sortKeys)[number];

export interface OrderedStudent {
  student: number;
  name: string;
  shown: Pick<ShownStanding, "standing" | "since">;
  /** active ms on the open task */
  timeMs: number;
}

/** The order changes at most this often, in ms. */
export const ORDER_MS = 5_000;

/** The numbers of the students, in order. @param compareNames in the language of the page */
export function orderOf(
  students: readonly OrderedStudent[],
  sorting: Sorting,
  compareNames: (a: string, b: string) => number,
): number[] {
  const byNumber = (a: OrderedStudent, b: OrderedStudent): number => a.student - b.student;
  const comparisons: Record<Sorting, (a: OrderedStudent, b: OrderedStudent) => number> = {
    help: (a, b) =>
      rank(a.shown.standing) - rank(b.shown.standing) || a.shown.since - b.shown.since,
    name: (a, b) => compareNames(a.name, b.name),
    time: (a, b) => b.timeMs - a.timeMs,
  };
  const compare = comparisons[sorting];
  return students.toSorted((a, b) => compare(a, b) || byNumber(a, b)).map((each) => each.student);
}

export interface ShownOrder {
  order: readonly number[];
  /** when it last changed, in ms */
  changedAt: number;
  /** number of students who need help and stand behind one who does not; 0: the order is right */
  waiting: number;
}

/**
 * The order to show. It changes at most every 5 s, and never while the pointer or the focus is on a
 * card: the card must not move away. New students are last, removed ones disappear at once.
 * @param wanted the right order
 * @param isHeld whether the pointer or the focus is on a card
 */
export function followOrder(
  before: ShownOrder,
  wanted: readonly number[],
  helped: ReadonlySet<number>,
  { isHeld, now }: { isHeld: boolean; now: number },
): ShownOrder {
  if (isSame(before.order, wanted)) {
    return before.waiting === 0 ? before : { ...before, waiting: 0 };
  }
  const isDue = now - before.changedAt >= ORDER_MS;
  if (!isHeld && isDue) return { order: wanted, changedAt: now, waiting: 0 };
  const present = new Set(wanted);
  const known = new Set(before.order);
  const stays = before.order.filter((student) => present.has(student));
  const order = [...stays, ...wanted.filter((student) => !known.has(student))];
  const next = { ...before, order, waiting: isHeld ? misplaced(order, wanted, helped) : 0 };
  return isSame(order, before.order) && next.waiting === before.waiting ? before : next;
}

/** The students who need help and are not at their place. */
function misplaced(
  order: readonly number[],
  wanted: readonly number[],
  helped: ReadonlySet<number>,
): number {
  const isMoved = wanted.some((student, at) => helped.has(student) && order[at] !== student);
  return isMoved ? wanted.filter((student) => helped.has(student)).length : 0;
}

/** The students who need help. */
export function helpedOf(students: readonly OrderedStudent[]): Set<number> {
  return new Set(
    students.flatMap(({ student, shown }) => (needsHelp(shown.standing) ? [student] : [])),
  );
}

/**
 * The next student who needs help, after the one whose card has the focus.
 * @param order as shown
 * @returns null if nobody needs help
 */
export function nextHelped(
  order: readonly number[],
  helped: ReadonlySet<number>,
  current: number | null,
): number | null {
  const at = current === null ? -1 : order.indexOf(current);
  const rest = [...order.slice(at + 1), ...order.slice(0, at + 1)];
  return rest.find((student) => helped.has(student)) ?? null;
}

function isSame(one: readonly number[], other: readonly number[]): boolean {
  return one.length === other.length && one.every((each, at) => each === other[at]);
}
