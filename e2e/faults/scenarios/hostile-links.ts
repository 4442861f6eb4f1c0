/**
 * Hostile links in a real browser: each opens or is rejected with a message, and none of its
 * content is executed.
 */
import { encodeLink } from "@corridor/link";
import { brokenDocuments } from "@corridor/link/testing";
import { generateTree } from "@corridor/maze";
import { chromium } from "playwright";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { checkOf, textOf } from "../../../packages/link/src/digits.ts";
import { chromiumArguments, requireChromium } from "../../../scripts/chromium.ts";
import share from "../../../apps/web/src/text/en/share.json" with { type: "json" };
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import type { Scenario } from "../scenario.ts";

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

export const hostileLinks: Scenario = {
  title: "Hostile links",
  describe: (isLong) =>
    `Chromium opens ${isLong ? LINKS.long : LINKS.short} forged, broken and oversized links one by one, some with scripts in names`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const browser = await chromium.launch({
      executablePath: requireChromium(),
      args: [...chromiumArguments, "--enable-precise-memory-info"],
    });
    context.onCleanup(() => browser.close());
    const browserContext = await browser.newContext({ serviceWorkers: "block" });
    const page = await browserContext.newPage();
    await page.goto(relay.url);
    await page.getByText(/^Robot at /).waitFor();
    const messages = page.getByRole("region", { name: "Messages" });

    const count = context.isLong ? LINKS.long : LINKS.short;
    let rejected = 0;
    let opened = 0;
    let silent = 0;
    let longestMs = 0;
    let heapMib = 0;
    let ran = 0;
    for (let n = 0; n < count; n++) {
      const text = hostileLink(random, n);
      const startedAt = performance.now();
      await page.evaluate((hash) => (location.hash = hash), text);
      // The page clears the fragment after it has opened or rejected the link.
      await page.waitForFunction(() => location.hash === "", undefined, { timeout: 30_000 });
      await page.evaluate(
        () => new Promise((resolve) => requestAnimationFrame(() => resolve(null))),
      );
      longestMs = Math.max(longestMs, performance.now() - startedAt);
      const sentences = (await messages.count()) > 0 ? await messages.innerText() : "";
      if (REFUSALS.some((sentence) => sentences.includes(sentence))) rejected += 1;
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
    context.log(`${rejected} rejected, ${opened} opened as documents`);
    return [
      {
        label: "longest response time of the page",
        measured: longestMs,
        bound: { atMost: ANSWER_MS },
        unit: "ms",
      },
      { label: "memory of the page", measured: heapMib, bound: { atMost: HEAP_MIB }, unit: "MiB" },
      { label: "scripts that ran", measured: ran, bound: { atMost: 0 }, unit: "" },
      {
        label: "links rejected with a message",
        measured: rejected,
        bound: { atLeast: Math.floor(count / 3) },
        unit: `of ${count}`,
      },
      {
        label: "links that were neither rejected nor opened",
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

function hostileLink(random: SeededRandom, n: number): string {
  const kinds = [
    () => encodeURI(broken[n % broken.length]?.text ?? "1"),
    () => forge(Array.from({ length: random.between(1, 60) }, () => random.between(0, 63))),
    () =>
      forge(Array.from({ length: random.between(400, 5_000) }, () => random.pick([0, 1, 62, 63]))),
    () => "1".padEnd(random.between(8_193, 200_000), "A"),
    () => encodeURIComponent(random.pick(SCRIPTS)),
    () => named(random.pick(SCRIPTS)),
  ];
  return kinds[n % kinds.length]?.() ?? "1";
}

/** A link with a valid length and checksum around an arbitrary body. */
function forge(body: readonly number[]): string {
  const length = body.length % 64;
  return `1${textOf([length, ...checkOf(1, [length, ...body]), ...body])}`;
}

/** A valid link to a maze with a hostile name. */
function named(name: string): string {
  const link = encodeLink({ maze: generateTree({ columns: 9, rows: 9, seed: 1, name }) });
  return link.ok ? link.text : "1";
}
