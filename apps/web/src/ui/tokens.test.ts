/** Computes the contrast of every pair of text and background tokens, in all four themes. */
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

const css = readFileSync(new URL("tokens.css", import.meta.url), "utf8");

/** The colours in a rule block, by token. */
function colours(selector: string): Map<string, string> {
  const start = css.indexOf(`\n${selector} {`);
  if (start < 0) throw new Error(`tokens.css has no ${selector}`);
  const block = css.slice(start, css.indexOf("\n}", start));
  return new Map(
    [...block.matchAll(/(--[\w-]+): (#[0-9a-f]{6});/g)].map(([, token = "", hex = ""]) => [
      token,
      hex,
    ]),
  );
}

const light = colours(":root");
const dark = new Map([...light, ...colours('[data-theme="dark"]')]);
const contrast = colours('[data-contrast="more"]');
const themes = [
  { name: "light", tokens: light, text: 4.5 },
  { name: "dark", tokens: dark, text: 4.5 },
  { name: "light, high contrast", tokens: new Map([...light, ...contrast]), text: 7 },
  {
    name: "dark, high contrast",
    tokens: new Map([
      ...dark,
      ...contrast,
      ...colours('[data-theme="dark"][data-contrast="more"]'),
    ]),
    text: 7,
  },
];

const surfaces = ["--paper", "--surface", "--surface-2", "--surface-3"];
const textOn: Record<string, readonly string[]> = {
  "--ink": [...surfaces, "--live-bg", "--well", "--thumb"],
  "--ink-2": [...surfaces, "--live-bg", "--well"],
  "--ink-3": surfaces,
  "--on-ink": ["--ink", "--ink-2"],
  "--on-live": ["--live", "--live-hover", "--live-press"],
  "--live-ink": ["--surface", "--live-bg"],
  "--good-ink": ["--surface", "--good-bg", "--live-bg"],
  "--bad-ink": ["--surface", "--bad-bg"],
  "--surface": ["--bad"],
};
/** Edges of controls, states, and colours of the stage. */
const shapesOn: Record<string, readonly string[]> = {
  "--edge": ["--surface", "--surface-2", "--paper"],
  "--live": ["--surface"],
  "--beam": ["--floor"],
  "--wall-edge": ["--floor"],
  "--good": ["--surface", "--floor"],
  "--bad": ["--surface", "--floor"],
  "--focus": ["--surface", "--surface-2", "--paper", "--floor"],
};
/** Additional promises of high contrast. */
const edgesOn: Record<string, readonly string[]> = {
  "--line": ["--surface", "--paper"],
  "--line-2": ["--surface", "--surface-2", "--paper"],
  "--wall": ["--floor"],
  "--live": ["--live-bg", "--floor"],
  "--robot-edge": ["--floor"],
  "--live-soft": ["--floor"],
  "--good-line": ["--surface"],
  "--bad-line": ["--surface"],
};

describe.each(themes)("$name", ({ tokens, text }) => {
  it.each(pairs(textOn))("text %s is readable on %s", (ink, ground) => {
    expect(ratio(tokens, ink, ground)).toBeGreaterThanOrEqual(text);
  });

  it.each(pairs(shapesOn))("shape %s is visible on %s", (shape, ground) => {
    expect(ratio(tokens, shape, ground)).toBeGreaterThanOrEqual(3);
  });
});

describe.each(themes.filter(({ text }) => text === 7))("$name", ({ tokens }) => {
  it.each(pairs(edgesOn))("edge %s is visible on %s", (edge, ground) => {
    expect(ratio(tokens, edge, ground)).toBeGreaterThanOrEqual(3);
  });
});

function pairs(table: Record<string, readonly string[]>): [string, string][] {
  return Object.entries(table).flatMap(([one, others]) =>
    others.map((other): [string, string] => [one, other]),
  );
}

/** WCAG 2.2's contrast ratio, 1 to 21. */
function ratio(tokens: ReadonlyMap<string, string>, one: string, other: string): number {
  const [high, low] = [luminance(tokens, one), luminance(tokens, other)].sort((a, b) => b - a);
  return ((high ?? 0) + 0.05) / ((low ?? 0) + 0.05);
}

function luminance(tokens: ReadonlyMap<string, string>, token: string): number {
  const hex = tokens.get(token);
  if (hex === undefined) throw new Error(`${token} has no colour`);
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
