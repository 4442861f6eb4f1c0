/**
 * The maze of the day: a date gives the same maze to everybody, without a server. The size rises from
 * Monday to Sunday, the kind changes from day to day.
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

/** Sides from Monday to Sunday, in cells. */
const sides = [9, 11, 11, 13, 13, 15, 17] as const;
/** Index of Monday in a count of days that begins on a Thursday. */
const MONDAY = 4;

/**
 * The maze of a date.
 * @throws RangeError when the calendar has no such date
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

/** The date so many days later, or earlier where `days` is negative. */
export function dayAfter(date: Day, days: number): Day {
  return dayOf(dayNumber(date) + days);
}

/**
 * Days from 1970-01-01 to a date.
 * @throws RangeError when the calendar has no such date
 */
export function dayNumber({ year, month, day }: Day): number {
  // The year begins in March, so that a leap day is its last one.
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

/** The date so many days after 1970-01-01. */
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
