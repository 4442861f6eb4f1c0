/** Formats tables as CSV. */

export type CsvValue = string | number | boolean;

/** Formats a table with a header row. @returns its lines */
export function csvTable(
  columns: readonly string[],
  rows: readonly (readonly CsvValue[])[],
): string[] {
  return [columns.join(","), ...rows.map((row) => row.map(csvField).join(","))];
}

function csvField(value: CsvValue): string {
  const text = String(value);
  // Spreadsheets evaluate text with these initial characters as a formula; a leading quote prevents
  // it.
  const safe = typeof value === "string" && /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
