/** CSV tables (RFC 4180) that are safe to open in a spreadsheet. */
import Papa from "papaparse";

export type CsvValue = string | number | boolean | null;

/** Spreadsheets evaluate text with these initial characters as a formula; a leading quote prevents it. */
const FORMULA = /^[=+\-@\t\r']/;

/** Formats a table with a header row. @returns its lines, without a line break at the end */
export function csvLines(
  columns: readonly string[],
  rows: readonly (readonly CsvValue[])[],
): string[] {
  return [columns, ...rows].map((row) => Papa.unparse([[...row]], { escapeFormulae: FORMULA }));
}

export interface CsvTable {
  columns: string[];
  /** `at`: the row's number in a spreadsheet, where the header has number 1 */
  rows: { at: number; cells: string[] }[];
}

/**
 * Reads a table with a header row. Commas, semicolons and tabs separate cells; empty rows are
 * skipped, and quotes that `csvLines` added are removed.
 * @param maxRows further rows are not read
 * @returns null if the text is no table
 */
export function parseCsv(text: string, maxRows: number): CsvTable | null {
  const { data, errors } = Papa.parse<string[]>(text, {
    delimiter: separatorOf(text),
    preview: maxRows + 1,
  });
  const [columns, ...rows] = data.map((row) => row.map(cellOf));
  if (columns === undefined || text.trim() === "" || errors.length > 0) return null;
  return {
    columns,
    rows: rows
      .map((cells, index) => ({ at: index + 2, cells }))
      .filter(({ cells }) => cells.some((cell) => cell !== "")),
  };
}

/** The separator that the header row contains most often. */
function separatorOf(text: string): string {
  const [header = ""] = text.split(/[\r\n]/, 1);
  const count = (separator: string): number => header.split(separator).length;
  return [",", ";", "\t"].reduce((best, each) => (count(each) > count(best) ? each : best));
}

function cellOf(text: string): string {
  const cell = text.trim();
  return cell.startsWith("'") && FORMULA.test(cell.slice(1)) ? cell.slice(1) : cell;
}
