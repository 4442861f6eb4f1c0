import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { htmlOf } from "./markdown.ts";

describe("Markdown as HTML", () => {
  it.each([
    { text: "# Reading on", html: '<h2 id="reading-on">Reading on</h2>' },
    { text: "One\ntwo `a<b`.", html: "<p>One two <code>a&lt;b</code>.</p>" },
    {
      text: '```json\n{\n  "a<b": 1\n}\n```',
      html: '<pre tabindex="0"><code>{\n  &quot;a&lt;b&quot;: 1\n}</code></pre>',
    },
    { text: "- a\n  b\n- c\n  - d", html: "<ul><li>a b</li><li>c<ul><li>d</li></ul></li></ul>" },
    {
      text: "[on](#reading-on) and [maze](maze.md)",
      html: '<p><a href="#reading-on">on</a> and maze</p>',
    },
    {
      text: "<script>1</script> **so**",
      html: "<p>&lt;script&gt;1&lt;/script&gt; <strong>so</strong></p>",
    },
  ])("shows $text", ({ text, html }) => {
    expect(htmlOf(text)).toBe(html);
  });

  it("shows a table", () => {
    const html = htmlOf("| Call | Key |\n| ---- | --- |\n| `GET /` | none |");
    expect(html).toContain("<thead><tr><th>Call</th><th>Key</th></tr></thead>");
    expect(html).toContain("<tbody><tr><td><code>GET /</code></td><td>none</td></tr></tbody>");
  });

  it("understands all of the protocol", () => {
    const text = readFileSync(join(import.meta.dirname, "../../../../docs/protocol.md"), "utf8");
    const html = htmlOf(text);
    expect(html.replaceAll(/<code>.*?<\/code>/gs, "")).not.toMatch(/(?:\*\*|\]\(|<p>[|#-]|`)/);
    const links = [...html.matchAll(/href="#([^"]+)"/g)].map(([, id]) => id);
    expect(links.length).toBeGreaterThan(0);
    for (const id of links) expect(html).toContain(`id="${id}"`);
  });
});
