import { readFileSync } from "node:fs";
import { join } from "node:path";
import { quickstartIds, quickstarts } from "@corridor/quickstarts";
import { describe, expect, it } from "vitest";
import connect from "../../text/en/connect.json" with { type: "json" };

const page = join(import.meta.dirname, "../../../../relay/src/site/docs/pages/quickstart.md");
const [, tabs = ""] = readFileSync(page, "utf8").split("<!-- tabs: Connect with -->");
const sections = tabs.split(/^### /m).slice(1);
const names: Record<string, string> = connect.names;

it("the documentation has the quickstarts of the page, in the same order", () => {
  const titles = sections.map((section) => section.slice(0, section.indexOf("\n")));
  expect(titles).toEqual(quickstartIds.map((id) => quickstarts[id].name ?? names[id]));
});

describe.each(quickstartIds)("the documentation of %s", (id) => {
  const section = sections[quickstartIds.indexOf(id)] ?? "";
  const words = section.replaceAll(/\s+/g, " ");
  const { file, command, needs } = quickstarts[id];

  it("has the text from its only source", () => {
    expect(words).toContain(`<!-- quickstart: ${id} -->`);
    // A build file beside the text is no second copy of it.
    const copies = [...section.matchAll(/^```(?=\S)(?!xml\n)/gm)];
    expect(copies).toEqual([]);
  });

  it("says how to save and start it in the words of the page", () => {
    const said = [
      ...(file === null ? [] : [`as \`${file}\``]),
      ...(command === null ? [] : [`with \`${command}\``]),
      ...(needs === null ? [] : [`It needs ${needs} or newer.`]),
    ];
    expect(said.filter((each) => !words.includes(each))).toEqual([]);
  });
});
