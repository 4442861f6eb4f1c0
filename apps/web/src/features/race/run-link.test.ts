import { encodeLink } from "@corridor/link";
import { Recording } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { readRunLink } from "./run-link.ts";

function linkOf(content: Parameters<typeof encodeLink>[0]): string {
  const encoded = encodeLink(content);
  if (!encoded.ok) throw new Error(encoded.code);
  return encoded.text;
}

function runText(): string {
  const recording = new Recording(firstMaze, firstProgram);
  for (let tick = 0; tick < 60; tick++) recording.step();
  const written = recording.toDocument(firstMaze.name);
  if (!written.ok) throw new Error("no run");
  return linkOf({ run: written.run });
}

const notARun = { ok: false, refusal: "not-a-run" };
const broken = { ok: false, refusal: "broken" };

describe("a link that is pasted into a race", () => {
  it("is read as a whole link, and as what follows its #", () => {
    const text = runText();
    for (const link of [`https://corridor.example/?lang=de#${text}`, text, ` #${text}\n`]) {
      expect(readRunLink(link)).toMatchObject({ ok: true, run: { ticks: 60 } });
    }
  });

  it("is no run where it leads to a maze, a mission, a short link or the page itself", () => {
    expect(readRunLink(`https://corridor.example/#${linkOf({ maze: firstMaze })}`)).toEqual(
      notARun,
    );
    expect(readRunLink("https://corridor.example/#mission/side-opening")).toEqual(notARun);
    expect(readRunLink("https://corridor.example/m/SRCN")).toEqual(notARun);
    expect(readRunLink("https://corridor.example/")).toEqual(notARun);
  });

  it("is broken where a part is missing or it is some other text", () => {
    expect(readRunLink(`https://corridor.example/#${runText().slice(0, -4)}`)).toEqual(broken);
    expect(readRunLink("hello")).toEqual(broken);
  });
});
