import { expect, it } from "vitest";
import { addReportFiles } from "./report-files.ts";

it("a table of a billion rows is refused before it is read", async () => {
  const text = () => Promise.reject(new Error("the file was read"));
  const file = { name: "rows.csv", size: 2_000_000_000, text };
  expect(await addReportFiles([], [file])).toEqual({
    files: [],
    problems: [{ file: "rows.csv", code: "size" }],
  });
});
