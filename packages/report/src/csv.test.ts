import fc from "fast-check";
import { expect, it } from "vitest";
import { csvLines, parseCsv } from "./csv.ts";

it.each([
  { cell: "=1+1", line: `"'=1+1"` },
  { cell: "@SUM(A1)", line: `"'@SUM(A1)"` },
  { cell: "-2", line: `"'-2"` },
  { cell: -2, line: "-2" },
  { cell: 'a "b", c', line: '"a ""b"", c"' },
  { cell: "two\nlines", line: '"two\nlines"' },
  { cell: true, line: "true" },
  { cell: null, line: "" },
])("writes $cell so that a spreadsheet does not run it", ({ cell, line }) => {
  expect(csvLines(["x", "y"], [[cell, 1]])).toEqual(["x,y", `${line},1`]);
});

it("reads what it wrote", () => {
  const text = fc.string({ unit: "grapheme", maxLength: 12 }).map((each) => each.trim());
  const formula = fc.tuple(fc.constantFrom("=", "+", "-", "@", "'", "'="), text);
  const cell = fc.oneof(
    text,
    formula.map((parts) => parts.join("").trim()),
  );
  fc.assert(
    fc.property(fc.array(fc.tuple(cell, cell), { maxLength: 5 }), (rows) => {
      const lines = csvLines(["first", "second"], rows);
      const read = parseCsv(lines.join("\r\n"), 100);
      const isEmpty = (row: readonly string[]) => row.every((each) => each === "");
      expect(read?.rows.map(({ cells }) => cells)).toEqual(rows.filter((row) => !isEmpty(row)));
    }),
  );
});

it.each([",", ";", "\t"])(
  "reads columns that %j separates, and counts rows as a spreadsheet",
  (separator) => {
    const text = ["\u{feff}a", "b"].join(separator);
    const row = ["1", " 2 "].join(separator);
    expect(parseCsv(`${text}\n${row}\n${separator}\n\n${row}\n`, 10)).toEqual({
      columns: ["a", "b"],
      rows: [
        { at: 2, cells: ["1", "2"] },
        { at: 5, cells: ["1", "2"] },
      ],
    });
  },
);

it("reads no more rows than asked", () => {
  expect(parseCsv("a\n1\n2\n3\n", 2)?.rows).toHaveLength(2);
});

it.each(["", 'a,b\n"1,2'])("reports that %j is no table", (text) => {
  expect(parseCsv(text, 10)).toBeNull();
});
