import { describe, expect, it } from "vitest";
import { frameMarkup } from "./embedded-frame.ts";

describe("the HTML of a frame", () => {
  it("shows an address in the given size", () => {
    const frame = { address: "https://a.example/embed/m/BCDF", title: "Spiral" };
    expect(frameMarkup({ ...frame, width: 720, height: 600 })).toBe(
      '<iframe src="https://a.example/embed/m/BCDF" title="Spiral" width="720" height="600" ' +
        'style="border:0;max-width:100%" loading="lazy" allow="clipboard-write; fullscreen"></iframe>',
    );
  });

  it.each(['"><script>alert(1)</script>', "&quot;", 'a" onload="b'])(
    "contains a name only as text: %s",
    (title) => {
      const html = frameMarkup({ address: "https://a.example/embed", title, width: 1, height: 1 });
      const [, found = ""] = /title="([^"]*)"/.exec(html) ?? [];
      expect(html.match(/[<>]/g)).toHaveLength(4);
      const decoded = found.replaceAll("&quot;", '"').replaceAll("&lt;", "<");
      expect(decoded.replaceAll("&gt;", ">").replaceAll("&amp;", "&")).toBe(title);
    },
  );
});
