/**
 * Runs axe on a state of the page, in the light and the dark theme. Not with `AxeBuilder`, which
 * opens a page of its own and loads axe into both for each run: that covers frames of other sites.
 */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type axe from "axe-core";
import type { ElementContext, Result, RunOptions } from "axe-core";
import { expect, type Page } from "playwright/test";
import { waitForAnimations } from "./wait-for-animations.ts";

/** The minified source: a browser compiles it faster, and each new page compiles it. */
const axeSource = readFileSync(
  createRequire(import.meta.url).resolve("axe-core/axe.min.js"),
  "utf8",
);

/** All rules, and target size, which is off by default. */
export const allRules: RunOptions = { rules: { "target-size": { enabled: true } } };

/** Selectors of the parts of a page that axe checks. */
export interface PageParts {
  include?: string[];
  exclude: string[];
}

const wholePage: PageParts = { exclude: [] };
const modal = "dialog:modal";

/** For a page with the elements of another page, which stands for their colours. */
export const allButColours: RunOptions = {
  rules: { ...allRules.rules, "color-contrast": { enabled: false } },
};

/** The themes differ only in their colours. */
export const onlyColours = onlyRule("color-contrast");

export function onlyRule(rule: string): RunOptions {
  return { runOnly: { type: "rule", values: [rule] } };
}

/** The attribute of elements whose colours are to be checked. */
const NEW = "data-new-place";

/**
 * Checks all rules in the light theme, and colours in both themes. Colours are the most expensive
 * rule, so they are checked only where no earlier state of the same document at the same size had an
 * element: see `markNewPlaces`. Behind an open modal dialog they are not checked: nobody can use the
 * page there.
 * @param state names the state in the report
 */
export async function expectNoAxeViolations(page: Page, state: string): Promise<void> {
  await setTheme(page, "light");
  const isModal = (await page.locator(modal).count()) > 0;
  const hasNew = await markNewPlaces(page, isModal ? modal : "body");
  const onlyNew: PageParts = { include: [`[${NEW}]`], exclude: [] };
  const isAllNew = (await page.locator(`body[${NEW}]`).count()) > 0;
  const light = isAllNew
    ? await describeViolations(page, allRules)
    : [
        ...(await describeViolations(page, allButColours)),
        ...(hasNew ? await describeViolations(page, onlyColours, onlyNew) : []),
      ];
  expect(light, `axe, ${state}, light`).toEqual([]);
  if (!hasNew) return;
  await setTheme(page, "dark");
  const dark = await describeViolations(page, onlyColours, onlyNew);
  expect(dark, `axe, ${state}, dark`).toEqual([]);
}

/**
 * Marks an element of each place that had no element before, such as a pressed button in an open
 * dialog. The place determines the colours of an element: the names of the element and of all
 * elements around it, with their classes and states. Everything in a marked element is new.
 * @param within selector of the part to search
 * @returns whether there is a new place
 */
async function markNewPlaces(page: Page, within: string): Promise<boolean> {
  return page.evaluate(
    ([selector, mark]) => {
      // The document remembers the places, so that they end with it.
      const known = (document as unknown as { axePlaces?: Set<string> }).axePlaces ?? new Set();
      Reflect.set(document, "axePlaces", known);
      for (const marked of document.querySelectorAll(`[${mark}]`)) marked.removeAttribute(mark);
      const stateOf = (element: Element): string =>
        Array.from(element.attributes)
          .filter(
            ({ name }) =>
              /^(?:aria-|data-|class$|style$|type$|role$|fill$|stroke$)/.test(name) ||
              ["disabled", "hidden", "inert", "open", "readonly", "required"].includes(name),
          )
          .filter(({ name }) => !/^aria-(?:label|describe|controls|owns|value)/.test(name))
          .map(({ name, value }) => `${name}=${value}`)
          .join(" ");
      const pseudo = ["checked", "focus", "hover", "invalid", "placeholder-shown"];
      const nameOf = (element: Element): string => {
        const states = pseudo.filter((state) => element.matches(`:${state}`));
        return `${element.tagName} ${stateOf(element)} ${states.join(" ")}`;
      };
      let hasNew = false;
      const visit = (element: Element, around: string, isInNew: boolean): void => {
        const place = `${around} > ${nameOf(element)}`;
        const isNew = !known.has(place);
        known.add(place);
        if (isNew && !isInNew) element.setAttribute(mark, "");
        hasNew ||= isNew;
        for (const child of element.children) visit(child, place, isInNew || isNew);
      };
      // Contrast, language and direction belong to the root. Both themes are checked each time.
      const root = nameOf(document.documentElement).replace(/data-theme=\S*/, "");
      const around = `${innerWidth} x ${innerHeight} ${root}`;
      for (const part of document.querySelectorAll(selector)) visit(part, around, false);
      return hasNew;
    },
    [within, NEW] as const,
  );
}

/**
 * Violations in a page without frames.
 * @param parts where axe checks
 */
export async function axeViolations(
  page: Page,
  options: RunOptions,
  parts: PageParts = wholePage,
): Promise<Result[]> {
  expect(page.frames(), "axe covers pages without frames").toHaveLength(1);
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axeSource);
  return page.evaluate(
    async ([context, runOptions]) => {
      const { axe: loaded } = window as unknown as { axe: typeof axe };
      const { violations } = await loaded.run(context, runOptions);
      return violations;
    },
    [
      parts satisfies ElementContext,
      {
        ...options,
        // Otherwise axe also describes every element that passes.
        resultTypes: ["violations"],
        // Otherwise axe also reads all style sheets, for a rule that is off by default.
        preload: { assets: ["media"] },
      } satisfies RunOptions,
    ] as const,
  );
}

/** Sets the theme, and waits until all colour transitions have finished. */
async function setTheme(page: Page, colorScheme: "light" | "dark"): Promise<void> {
  await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
  await waitForAnimations(page);
}

async function describeViolations(
  page: Page,
  options: RunOptions,
  parts?: PageParts,
): Promise<string[]> {
  const violations = await axeViolations(page, options, parts);
  return violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}
