import { describe, expect, it } from "vitest";
import { htmlOf } from "./markdown.ts";
import { htmlWithTabs } from "./tabs.ts";

describe("Markdown as HTML", () => {
  it.each([
    {
      text: "# Reading on, by `n`",
      html: '<h1 id="reading-on-by-n">Reading on, by <code>n</code></h1>',
    },
    {
      text: '```json\n{"a<b": 1}\n```',
      html: '<pre tabindex="0"><code>{&quot;a&lt;b&quot;: 1}</code></pre>',
    },
    { text: "```#call\n1\n```", html: '<pre id="call" tabindex="0"><code>1</code></pre>' },
    { text: "[on](#on)", html: '<p><a href="#on">on</a></p>' },
    { text: "<script>1</script>", html: "&lt;script&gt;1&lt;/script&gt;" },
  ])("renders $text", ({ text, html }) => {
    expect(htmlOf(text).trim()).toBe(html);
  });

  it("renders a table that the keyboard can scroll", () => {
    const html = htmlOf("| Call | Key |\n| ---- | --- |\n| `GET /` | none |");
    expect(html).toContain('<div class="table" tabindex="0"><table>');
    expect(html).toContain("<tbody><tr><td><code>GET /</code></td><td>none</td></tr></tbody>");
  });

  it("links to served files only", () => {
    const address = (href: string) => (href === "a.md" ? "/docs/a" : "");
    expect(htmlOf("[a](a.md) [b](b.md)", address)).toBe('<p><a href="/docs/a">a</a> b</p>\n');
  });

  it("renders the sections between the comments as tabs", () => {
    const text =
      "Before\n\n<!-- tabs: Language -->\n### A\n\na\n\n### B\n\nb\n<!-- end of tabs -->\n\nAfter";
    const html = htmlWithTabs(text);
    expect(html).toMatch(/Before.*<legend>Language.*checked.*>A<.*>B<.*<p>a.*<p>b.*After/s);
    expect(html).not.toContain("<!--");
  });
});
