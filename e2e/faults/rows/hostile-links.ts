/**
 * Links made to harm who opens them, in a real browser: each is opened or told off, and nothing of
 * it runs.
 */
import { encodeLink } from "@corridor/link";
import { brokenDocuments } from "@corridor/link/testing";
import { generateTree } from "@corridor/maze";
import { chromium } from "playwright";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { checkOf, textOf } from "../../../packages/link/src/digits.ts";
import { chromiumArguments, requireChromium } from "../../../scripts/chromium.ts";
import share from "../../../apps/web/src/text/en/share.json" with { type: "json" };
import { RelayProcess } from "../../support/relay-process.ts";
import type { Row } from "../row.ts";

const REFUSALS = Object.values(share.linkProblems);
const LINKS = { short: 150, long: 1_500 };
const ANSWER_MS = 2_000;
const HEAP_MIB = 150;
const MARK = "hostileLinkRan";
const SCRIPTS = [
  `<script>${MARK}=1</script>`,
  `<img src=x onerror=${MARK}=1>`,
  `javascript:${MARK}=1`,
  `"><svg onload=${MARK}=1>`,
  `{{constructor.constructor('${MARK}=1')()}}`,
];

export const hostileLinks: Row = {
  title: "Hostile links",
  does: (isLong) =>
    `${isLong ? LINKS.long : LINKS.short} forged, broken and oversized links, and names with scripts in them, opened one after the other in Chromium`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const browser = await chromium.launch({
      executablePath: requireChromium(),
      args: [...chromiumArguments, "--enable-precise-memory-info"],
    });
    terms.after(() => browser.close());
    const context = await browser.newContext({ serviceWorkers: "block" });
    const page = await context.newPage();
    await page.goto(relay.url);
    await page.getByText(/^Robot at /).waitFor();
    const messages = page.getByRole("region", { name: "Messages" });

    const wanted = terms.isLong ? LINKS.long : LINKS.short;
    let told = 0;
    let opened = 0;
    let silent = 0;
    let longestMs = 0;
    let heapMib = 0;
    let ran = 0;
    for (let n = 0; n < wanted; n++) {
      const text = hostileLink(dice, n);
      const began = performance.now();
      await page.evaluate((hash) => (location.hash = hash), text);
      // The fragment goes once the page has dealt with the link, one way or the other.
      await page.waitForFunction(() => location.hash === "", undefined, { timeout: 30_000 });
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => done(null))));
      longestMs = Math.max(longestMs, performance.now() - began);
      const sentences = (await messages.count()) > 0 ? await messages.innerText() : "";
      if (REFUSALS.some((sentence) => sentences.includes(sentence))) told += 1;
      else if (sentences.includes("You opened a shared")) opened += 1;
      else silent += 1;
      const found = await page.evaluate((mark) => {
        const { memory } = performance as Performance & { memory: { usedJSHeapSize: number } };
        return { hasRun: mark in window, heap: memory.usedJSHeapSize / 1024 / 1024 };
      }, MARK);
      heapMib = Math.max(heapMib, found.heap);
      ran += Number(found.hasRun);
      for (const button of await messages.getByRole("button", { name: "Dismiss" }).all()) {
        await button.click();
      }
    }
    terms.say(`${told} told off, ${opened} opened as what they hold`);
    return [
      {
        label: "the page answers, longest",
        measured: longestMs,
        bound: { atMost: ANSWER_MS },
        unit: "ms",
      },
      { label: "memory of the page", measured: heapMib, bound: { atMost: HEAP_MIB }, unit: "MiB" },
      { label: "scripts that ran", measured: ran, bound: { atMost: 0 }, unit: "" },
      {
        label: "links told off in a sentence",
        measured: told,
        bound: { atLeast: Math.floor(wanted / 3) },
        unit: `of ${wanted}`,
      },
      {
        label: "links that were neither told off nor opened",
        measured: silent,
        bound: { atMost: 0 },
        unit: "",
      },
    ];
  },
};

const broken = brokenDocuments.filter(
  ({ kind, text }) => kind === "link" && text !== "" && !/[\n\r\t]/.test(text),
);

function hostileLink(dice: Dice, n: number): string {
  const kinds = [
    () => encodeURI(broken[n % broken.length]?.text ?? "1"),
    () => forge(Array.from({ length: dice.between(1, 60) }, () => dice.between(0, 63))),
    () => forge(Array.from({ length: dice.between(400, 5_000) }, () => dice.pick([0, 1, 62, 63]))),
    () => "1".padEnd(dice.between(8_193, 200_000), "A"),
    () => encodeURIComponent(dice.pick(SCRIPTS)),
    () => named(dice.pick(SCRIPTS)),
  ];
  return kinds[n % kinds.length]?.() ?? "1";
}

/**
 * A link whose length and check are right, whatever stands in it: made by hand, not by Corridor.
 */
function forge(body: readonly number[]): string {
  const length = body.length % 64;
  return `1${textOf([length, ...checkOf(1, [length, ...body]), ...body])}`;
}

/** A right link to a maze with a wrong name. */
function named(name: string): string {
  const link = encodeLink({ maze: generateTree({ columns: 9, rows: 9, seed: 1, name }) });
  return link.ok ? link.text : "1";
}
