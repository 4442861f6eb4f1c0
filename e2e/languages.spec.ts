// cspell:words Meins
/**
 * Texts fit in every language: nothing is cut off or overlaps, on the smallest phone and on a
 * desktop.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { unreadableTexts } from "./support/layout.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { languageTags, Texts } from "./support/texts.ts";
import { smallWindow } from "./support/window-sizes.ts";

const languages = languageTags().map((tag) => ({ name: tag, tag, texts: Texts.load(tag) }));
const pseudolocale = {
  name: "the pseudolocale, 40 % longer than English",
  tag: "de",
  texts: Texts.pseudolocale(),
};

/** Languages that share a page. The pseudolocale is loaded instead of German. */
const groups = [
  [pseudolocale, ...languages.filter(({ tag }) => ["en", "ar", "es"].includes(tag))],
  languages.filter(({ tag }) => !["en", "ar", "es"].includes(tag)),
];

const devices = [
  {
    device: "phones",
    isPhone: true,
    sizes: [
      { width: 390, height: 844 },
      { width: 320, height: 640 },
    ],
  },
  { device: "a desktop", isPhone: false, sizes: [{ width: 1024, height: 768 }] },
];

for (const group of groups) {
  for (const { device, isPhone, sizes } of devices) {
    const names = group.map(({ name }) => name).join(", ");
    test(`shows readable texts in ${names} on ${device}`, async ({ openWindow }) => {
      test.setTimeout(group.length * 120_000);
      const [viewport = null] = sizes;
      const window = await openWindow({
        viewport,
        hasTouch: isPhone,
        isMobile: isPhone,
        serviceWorkers: "block",
      });
      const { page } = window;
      if (group.includes(pseudolocale)) {
        await page.route("**/assets/de-*.js", (route) =>
          route.fulfill({ contentType: "text/javascript", body: pseudolocale.texts.asModule() }),
        );
      }
      const faults: string[] = [];
      for (const [at, language] of group.entries()) {
        const shown = group[at - 1];
        if (shown === undefined) await page.goto(`/?lang=${language.tag}`);
        else await chooseLanguage(page, shown.texts, language.tag);
        await page.getByRole("grid").waitFor();
        await expect(page.locator("html")).toHaveAttribute("lang", language.tag);
        const found = await faultsDuringVisit(page, language.texts, isPhone, sizes);
        faults.push(...found.map((fault) => `${language.name}: ${fault}`));
      }
      expect(faults).toEqual([]);
    });
  }
}

/**
 * Opens each menu, dialog and tab, and leaves the page as on the first visit.
 * @returns the texts that cannot be read in them
 */
async function faultsDuringVisit(
  page: Page,
  texts: Texts,
  isPhone: boolean,
  sizes: readonly { width: number; height: number }[],
): Promise<string[]> {
  const faults: string[] = [];
  let order = sizes;
  const checkTexts = async (state: string): Promise<void> => {
    for (const size of order) {
      if (page.viewportSize()?.width !== size.width) await page.setViewportSize(size);
      await waitForAnimations(page);
      const found = await unreadableTexts(page);
      faults.push(...found.map((fault) => `${state}, ${size.width} px: ${fault}`));
    }
    // The next state begins at the size of this one: a new size costs a layout of the page.
    order = order.toReversed();
  };
  const overlay = page.locator("dialog[open], :popover-open");
  const button = (path: string, values = {}) =>
    page.getByRole("button", { name: texts.t(path, values), exact: true });
  const checkOverlay = async (path: string, open: () => Promise<void>): Promise<void> => {
    await open();
    await overlay.first().waitFor();
    await checkTexts(path);
    await page.keyboard.press("Escape");
    await overlay.waitFor({ state: "detached" });
  };

  await checkTexts("first visit");
  const speed = page.getByRole("combobox", { name: texts.t("shell.run.speed") });
  await speed.selectOption("max");
  await page.locator('[aria-keyshortcuts="Control+Shift+Enter"]').click();
  await button("timeline.stepBack").waitFor();
  await checkTexts("after a step");
  await checkOverlay("share", () => button("share.share").click());
  await checkOverlay("stage.view", () => button("stage.view").click());
  await checkOverlay("program.algorithms", () => button("program.algorithms").click());
  if (isPhone) {
    for (const tab of ["drive", "presets", "program"]) {
      await page.getByRole("tab", { name: texts.t(`shell.tabs.${tab}`), exact: true }).click();
      await checkTexts(tab);
    }
    await checkOverlay("line", () => button("program.lineMenu", { line: 1 }).click());
    await checkOverlay("more", () => button("shell.more").click());
    await button("shell.more").click();
    await checkOverlay("keys", () => button("shell.keys.title").click());
    await button("shell.more").click();
    await checkOverlay("remote", () => button("drive.remote").click());
  } else {
    await checkOverlay("presets", () => button("presets.presets").click());
    await checkOverlay("keys", () => button("shell.keys.title").click());
    await checkOverlay("theme", () => button("theme.label").click());
    for (const change of ["stage.resize", "stage.clear"]) {
      await checkOverlay(change, async () => {
        await button("stage.view").click();
        await button(change).click();
      });
    }
    await page.getByRole("radio", { name: texts.t("drive.remote"), exact: true }).click();
    await checkTexts("remote");
    await page.locator("summary").click();
    await checkTexts("remote, more");
    await page.getByRole("radio", { name: texts.t("drive.program"), exact: true }).click();
  }
  const number = page.getByRole("textbox", { name: texts.t("program.numberOf", { line: 1 }) });
  const before = await number.inputValue();
  await number.fill("x");
  await checkTexts("bad number");
  await number.fill(before);
  await button("shell.run.reset").click();
  await speed.selectOption("1");
  return faults;
}

