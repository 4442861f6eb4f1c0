/**
 * The student's best run in each daily maze, stored on this device. Fewer ticks are better, then
 * fewer bumps.
 */
import { isSameLayout, dailyMaze, dayAfter, type Day, type MazeDocument } from "@corridor/maze";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

/** Number of days before today whose mazes can be chosen. */
export const EARLIER_DAYS = 30;

const KEY = "corridor.daily";

export interface DailyBest {
  ticks: number;
  bumps: number;
}

/** The date in UTC, which is the same everywhere at one moment. */
export function utcDay(date: Date): Day {
  return { year: date.getUTCFullYear(), month: date.getUTCMonth() + 1, day: date.getUTCDate() };
}

/** Returns the best run of a day; null if this device has none. */
export function bestOf(storage: Pick<KeyValueStorage, "getItem">, day: Day): DailyBest | null {
  return read(storage).get(keyOf(day)) ?? null;
}

/**
 * Stores a run to the goal if it is the best so far. Its maze must be that of today or of the
 * `EARLIER_DAYS` days before.
 */
export function noteDaily(
  storage: Pick<KeyValueStorage, "getItem" | "setItem">,
  maze: MazeDocument,
  run: DailyBest,
  today: Day,
): void {
  const day = dayOfMaze(maze, today);
  if (day === null) return;
  const all = read(storage);
  const best = all.get(keyOf(day));
  if (best !== undefined && !isBetter(run, best)) return;
  all.set(keyOf(day), { ticks: run.ticks, bumps: run.bumps });
  const oldest = keyOf(dayAfter(today, -EARLIER_DAYS));
  const stored = [...all].filter(([key]) => key >= oldest);
  try {
    storage.setItem(KEY, JSON.stringify(Object.fromEntries(stored)));
  } catch {
    // The autosave reports a full or forbidden storage.
  }
}

/** Returns the day of a maze, whatever its name; null for other mazes. */
export function dayOfMaze(maze: MazeDocument, today: Day): Day | null {
  for (let back = 0; back <= EARLIER_DAYS; back++) {
    const day = dayAfter(today, -back);
    if (isSameLayout(dailyMaze(day, ""), maze)) return day;
  }
  return null;
}

/** "2026-11-23": text order is date order. */
export function keyOf({ year, month, day }: Day): string {
  const two = (number: number) => String(number).padStart(2, "0");
  return `${String(year).padStart(4, "0")}-${two(month)}-${two(day)}`;
}

function isBetter(run: DailyBest, best: DailyBest): boolean {
  return run.ticks < best.ticks || (run.ticks === best.ticks && run.bumps < best.bumps);
}

/** An entry that cannot be read counts as none. */
function read(storage: Pick<KeyValueStorage, "getItem">): Map<string, DailyBest> {
  let stored: unknown;
  try {
    stored = JSON.parse(storage.getItem(KEY) ?? "{}");
  } catch {
    return new Map();
  }
  const entries = stored !== null && typeof stored === "object" ? Object.entries(stored) : [];
  return new Map(entries.filter((entry): entry is [string, DailyBest] => isBest(entry[1])));
}

function isBest(value: unknown): value is DailyBest {
  if (value === null || typeof value !== "object") return false;
  const { ticks, bumps } = value as Partial<Record<keyof DailyBest, unknown>>;
  return Number.isInteger(ticks) && Number.isInteger(bumps);
}
