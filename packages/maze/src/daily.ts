/**
 * The daily maze. Every client generates the same maze for a date, without a server. The size grows
 * from Monday to Sunday, and the kind changes daily.
 */
import { generateMaze, mazeKinds } from "./generate.ts";
import type { MazeDocument } from "./maze-document.ts";

/** A date of the Gregorian calendar. */
export interface Day {
  /** 1 to 9999 */
  year: number;
  /** 1 to 12 */
  month: number;
  /** 1 to 31 */
  day: number;
}

/** Side lengths from Monday to Sunday, in cells. */
const sides = [9, 11, 11, 13, 13, 15, 17] as const;
/** Day number of the first Monday. Day 0, 1970-01-01, is a Thursday. */
const MONDAY = 4;

/**
 * Generates the maze of a date.
 * @throws RangeError if the date does not exist in the calendar
 */
export function dailyMaze(date: Day, name: string): MazeDocument {
  const number = dayNumber(date);
  const side = sides[modulo(number - MONDAY, 7)] ?? sides[0];
  const kind = mazeKinds[modulo(number, mazeKinds.length)] ?? mazeKinds[0];
  const { year, month, day } = date;
  return generateMaze({
    kind,
    columns: side,
    rows: side,
    seed: year * 10_000 + month * 100 + day,
    name,
  });
}

/** Adds `days` to a date. A negative value returns an earlier date. */
export function dayAfter(date: Day, days: number): Day {
  return dayOf(dayNumber(date) + days);
}

/**
 * Number of days from 1970-01-01 to a date.
 * @throws RangeError if the date does not exist in the calendar
 */
export function dayNumber({ year, month, day }: Day): number {
  // The year starts in March here, so that a leap day is the last day of the year.
  const shifted = month <= 2 ? year - 1 : year;
  const monthFromMarch = (month + 9) % 12;
  const dayOfYear = Math.floor((153 * monthFromMarch + 2) / 5) + day - 1;
  const leaps = Math.floor(shifted / 4) - Math.floor(shifted / 100) + Math.floor(shifted / 400);
  const number = shifted * 365 + leaps + dayOfYear - 719_468;
  const found = dayOf(number);
  if (found.year !== year || found.month !== month || found.day !== day) {
    throw new RangeError(`date: found ${year}-${month}-${day}, expected a date of the calendar`);
  }
  return number;
}

/** Inverse of `dayNumber`: the date `number` days after 1970-01-01. */
function dayOf(number: number): Day {
  const days = number + 719_468;
  const era = Math.floor(days / 146_097);
  const dayOfEra = days - era * 146_097;
  const yearOfEra = Math.floor(
    (dayOfEra -
      Math.floor(dayOfEra / 1460) +
      Math.floor(dayOfEra / 36_524) -
      Math.floor(dayOfEra / 146_096)) /
      365,
  );
  const dayOfYear =
    dayOfEra - (365 * yearOfEra + Math.floor(yearOfEra / 4) - Math.floor(yearOfEra / 100));
  const monthFromMarch = Math.floor((5 * dayOfYear + 2) / 153);
  const month = monthFromMarch < 10 ? monthFromMarch + 3 : monthFromMarch - 9;
  return {
    year: yearOfEra + era * 400 + (month <= 2 ? 1 : 0),
    month,
    day: dayOfYear - Math.floor((153 * monthFromMarch + 2) / 5) + 1,
  };
}

function modulo(number: number, by: number): number {
  return ((number % by) + by) % by;
}
