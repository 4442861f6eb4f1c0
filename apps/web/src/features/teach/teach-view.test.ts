import { expect, it } from "vitest";
import { teachViewOf } from "./teach-view.ts";

it.each([
  ["", { name: "home" }],
  ["#", { name: "home" }],
  ["#hand-ins", { name: "hand-ins" }],
  ["#report", { name: "report" }],
  ["#1AbC", { name: "lesson", link: "1AbC" }],
])("the address with the fragment %j shows the view %j", (hash, view) => {
  expect(teachViewOf(hash)).toEqual(view);
});
