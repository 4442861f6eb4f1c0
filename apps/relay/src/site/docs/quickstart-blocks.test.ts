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
    const shown = withQuickstarts(text, gatewayNames);
    expect(shown).toContain(`\`\`\`#connect-curl\n${quickstarts.curl.text(robot)}\`\`\`\n`);
    const soap = quickstarts.soapPython.text(robot);
    expect(shown).toContain(`\`\`\`#connect-soapPython\n${soap}\`\`\`\n`);
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
