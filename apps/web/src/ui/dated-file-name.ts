/** File names of tables that a teacher saves again and again: with their day. */
import { fileName } from "./file-name.ts";

/**
 * A name such as `8b-two-mazes-2026-11-28`.
 * @param name any text
 * @param at milliseconds since 1970; the day is that of the device
 * @param fallback used if nothing of the name remains
 */
export function datedFileName(name: string, at: number, fallback: string): string {
  const date = new Date(at);
  const two = (number: number) => String(number).padStart(2, "0");
  const day = [date.getFullYear(), two(date.getMonth() + 1), two(date.getDate())].join("-");
  return `${fileName(name, fallback)}-${day}`;
}