const german = Texts.load("de");
const english = Texts.load("en");

test("applies the language of the address, keeps it in a shared link, and switches to English without a reload", async ({
  openWindow,
}) => {
  const { page } = await openWindow(smallWindow);
  await page.goto("/?lang=de");
  await expect(page.locator("html")).toHaveAttribute("lang", "de");
  await expect(page).toHaveTitle(german.t("language.pageTitle"));
  const name = page.getByRole("textbox", { name: german.t("program.nameLabel") });
  await name.fill("Meins");
  await page.getByRole("button", { name: german.t("share.share"), exact: true }).click();
  await expect(page.getByRole("textbox", { name: german.t("share.link") })).toHaveValue(
    /\/\?lang=de#/,
  );
  await page.keyboard.press("Escape");

  // By keyboard: the menu opens on the current language, arrow keys move, Enter selects.
  const opener = page.getByRole("button", { name: `DE, ${german.t("language.language")}` });
  await opener.focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("menuitemradio", { name: "Deutsch" })).toBeFocused();
  await page.keyboard.press("Home");
  await expect(page.getByRole("menuitemradio", { name: "English" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
  // The shared link stays in the address: it is valid in English too.
  await expect(page).toHaveURL(/\/\?lang=en#.+/);
  await expect(page.getByRole("textbox", { name: english.t("program.nameLabel") })).toHaveValue(
    "Meins",
  );
  await expect(
    page.getByRole("button", { name: `EN, ${english.t("language.language")}` }),
  ).toBeFocused();

  // The choice is stored on the device and applies without a language in the address.
  await page.goto("/");
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
});

test("reports that a language is not available, or cannot be loaded, and keeps the current one", async ({
  openWindow,
}) => {
  const { page } = await openWindow({ ...smallWindow, serviceWorkers: "block" });
  // The live region contains the same texts.
  const messages = page.getByRole("region", { name: english.t("shell.messages") });
  await page.goto("/?lang=tlh");
  await messages.getByText(english.t("language.unknown", { tag: "tlh" })).waitFor();
  await expect(page).toHaveURL(/\/$/);

  // A network error would be a page error. A chunk that throws is reported in the same way.
  await page.route("**/assets/de-*.js", (route) =>
    route.fulfill({ contentType: "text/javascript", body: "throw new Error('cut off')" }),
  );
  await page.goto("/?lang=de");
  await messages.getByText(english.t("language.notLoaded", { language: "Deutsch" })).waitFor();
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
});

test("reports unreadable texts", async ({ page }) => {
  for (const { fault, html } of [
    { fault: "cut off: Reset", html: `<p style="overflow: hidden; width: 20px">Reset</p>` },
    {
      fault: "cut off below: two lines",
      html: `<p style="overflow: hidden; width: 40px; height: 20px">two lines</p>`,
    },
    {
      fault: "wider than its control: Reset",
      html: `<button style="width: 20px; padding: 0">Reset</button>`,
    },
    { fault: "off the screen: Reset", html: `<p style="position: fixed; left: -20px">Reset</p>` },
    {
      fault: "overlapping: one | two",
      html: `<p>one</p><p style="margin-top: -30px">two</p>`,
    },
    {
      fault: "cut off in a menu",
      html: `<select style="width: 40px"><option>delayed right 90</option></select>`,
    },
    { fault: "the page is", html: `<p style="width: 3000px">wide</p>` },
  ]) {
    await page.setContent(`<meta charset="utf-8" /><p>fine</p>${html}`);
    expect(await unreadableTexts(page), fault).toEqual([expect.stringContaining(fault)]);
  }
});

test("mirrors the page in Arabic, but neither the maze nor the robot's sides", async ({
  openWindow,
}) => {
  const window = await openWindow(smallWindow);
  await window.open();
  const { page } = window;
  const middle = smallWindow.viewport.width / 2;
  const panelCentre = async (): Promise<number> => {
    const box = await page.locator("aside").first().boundingBox();
    if (box === null) throw new Error("no panel");
    return box.x + box.width / 2;
  };
  const expectOrder = async (): Promise<void> => {
    const [left, , right] = ["A", "Space", "D"].map((key) =>
      page.locator("aside button", { hasText: new RegExp(`^${key}$`) }),
    );
    const leftBox = await left?.boundingBox();
    const rightBox = await right?.boundingBox();
    expect(leftBox?.x).toBeLessThan(rightBox?.x ?? 0);
    // The first column of the maze is the leftmost.
    const cells = page.getByRole("gridcell");
    const first = await cells.nth(0).boundingBox();
    const second = await cells.nth(1).boundingBox();
    expect(first?.x).toBeLessThan(second?.x ?? 0);
  };
  expect(await panelCentre()).toBeGreaterThan(middle);
  await expectOrder();
  await chooseLanguage(page, english, "ar");
  await expect(page.locator("html")).toHaveAttribute("dir", "rtl");
  await expect(page).toHaveTitle(Texts.load("ar").t("language.pageTitle"));
  // The panel changes sides. Inside the panel, left stays left of right.
  await expect.poll(panelCentre).toBeLessThan(middle);
  await expectOrder();
});

test("mirrors a dashboard in Arabic, but no letters that students type", async ({
  openWindow,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, ["Team 1"]);
  const { page } = await openWindow();
  await page.goto(teacher.address("?lang=ar"));
  const letters = `${teacher.code.slice(0, 3)} ${teacher.code.slice(3)}`;
  await expect(page.getByText(letters)).toHaveCSS("direction", "ltr");
  await expectNoAxeViolations(page, "Arabic dashboard without students");
  const student = await ScriptedStudent.join(relay, teacher.code);
  await page.locator("[data-student]").click();
  const sheet = page.getByRole("complementary");
  await expect(sheet).toBeVisible();
  expect((await sheet.boundingBox())?.x).toBe(0);
  // The name of the lesson is English, and begins where the Arabic page begins.
  const title = await page.getByRole("heading", { name: "Sensors" }).boundingBox();
  const card = await page.locator("li:has([data-student])").boundingBox();
  const rightOf = (box: typeof title) => (box === null ? 0 : box.x + box.width);
  expect(rightOf(title)).toBeCloseTo(rightOf(card), 0);
  await sheet.getByRole("button", { name: Texts.load("ar").t("dashboard.watch.return") }).click();
  await expect(sheet.getByText(/^[B-Z]{3} [B-Z]{3}$/)).toHaveCSS("direction", "ltr");
  await expectNoAxeViolations(page, "Arabic dashboard");
  const { id, screenKey } = teacher.created;
  await page.goto(`${relay}/class/${id}?lang=ar#${screenKey}`);
  await expect(page.locator("html")).toHaveAttribute("dir", "rtl");
  await expect(page.getByText(letters)).toHaveCSS("direction", "ltr");
  student.close();
});
