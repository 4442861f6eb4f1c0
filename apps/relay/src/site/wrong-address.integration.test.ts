import { problemSchema } from "@corridor/protocol";
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { hardSentences } from "../../../web/src/text/testing/reading-level.ts";
import { startTestRelay } from "../testing/test-relay.ts";
import { wrongAddressTexts } from "./wrong-address-texts.ts";

const BROWSER = "text/html,application/xhtml+xml,application/xml;q=0.9,*/*;q=0.8";

describe("a wrong address", () => {
  it.each([
    { language: "en-GB,en;q=0.9", lang: "en", words: "This page does not exist" },
    { language: "de-AT,de;q=0.9,en;q=0.5", lang: "de", words: "Diese Seite gibt es nicht" },
    { language: "zh-TW", lang: "zh-Hans", words: "没有这个页面" },
    { language: "ar", lang: "ar", words: "هذه الصفحة غير موجودة" },
    { language: "tlh", lang: "en", words: "This page does not exist" },
  ])("is a page with a link home in the language of the browser: $language", async (example) => {
    const { language, lang, words } = example;
    const { origin } = await startTestRelay();
    for (const path of [
      "/foo",
      "/m/",
      "/r/",
      "/assets/none.js",
      "/apis",
      "/%3Cscript%3E",
      "/r/%E0",
      "/m/%FF",
    ]) {
      const headers = { accept: BROWSER, "accept-language": language };
      const answer = await fetch(origin + path, { headers });
      expect([path, answer.status]).toEqual([path, 404]);
      expect(answer.headers.get("content-type")).toBe("text/html; charset=utf-8");
      expect(answer.headers.get("vary")).toContain("Accept-Language");
      const html = await answer.text();
      expect(html).toContain(`<html lang="${lang}"`);
      expect(html).toContain(words);
      expect(html).toContain('href="/"');
      expect(html).not.toMatch(/<script|<style|style=/);
    }
  });

  it("leads to the documentation as well, below its addresses", async () => {
    const { origin } = await startTestRelay();
    for (const [path, isInDocs] of [
      ["/docs/none", true],
      ["/problems/none", true],
      ["/docks", false],
    ] as const) {
      const headers = { accept: BROWSER, "accept-language": "de" };
      const html = await (await fetch(origin + path, { headers })).text();
      expect([path, html.includes('href="/docs">Zur Dokumentation')]).toEqual([path, isInDocs]);
      expect(html).toContain('href="/"');
    }
  });

  it.each([
    { lang: "ja", words: "このページはありません" },
    { lang: "zh-Hans", words: "没有这个页面" },
  ])("uses the language $lang that was chosen on the page, also in its link", async (example) => {
    const { origin } = await startTestRelay();
    const headers = { accept: BROWSER, "accept-language": "en" };
    const html = await (await fetch(`${origin}/foo?lang=${example.lang}`, { headers })).text();
    expect(html).toContain(`<html lang="${example.lang}"`);
    expect(html).toContain(example.words);
    expect(html).toContain(`href="/?lang=${example.lang}"`);
  });

  it.each(["tlh", "toString", "ja&lang=de", '"><script>'])(
    "asks the browser where the address has no language of the page: %s",
    async (lang) => {
      const { origin } = await startTestRelay();
      const headers = { accept: BROWSER, "accept-language": "de" };
      const html = await (await fetch(`${origin}/foo?lang=${lang}`, { headers })).text();
      expect(html).toContain('<html lang="de"');
      expect(html).toContain('href="/"');
    },
  );

  it("is a problem document for API paths and for clients that do not accept HTML", async () => {
    const { origin } = await startTestRelay();
    for (const [path, accept] of [
      ["/api", BROWSER],
      ["/api/v1/foo", BROWSER],
      ["/api/v2/robots", BROWSER],
      ["/r/%E0", "application/json"],
      ["/foo", "*/*"],
      ["/foo", "application/json"],
    ] as const) {
      const answer = await fetch(origin + path, { headers: { accept } });
      expect(answer.headers.get("content-type")).toMatch(/^application\/problem\+json/);
      expect(problemSchema.parse(await answer.json())).toMatchObject({ status: 404 });
    }
    const sent = await fetch(`${origin}/foo`, { method: "POST", headers: { accept: BROWSER } });
    expect(sent.headers.get("content-type")).toMatch(/^application\/problem\+json/);
  });

  it("has texts of grade 6 or below in English", () => {
    expect(hardSentences(new Map(Object.entries(wrongAddressTexts.en)))).toEqual([]);
  });

  it("has the same texts on static hosts in all languages", () => {
    const file = new URL("../../../web/public/404.html", import.meta.url);
    const html = readFileSync(file, "utf8");
    for (const [lang, { title, text, home }] of Object.entries(wrongAddressTexts)) {
      expect(html).toContain(`<section lang="${lang}"`);
      for (const words of [title, text, home]) expect(html).toContain(words);
    }
  });
});
