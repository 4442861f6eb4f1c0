import { expect, it } from "vitest";
import { handInsHash, lessonHash, teachViewOf } from "./teach-view.ts";

it.each([
  ["", { name: "home" }],
  ["#", { name: "home" }],
  ["#make", { name: "make" }],
  ["#hand-ins", { name: "hand-ins", lesson: null }],
  ["#report", { name: "report", report: null }],
  ["#report=a1", { name: "report", report: "a1" }],
  ["#1AbC", { name: "link", link: "1AbC" }],
  [lessonHash("a1"), { name: "lesson", id: "a1" }],
  [handInsHash("a1"), { name: "hand-ins", lesson: "a1" }],
])("the address with the fragment %j shows the view %j", (hash, view) => {
  expect(teachViewOf(hash)).toEqual(view);
});
