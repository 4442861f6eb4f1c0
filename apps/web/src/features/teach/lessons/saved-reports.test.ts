import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../../model/storage/testing/memory-storage.ts";
import {
  MAX_SAVED_REPORTS,
  reportId,
  SavedReports,
  type SavedReport,
} from "../../../model/teaching/saved-reports.ts";

function entry(id: string, change: Partial<SavedReport> = {}): SavedReport {
  const report = { id, savedAt: 1, label: "8B", lesson: "Corners", code: "BCDFGH" };
  return { ...report, csv: "student,task\r\n", ...change };
}

describe("the reports on the device", () => {
  it("are listed as they were saved, newest first, until they are deleted", () => {
    const reports = new SavedReports(new MemoryStorage());
    const newer = entry("b", { savedAt: 2, label: "" });
    expect([entry("a"), newer].map((each) => reports.write(each))).toEqual([true, true]);
    expect(reports.list()).toEqual([newer, entry("a")]);
    reports.remove("b");
    expect(reports.list()).toEqual([entry("a")]);
    expect(reports.read("b")).toBe(null);
  });

  it("are as many as fit, and a saved one can be saved again", () => {
    const reports = new SavedReports(new MemoryStorage());
    for (let at = 0; at < MAX_SAVED_REPORTS; at++) reports.write(entry(String(at)));
    expect(reports.write(entry("more"))).toBe(false);
    expect(reports.write(entry("0", { label: "9A" }))).toBe(true);
    expect(reports.read("0")?.label).toBe("9A");
  });

  it("are one for each lesson of a class", () => {
    const reports = new SavedReports(new MemoryStorage());
    const save = (lesson: string, savedAt: number) =>
      reports.write(entry(reportId("class", lesson), { savedAt }));
    save("first", 1);
    save("second", 2);
    save("second", 3);
    expect(reports.list().map(({ savedAt }) => savedAt)).toEqual([3, 1]);
  });

  it("are not saved where the browser refuses", () => {
    const device = new MemoryStorage();
    device.setItem = () => {
      throw new Error("full");
    };
    expect(new SavedReports(device).write(entry("a"))).toBe(false);
  });

  it.each(["", "{", "null", '{"csv":1}'])("leave out the unreadable entry %j", (text) => {
    const device = new MemoryStorage();
    device.setItem("corridor.teach.report.a", text);
    expect(new SavedReports(device).list()).toEqual([]);
  });
});
