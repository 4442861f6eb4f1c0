import { quickstarts } from "@corridor/quickstarts";
import { describe, expect, it } from "vitest";
import { gatewayNames } from "@corridor/protocol";
import { withQuickstarts } from "./quickstart-blocks.ts";

const text = `# Page

<!-- tabs: Connect with -->

### curl

Save it.

<!-- quickstart: curl -->

### zeep (SOAP)

<!-- quickstart: soapPython -->

After it.

<!-- end of tabs -->

## Next
`;

describe("quickstarts in Markdown", () => {
  it("have the text of the page, with placeholders", () => {
    const robot = { origin: "http://HOST", id: "ID", key: "KEY", urlKey: "url_KEY" };
    const blocks = withQuickstarts(text, gatewayNames).split("```\n");
    expect(blocks[1]).toBe(quickstarts.curl.text(robot));
    expect(blocks[3]).toBe(quickstarts.soapPython.text(robot));
  });

  it("are not displayed for a gateway that is off", () => {
    const without = withQuickstarts(text, ["ros", "mcp"]);
    expect(without).not.toMatch(/zeep|After it/);
    expect(without).toMatch(/exit 1\n```\n\n<!-- end of tabs -->\n\n## Next\n$/);
  });

  it("leave other sections alone", () => {
    const other = "### One\n\n```sh\ncurl\n```\n\n### Two\n";
    expect(withQuickstarts(other, [])).toBe(other);
  });

  it("are not displayed under an unknown name", () => {
    expect(() => withQuickstarts("<!-- quickstart: fly -->", [])).toThrow("no quickstart fly");
  });
});
